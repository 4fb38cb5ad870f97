// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "surfmesh/assemble/orientation.hh"
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

/// All triangles of the result before they are linked.
struct TriangleSoup {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<CornerValue, 3>> corners;
  std::vector<std::array<int, 3>> contours;  ///< of the side from corner k to the next; -1 inside
  std::vector<int> patches;
  std::vector<Vec3> points;  ///< by vertex

  void reserve(std::size_t triangle_count) {
    triangles.reserve(triangle_count);
    corners.reserve(triangle_count);
    contours.reserve(triangle_count);
    patches.reserve(triangle_count);
    points.reserve(points.size() + triangle_count / 2);  // about as many as a closed mesh has
  }
};

class PatchCollector {
 public:
  PatchCollector(const PatchMesh& patch, int index, bool is_turned, TriangleSoup& soup)
      : patch_(patch),
        index_(index),
        is_turned_(is_turned),
        soup_(soup) {}

  void run() {
    number_vertices();
    const TriMesh& mesh = patch_.delaunay->mesh();
    for (std::size_t f = 0; f < patch_.delaunay->n_faces(); ++f) {
      add_face(mesh.halfedge_handle(FaceHandle(static_cast<int>(f))));
    }
    for (const PoleFan& fan : patch_.boundary.fans) add_fan(fan);
  }

 private:
  void number_vertices() {
    const DelaunayMesh& delaunay = *patch_.delaunay;
    vertices_ = boundary_vertices(patch_.boundary);
    for (const BoundaryLoop& loop : patch_.boundary.loops) {
      for (const BoundaryNode& node : loop) contours_.push_back(node.contour);
    }
    vertices_.resize(delaunay.n_vertices(), -1);
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (vertices_[v] >= 0) continue;
      vertices_[v] = static_cast<int>(soup_.points.size());
      soup_.points.push_back(patch_.points[v]);
    }
  }

  CornerValue value(std::size_t v) const {
    const VertexHandle vh(static_cast<int>(v));
    return {patch_.delaunay->uv(vh), patch_.delaunay->metric(vh)};
  }

  void add_face(HalfedgeHandle first) {
    const TriMesh& mesh = patch_.delaunay->mesh();
    std::array<std::size_t, 3> v{};
    std::array<int, 3> contours{};
    HalfedgeHandle heh = first;
    for (std::size_t k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
      v[k] = static_cast<std::size_t>(mesh.from_vertex_handle(heh).idx());
      contours[k] = mesh.is_boundary(mesh.opposite_halfedge_handle(heh)) ? contours_[v[k]] : -1;
    }
    std::array<int, 3> triangle{};
    std::array<CornerValue, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = vertices_[v[k]];
      corners[k] = value(v[k]);
    }
    add(triangle, corners, contours);
  }

  void add_fan(const PoleFan& fan) {
    const std::size_t count = fan.ring.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const auto near = static_cast<std::size_t>(fan.ring[i]);
      const auto far = static_cast<std::size_t>(fan.ring[i + 1]);
      const CornerValue first = value(near), second = value(far);
      // The metric is singular at the pole; its corner takes that of the ring.
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const CornerValue pole{point_on_pole(fan, share), mean(first.metric, second.metric)};
      const int from = i + 1 == count ? fan.contour_from : -1;
      const int to = i == 0 ? fan.contour_to : -1;
      add({fan.pole, vertices_[far], vertices_[near]}, {pole, second, first}, {from, -1, to});
    }
  }

  void add(std::array<int, 3> triangle, std::array<CornerValue, 3> corners,
           std::array<int, 3> contours) {
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      return;
    }
    if (is_turned_) {
      std::swap(triangle[1], triangle[2]);
      std::swap(corners[1], corners[2]);
      std::swap(contours[0], contours[2]);
    }
    soup_.triangles.push_back(triangle);
    soup_.corners.push_back(corners);
    soup_.contours.push_back(contours);
    soup_.patches.push_back(index_);
  }

  const PatchMesh& patch_;
  int index_;
  bool is_turned_;
  TriangleSoup& soup_;
  std::vector<int> vertices_;  ///< result vertex of each vertex of the domain mesh
  std::vector<int> contours_;  ///< of the segment after each boundary node
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
void drop_unused(TriangleSoup& soup) {
  std::vector<int> number(soup.points.size(), -1);
  for (const auto& triangle : soup.triangles) {
    for (const int v : triangle) number[static_cast<std::size_t>(v)] = 0;
  }
  int count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    soup.points[static_cast<std::size_t>(count)] = soup.points[v];
    number[v] = count++;
  }
  soup.points.resize(static_cast<std::size_t>(count));
  for (auto& triangle : soup.triangles) {
    for (int& v : triangle) v = number[static_cast<std::size_t>(v)];
  }
}

void write_properties(const TriangleSoup& soup, PolyMesh& mesh) {
  const auto patch = attach(mesh, keys::face_patch, -1);
  const auto contour = attach(mesh, keys::edge_contour, -1);
  const auto uv = attach(mesh, keys::corner_uv);
  const auto metric = attach(mesh, keys::corner_metric);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    mesh.property(patch, fh) = soup.patches[f];
    HalfedgeHandle heh = mesh.halfedge_handle(fh);
    for (std::size_t k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
      const CornerValue& tip = soup.corners[f][(k + 1) % 3];
      mesh.property(uv, heh) = tip.uv;
      mesh.property(metric, heh) = tip.metric;
      if (soup.contours[f][k] >= 0) {
        mesh.property(contour, mesh.edge_handle(heh)) = soup.contours[f][k];
      }
    }
  }
}

}  // namespace

Assembly assemble(const Model& model, const std::vector<ContourNodes>& nodes,
                  const NodeNumbers& numbers, const std::vector<PatchMesh>& patches) {
  const PatchOrientation orientation = orient_patches(model);
  TriangleSoup soup;
  soup.points = contour_points(model, nodes, numbers);
  std::size_t triangle_count = 0;
  for (const PatchMesh& patch : patches) triangle_count += patch.delaunay->n_faces();
  soup.reserve(triangle_count);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    PatchCollector(patches[p], static_cast<int>(p), orientation.is_turned[p] != 0, soup)
        .run();
  }
  drop_unused(soup);

  SeparatedFans separated = separate_fans(soup.points.size(), soup.triangles);
  Assembly result;
  if (separated.cut_edges > 0) {
    result.report.warnings.push_back(
        fmt::format("{} sides of triangles are left open where three or more patches meet, or "
                    "where the surface cannot be oriented",
                    separated.cut_edges));
  }
  soup.triangles = std::move(separated.triangles);
  build_triangles(result.mesh, separated.old_vertex.size(), soup.triangles);
  for (std::size_t v = 0; v < separated.old_vertex.size(); ++v) {
    result.mesh.set_point(VertexHandle(static_cast<int>(v)),
                          to_openmesh(soup.points[static_cast<std::size_t>(separated.old_vertex[v])]));
  }
  write_properties(soup, result.mesh);
  return result;
}

}  // namespace surfmesh
