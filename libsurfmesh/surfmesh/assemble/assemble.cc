// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// A corner of a triangle of the result, as its patch sees it.
struct CornerValue {
  Uv uv;
  Metric metric;
};

/// The vertices of a triangle, the corners of which they are, and its sides.
struct PatchTriangle {
  std::array<int, 3> vertices{};
  std::array<CornerValue, 3> corners;
  std::array<int, 3> contours{};  ///< of the side from corner k to the next; -1 inside
  /// Halfedges of the domain mesh, of the same sides; invalid in a pole's fan.
  std::array<HalfedgeHandle, 3> sides;

  bool is_collapsed() const {
    return vertices[0] == vertices[1] || vertices[1] == vertices[2] || vertices[2] == vertices[0];
  }

  void turn() {
    std::swap(vertices[1], vertices[2]);
    std::swap(corners[1], corners[2]);
    std::swap(contours[0], contours[2]);
    std::swap(sides[0], sides[2]);
  }
};

/// The triangles of one patch with vertices of the result, oriented like those of its neighbours.
class PatchTriangles {
 public:
  /// Adds the positions of the patch's own vertices.
  PatchTriangles(const PatchMesh& patch, bool is_turned, std::vector<Vec3>& points)
      : patch_(patch), is_turned_(is_turned) {
    vertices_ = boundary_vertices(patch_.boundary);
    for (const BoundaryLoop& loop : patch_.boundary.loops) {
      for (const BoundaryNode& node : loop) contours_.push_back(node.contour);
    }
    vertices_.resize(patch_.delaunay->n_vertices(), -1);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v] >= 0) continue;
      vertices_[v] = static_cast<int>(points.size());
      points.push_back(patch_.points[v]);
    }
  }

  std::size_t halfedge_count() const { return 2 * patch_.delaunay->n_edges(); }

  HalfedgeHandle opposite(HalfedgeHandle heh) const {
    return patch_.delaunay->mesh().opposite_halfedge_handle(heh);
  }

  /// Call `visit` for every triangle, always in the same order; triangles that collapse at a pole
  /// are left out.
  template <class Visit>
  void for_each(Visit visit) const {
    const auto visit_turned = [&](PatchTriangle triangle) {
      if (triangle.is_collapsed()) return;
      if (is_turned_) triangle.turn();
      visit(triangle);
    };
    const TriMesh& mesh = patch_.delaunay->mesh();
    for (std::size_t f = 0; f < patch_.delaunay->n_faces(); ++f) {
      visit_turned(triangle_at(mesh.halfedge_handle(FaceHandle(static_cast<int>(f)))));
    }
    for (const PoleFan& fan : patch_.boundary.fans) {
      for (std::size_t i = 0; i + 1 < fan.ring.size(); ++i) visit_turned(triangle_of(fan, i));
    }
  }

 private:
  CornerValue value(std::size_t v) const {
    const VertexHandle vh(static_cast<int>(v));
    return {patch_.delaunay->uv(vh), patch_.delaunay->metric(vh)};
  }

  PatchTriangle triangle_at(HalfedgeHandle heh) const {
    const TriMesh& mesh = patch_.delaunay->mesh();
    PatchTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
      const auto v = index(mesh.from_vertex_handle(heh));
      triangle.vertices[k] = vertices_[v];
      triangle.corners[k] = value(v);
      triangle.contours[k] =
          mesh.is_boundary(mesh.opposite_halfedge_handle(heh)) ? contours_[v] : -1;
      triangle.sides[k] = heh;
    }
    return triangle;
  }

  PatchTriangle triangle_of(const PoleFan& fan, std::size_t i) const {
    const std::size_t count = fan.ring.size() - 1;
    const auto near = static_cast<std::size_t>(fan.ring[i]);
    const auto far = static_cast<std::size_t>(fan.ring[i + 1]);
    const CornerValue first = value(near), second = value(far);
    // The metric is singular at the pole; its corner takes that of the ring.
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const CornerValue pole{point_on_pole(fan, share), mean(first.metric, second.metric)};
    const int from = i + 1 == count ? fan.contour_from : -1;
    const int to = i == 0 ? fan.contour_to : -1;
    PatchTriangle triangle;
    triangle.vertices = {fan.pole, vertices_[far], vertices_[near]};
    triangle.corners = {pole, second, first};
    triangle.contours = {from, -1, to};
    return triangle;
  }

  const PatchMesh& patch_;
  bool is_turned_;
  std::vector<int> vertices_;  ///< result vertex of each vertex of the domain mesh
  std::vector<int> contours_;  ///< of the segment after each boundary node
};

/// All triangles of the result before they are linked.
struct TriangleSoup {
  std::vector<std::array<int, 3>> triangles;
  /// Of each side the one it is glued to within its patch, -1 for none: see build_triangles.
  std::vector<int> twins;

  void reserve(std::size_t count) {
    triangles.reserve(count);
    twins.reserve(3 * count);
  }

  void add(const PatchTriangles& patch) {
    const std::size_t first = triangles.size();
    std::vector<int> side_of(patch.halfedge_count(), -1);
    std::vector<HalfedgeHandle> halfedges;
    halfedges.reserve(side_of.size());
    patch.for_each([&](const PatchTriangle& triangle) {
      for (std::size_t k = 0; k < 3; ++k) {
        halfedges.push_back(triangle.sides[k]);
        if (!triangle.sides[k].is_valid()) continue;
        side_of[index(triangle.sides[k])] = static_cast<int>(3 * triangles.size() + k);
      }
      triangles.push_back(triangle.vertices);
    });
    twins.resize(3 * triangles.size(), -1);
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      if (!halfedges[i].is_valid()) continue;
      twins[3 * first + i] = side_of[index(patch.opposite(halfedges[i]))];
    }
  }
};

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

/// Drop vertices that no triangle has (of cage faces without a surface).
void drop_unused(std::vector<Vec3>& points, std::vector<std::array<int, 3>>& triangles) {
  std::vector<char> is_used(points.size(), 0);
  for (const auto& triangle : triangles) {
    for (const int v : triangle) is_used[static_cast<std::size_t>(v)] = 1;
  }
  if (std::find(is_used.begin(), is_used.end(), 0) == is_used.end()) return;
  std::vector<int> number(points.size(), -1);
  int count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!is_used[v]) continue;
    points[static_cast<std::size_t>(count)] = points[v];
    number[v] = count++;
  }
  points.resize(static_cast<std::size_t>(count));
  for (auto& triangle : triangles) {
    for (int& v : triangle) v = number[static_cast<std::size_t>(v)];
  }
}

void set_points(const std::vector<Vec3>& points, const std::vector<int>& copied, PolyMesh& mesh) {
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) {
    const std::size_t from =
        v < points.size() ? v : static_cast<std::size_t>(copied[v - points.size()]);
    mesh.set_point(VertexHandle(static_cast<int>(v)), to_openmesh(points[from]));
  }
}

/// Writes the properties of faces, which are in the order of the triangles, their halfedges at the
/// sides from corner 0.
class PropertyWriter {
 public:
  explicit PropertyWriter(PolyMesh& mesh)
      : mesh_(mesh),
        patch_of_(attach(mesh, keys::face_patch, -1)),
        contour_(attach(mesh, keys::edge_contour, -1)),
        uv_(attach(mesh, keys::corner_uv)),
        metric_(attach(mesh, keys::corner_metric)) {}

  void write(FaceHandle fh, std::size_t patch, const PatchTriangle& triangle) {
    mesh_.property(patch_of_, fh) = static_cast<int>(patch);
    HalfedgeHandle heh = mesh_.halfedge_handle(fh);
    for (std::size_t k = 0; k < 3; ++k, heh = mesh_.next_halfedge_handle(heh)) {
      const CornerValue& tip = triangle.corners[(k + 1) % 3];
      mesh_.property(uv_, heh) = tip.uv;
      mesh_.property(metric_, heh) = tip.metric;
      if (triangle.contours[k] >= 0 && is_writer_of_edge(heh)) {
        mesh_.property(contour_, mesh_.edge_handle(heh)) = triangle.contours[k];
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
void write_properties(const std::vector<PatchTriangles>& patches,
                      const std::vector<std::size_t>& first_faces, PolyMesh& mesh) {
  PropertyWriter writer(mesh);
  share_indices(patches.size(), [&](std::size_t p) {
    auto face = static_cast<int>(first_faces[p]);
    patches[p].for_each(
        [&](const PatchTriangle& triangle) { writer.write(FaceHandle(face++), p, triangle); });
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
std::vector<std::string> warnings_of(const Model& model, const Separation& separation) {
  std::vector<std::string> warnings;
  if (separation.cut_edges > 0) {
    warnings.push_back(
        fmt::format("{} sides of triangles are left open where three or more patches meet, or "
                    "where the surface cannot be oriented",
                    separation.cut_edges));
  }
  if (const std::vector<int> touched = touched_vertices(model); !touched.empty()) {
    const Vec3& first = model.position(touched.front());
    warnings.push_back(
        fmt::format("vertices that are taken apart, as patches meet there in a point only: {}, the "
                    "first at {}",
                    touched.size(), place_text(first)));
  }
  return warnings;
}

}  // namespace

AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, const std::vector<PatchMesh>& patches) {
  const PatchOrientation orientation = orient_patches(model);
  std::vector<Vec3> points = contour_points(model, nodes, numbers);
  std::size_t triangle_count = 0;
  for (const PatchMesh& patch : patches) triangle_count += patch.delaunay->n_faces();
  points.reserve(points.size() + triangle_count / 2);  // about as many as a closed mesh has
  TriangleSoup soup;
  soup.reserve(triangle_count);
  std::vector<PatchTriangles> triangles;
  triangles.reserve(patches.size());
  std::vector<std::size_t> first_faces;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    triangles.emplace_back(patches[p], orientation.is_turned[p] != 0, points);
    first_faces.push_back(soup.triangles.size());
    soup.add(triangles.back());
  }
  drop_unused(points, soup.triangles);

  const Separation separation =
      build_triangles(mesh, points.size(), soup.triangles, std::span<const int>(soup.twins));
  set_points(points, separation.copied, mesh);
  write_properties(triangles, first_faces, mesh);
  return {warnings_of(model, separation)};
}

}  // namespace surfmesh
