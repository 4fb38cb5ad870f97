// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/model/joined_uses.hh"

namespace surfmesh {
namespace {

/// Corners of a face of a patch: triangles and quads.
constexpr std::size_t kMostCorners = 4;

/// What a corner of the result holds, as its patch sees it.
struct CornerValue {
  Uv uv;
  Metric metric;
};

/// A corner of a face, and the side from it to the next corner.
struct FaceCorner {
  int vertex = -1;         ///< of the result
  int domain_vertex = -1;  ///< of the patch's mesh; -1 for a pole
  int contour = -1;        ///< of the side; -1 inside
  HalfedgeHandle side;     ///< of the patch's mesh; invalid in a pole's fan
};

/// A face of a patch with vertices of the result.
struct PatchFace {
  std::array<FaceCorner, kMostCorners> corners;
  std::size_t count = 0;
  CornerValue pole;  ///< of the corner that is a pole

  /// Leave out corners that are the same vertex as the next one: of a side that is a pole.
  void drop_collapsed_corners() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (corners[k].vertex != corners[k + 1 == count ? 0 : k + 1].vertex)
        corners[kept++] = corners[k];
    }
    count = kept;
  }

  /// Go around the other way, from the same corner on.
  void turn() {
    const auto before = corners;
    for (std::size_t k = 0; k < count; ++k) {
      const FaceCorner& corner = before[(count - k) % count];
      const FaceCorner& side = before[count - 1 - k];
      corners[k] = {corner.vertex, corner.domain_vertex, side.contour, side.side};
    }
  }
};

/// The faces of one patch with vertices of the result, oriented like those of its neighbours.
class PatchFaces {
 public:
  /// Sets the positions of the patch's vertices between tiles, which have numbers from
  /// `contour_count` on, and adds those of its own vertices.
  PatchFaces(const PatchMesh& patch, bool is_turned, int contour_count, std::vector<Vec3>& points)
      : patch_(patch),
        mesh_(*patch.mesh),
        uv_(require(mesh_, keys::vertex_uv)),
        metric_(require(mesh_, keys::vertex_metric)),
        contour_(require(mesh_, keys::edge_contour)),
        is_turned_(is_turned) {
    vertices_ = boundary_vertices(patch_.boundary);
    vertices_.resize(mesh_.n_vertices(), -1);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      const Vec3 point = to_eigen(mesh_.point(VertexHandle(static_cast<int>(v))));
      if (vertices_[v] >= contour_count) points[static_cast<std::size_t>(vertices_[v])] = point;
      if (vertices_[v] >= 0) continue;
      vertices_[v] = static_cast<int>(points.size());
      points.push_back(point);
    }
  }

  int patch() const { return patch_.boundary.patch; }

  std::size_t halfedge_count() const { return mesh_.n_halfedges(); }

  HalfedgeHandle opposite(HalfedgeHandle heh) const { return mesh_.opposite_halfedge_handle(heh); }

  /// Call `visit` for every face, always in the same order; triangles that collapse at a pole are
  /// left out, quads become triangles.
  template <class Visit>
  void for_each(Visit visit) const {
    PatchFace face;  // one for all: there are millions
    const auto visit_turned = [&] {
      face.drop_collapsed_corners();
      if (face.count < 3) return;
      if (is_turned_) face.turn();
      visit(static_cast<const PatchFace&>(face));
    };
    for (const FaceHandle fh : mesh_.faces()) {
      fill(mesh_.halfedge_handle(fh), face);
      visit_turned();
    }
    for (const PoleFan& fan : patch_.boundary.fans) {
      const auto step = static_cast<std::size_t>(fan.segments_per_face);
      for (std::size_t i = 0; i + step < fan.ring.size(); i += step) {
        fill_from_fan(fan, i, face);
        visit_turned();
      }
    }
  }

  CornerValue value(const PatchFace& face, std::size_t corner) const {
    const int v = face.corners[corner].domain_vertex;
    return v < 0 ? face.pole : value(v);
  }

 private:
  CornerValue value(int domain_vertex) const {
    const VertexHandle vh(domain_vertex);
    return {mesh_.property(uv_, vh), mesh_.property(metric_, vh)};
  }

  void fill(HalfedgeHandle start, PatchFace& face) const {
    face.count = 0;
    HalfedgeHandle heh = start;
    do {
      if (face.count == kMostCorners) {
        throw Error(ErrorCode::InvalidInput, "a face of a patch has more than four corners");
      }
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      face.corners[face.count++] = {vertices_[index(vh)], vh.idx(),
                                    mesh_.property(contour_, mesh_.edge_handle(heh)), heh};
      heh = mesh_.next_halfedge_handle(heh);
    } while (heh != start);
  }

  void fill_from_fan(const PoleFan& fan, std::size_t i, PatchFace& face) const {
    const std::size_t count = fan.ring.size() - 1;
    const auto step = static_cast<std::size_t>(fan.segments_per_face);
    const int near = fan.ring[i], far = fan.ring[i + step];
    // The metric is singular at the pole; its corner takes that of the ring.
    const double share =
        (static_cast<double>(i) + 0.5 * static_cast<double>(step)) / static_cast<double>(count);
    face.pole = {point_on_pole(fan, share), mean(value(near).metric, value(far).metric)};
    const HalfedgeHandle none;
    face.corners[0] = {fan.pole, -1, i + step == count ? fan.contour_from : -1, none};
    for (std::size_t k = 0; k <= step; ++k) {
      const int node = fan.ring[i + step - k];
      face.corners[k + 1] = {vertices_[static_cast<std::size_t>(node)], node, -1, none};
    }
    face.count = step + 2;
    if (i == 0) face.corners[face.count - 1].contour = fan.contour_to;
  }

  const PatchMesh& patch_;
  const PolyMesh& mesh_;
  decltype(keys::vertex_uv)::Handle uv_;
  decltype(keys::vertex_metric)::Handle metric_;
  decltype(keys::edge_contour)::Handle contour_;
  bool is_turned_;
  std::vector<int> vertices_;  ///< result vertex of each vertex of the patch's mesh
};

/// A side of a face on a contour where more than two patches meet.
struct SharedSide {
  int contour = -1;
  int patch = -1;
  std::array<int, 2> vertices = {-1, -1};  ///< ascending
  int side = -1;                           ///< of the soup
};

/// All faces of the result before they are linked.
struct FaceSoup {
  const Model& model;
  FaceList faces;
  /// Of each side the one it is glued to within its patch, -1 for none: see build_faces.
  std::vector<int> twins = {};
  std::vector<SharedSide> shared = {};

  void reserve(std::size_t face_count, std::size_t corner_count) {
    faces.reserve(face_count, corner_count);
    twins.reserve(corner_count);
  }

  void add(const PatchFaces& patch) {
    const std::size_t first = faces.corner_count();
    std::vector<int> side_of(patch.halfedge_count(), -1);
    std::vector<HalfedgeHandle> halfedges;
    halfedges.reserve(side_of.size());
    patch.for_each([&](const PatchFace& face) {
      std::array<int, kMostCorners> vertices{};
      for (std::size_t k = 0; k < face.count; ++k) {
        const HalfedgeHandle side = face.corners[k].side;
        vertices[k] = face.corners[k].vertex;
        halfedges.push_back(side);
        if (side.is_valid()) side_of[index(side)] = static_cast<int>(faces.corner_count() + k);
        const int contour = face.corners[k].contour;
        if (contour < 0 || model.contour(contour).uses.size() < 3) continue;
        const auto [a, b] = std::minmax(face.corners[k].vertex,
                                        face.corners[k + 1 == face.count ? 0 : k + 1].vertex);
        shared.push_back(
            {contour, patch.patch(), {a, b}, static_cast<int>(faces.corner_count() + k)});
      }
      faces.add(std::span(vertices).first(face.count));
    });
    twins.resize(faces.corner_count(), -1);
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      if (!halfedges[i].is_valid()) continue;
      twins[first + i] = side_of[index(patch.opposite(halfedges[i]))];
    }
  }
};

/// Glue sides on contours where more than two patches meet, as joined_uses has their patches.
void join_shared_sides(const Model& model, const std::vector<int>& cut_contours, FaceSoup& soup) {
  if (soup.shared.empty()) return;
  auto joined = joined_uses(model);
  for (const int c : cut_contours) joined[static_cast<std::size_t>(c)].clear();
  std::map<std::tuple<int, int, std::array<int, 2>>, int> side_of;
  for (const SharedSide& shared : soup.shared) {
    side_of[{shared.contour, shared.patch, shared.vertices}] = shared.side;
  }
  for (const SharedSide& shared : soup.shared) {
    const Contour& contour = model.contour(shared.contour);
    for (const UsePair& pair : joined[static_cast<std::size_t>(shared.contour)]) {
      const int a = contour.uses[static_cast<std::size_t>(pair[0])].patch;
      const int b = contour.uses[static_cast<std::size_t>(pair[1])].patch;
      if (shared.patch != a && shared.patch != b) continue;
      const auto other = side_of.find({shared.contour, shared.patch == a ? b : a, shared.vertices});
      if (other != side_of.end()) soup.twins[static_cast<std::size_t>(shared.side)] = other->second;
    }
  }
}

std::vector<Vec3> contour_points(const Model& model, const std::vector<ContourNodes>& nodes,
                                 const NodeNumbers& numbers) {
  std::vector<Vec3> points(static_cast<std::size_t>(numbers.count()));
  for (std::size_t v = 0; v < model.vertices.size(); ++v) points[v] = model.vertices[v].position;
  for (std::size_t c = 0; c < nodes.size(); ++c) {
    for (int i = 1; i < nodes[c].segment_count(); ++i) {
      points[static_cast<std::size_t>(numbers(static_cast<int>(c), i))] =
          nodes[c].points[static_cast<std::size_t>(i)];
    }
  }
  return points;
}

/// Drop vertices that no face has (of cage faces without a surface).
void drop_unused(std::vector<Vec3>& points, FaceList& faces) {
  std::vector<char> is_used(points.size(), 0);
  for (const int v : faces.vertices()) is_used[static_cast<std::size_t>(v)] = 1;
  if (std::find(is_used.begin(), is_used.end(), 0) == is_used.end()) return;
  std::vector<int> number(points.size(), -1);
  int count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!is_used[v]) continue;
    points[static_cast<std::size_t>(count)] = points[v];
    number[v] = count++;
  }
  points.resize(static_cast<std::size_t>(count));
  for (int& v : faces.vertices()) v = number[static_cast<std::size_t>(v)];
}

void set_points(const std::vector<Vec3>& points, const std::vector<int>& copied, PolyMesh& mesh) {
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const std::size_t from =
        v < points.size() ? v : static_cast<std::size_t>(copied[v - points.size()]);
    mesh.set_point(VertexHandle(static_cast<int>(v)), to_openmesh(points[from]));
  }
}

/// Writes the properties of faces, which are in the order of the soup, their halfedges at the sides
/// from corner 0.
class PropertyWriter {
 public:
  explicit PropertyWriter(PolyMesh& mesh)
      : mesh_(mesh),
        patch_of_(attach(mesh, keys::face_patch, -1)),
        contour_(attach(mesh, keys::edge_contour, -1)),
        uv_(attach(mesh, keys::corner_uv)),
        metric_(attach(mesh, keys::corner_metric)) {}

  void write(FaceHandle fh, const PatchFaces& faces, const PatchFace& face) {
    mesh_.property(patch_of_, fh) = faces.patch();
    HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    for (std::size_t k = 0; k < face.count; ++k, heh = mesh_.next_halfedge_handle(heh)) {
      const CornerValue tip = faces.value(face, k + 1 == face.count ? 0 : k + 1);
      mesh_.property(uv_, heh) = tip.uv;
      mesh_.property(metric_, heh) = tip.metric;
      if (face.corners[k].contour >= 0 && is_writer_of_edge(heh)) {
        mesh_.property(contour_, mesh_.edge_handle(heh)) = face.corners[k].contour;
      }
    }
  }

 private:
  /// Of two patches, which may be worked on at once, one writes to their common edge.
  bool is_writer_of_edge(HalfedgeHandle heh) const {
    const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(heh);
    return mesh_.is_boundary(opposite) || heh < opposite;
  }

  PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::edge_contour)::Handle contour_;
  decltype(keys::corner_uv)::Handle uv_;
  decltype(keys::corner_metric)::Handle metric_;
};

/// `first_faces` are those of the patches.
void write_properties(const std::vector<PatchFaces>& patches,
                      const std::vector<std::size_t>& first_faces, PolyMesh& mesh) {
  PropertyWriter writer(mesh);
  share_indices(patches.size(), [&](std::size_t p) {
    auto face = static_cast<int>(first_faces[p]);
    patches[p].for_each(
        [&](const PatchFace& f) { writer.write(FaceHandle(face++), patches[p], f); });
  });
}

/// Vertices of the model at which patches meet in nothing but this point, so that the mesh has
/// several there although no contour is cut.
std::vector<int> touched_vertices(const Model& model) {
  const PromisedTopology promise = promised_topology(model);
  std::vector<char> is_touched = promise.is_split;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (promise.is_open[c] == 0 || contour.uses.size() < 2) continue;
    for (const int end : {contour.start, contour.end}) {
      is_touched[static_cast<std::size_t>(end)] = 0;
    }
  }
  std::vector<int> result;
  for (std::size_t v = 0; v < is_touched.size(); ++v) {
    if (is_touched[v] != 0) result.push_back(static_cast<int>(v));
  }
  return result;
}

/// What the mesh is other than the model, for a half-edge mesh cannot be so.
Notices notices_of(const Model& model, const Separation& separation) {
  Notices notices;
  if (separation.cut_edges > 0) {
    notices.push_back(warning(
        NoticeKind::CutEdges,
        fmt::format("{} sides of faces are left open where three or more patches meet, or where "
                    "the surface cannot be oriented",
                    separation.cut_edges)));
  }
  if (const std::vector<int> touched = touched_vertices(model); !touched.empty()) {
    const Vec3& first = model.position(touched.front());
    notices.push_back(warning(
        NoticeKind::SplitVertices,
        fmt::format("vertices that are taken apart, as patches meet there in a point only: {}, the "
                    "first at {}",
                    touched.size(), point_text(first))));
    notices.back().point = first;
  }
  return notices;
}

}  // namespace

AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, const std::vector<PatchMesh>& patches,
                        const RunContext& context) {
  const PatchOrientation orientation = orient_patches(model);
  std::vector<Vec3> points = contour_points(model, nodes, numbers);
  std::size_t face_count = 0, corner_count = 0;
  for (const PatchMesh& patch : patches) {
    face_count += patch.mesh->n_faces();
    corner_count += patch.mesh->n_halfedges();
  }
  points.reserve(points.size() + corner_count / 6);  // about as many as a closed mesh has
  FaceSoup soup{model, {}};
  soup.reserve(face_count, corner_count);
  std::vector<PatchFaces> faces;
  faces.reserve(patches.size());
  std::vector<std::size_t> first_faces;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    context.throw_if_cancelled();
    const PatchMesh& patch = patches[p];
    faces.emplace_back(patch, orientation.is_turned[patch.patch()] != 0, numbers.contour_count(),
                       points);
    first_faces.push_back(soup.faces.size());
    soup.add(faces.back());
  }
  join_shared_sides(model, orientation.cut_contours, soup);
  drop_unused(points, soup.faces);
  context.throw_if_cancelled();

  const Separation separation =
      build_faces(mesh, points.size(), soup.faces, FirstSide::FromFirstCorner, soup.twins);
  context.throw_if_cancelled();
  set_points(points, separation.copied, mesh);
  write_properties(faces, first_faces, mesh);
  return {notices_of(model, separation)};
}

}  // namespace surfmesh
