// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/sag_corrections.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "surfmesh/quality/surface_search.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh::detail {
namespace {

constexpr int kMostRounds = 8;

/// Beside half of the triangles of a patch, so many may be corrected.
constexpr std::size_t kFreeFaces = 20;

/// Shape (1 for an equilateral triangle) below which a swap or a node must not lead, unless it was
/// worse before.
constexpr double kLeastShape = 0.3;

/// Shape below which no node must lead at all.
constexpr double kLeastSplitShape = 0.2;

/// Ratio of the sags after and before from which a node is worth it.
constexpr double kLeastReduction = 0.99;

/// Share of the sag from which its greatest value in a triangle is searched for beyond samples.
constexpr double kSearchedShare = 0.5;

/// Least gain of shape for which an edge is swapped or a node moved.
constexpr double kLeastGain = 0.01;

/// Nodes whose triangles all have this shape stay where they are.
constexpr double kGoodShape = 0.6;

/// A vertex, or a place where one might be.
struct Corner {
  Uv uv;
  Vec3 point;
  Vec3 normal;  ///< of any length
};

using Triangle = std::array<Corner, 3>;

/// 2√3 · double area / Σ squared sides: 1 for an equilateral triangle; negative for one that is
/// turned against the normals of the surface.
double shape_of(const Triangle& t) {
  const auto& [a, b, c] = t;
  const Vec3 normal = (b.point - a.point).cross(c.point - a.point);
  const double squares = (b.point - a.point).squaredNorm() + (c.point - b.point).squaredNorm() +
                         (a.point - c.point).squaredNorm();
  const double shape = squares > 0 ? 2 * std::numbers::sqrt3 * normal.norm() / squares : 0;
  return normal.dot(a.normal + b.normal + c.normal) > 0 ? shape : -shape;
}

double shape_of(const std::vector<Triangle>& triangles) {
  double shape = 1;
  for (const Triangle& t : triangles) shape = std::min(shape, shape_of(t));
  return shape;
}

/// True if the triangle has the edge from one of these parameters to the other.
bool has_edge(const Triangle& t, Uv from, Uv to) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k].uv == from && t[(k + 1) % 3].uv == to) return true;
  }
  return false;
}

double distance(const Vec3& point, const Triangle& t) {
  return triangle_distance(point, {t[0].point, t[1].point, t[2].point}).distance;
}

/// An inner edge and the apexes of its two triangles.
struct Diamond {
  Corner origin, right, tip, left;

  std::vector<Triangle> triangles() const { return {{origin, tip, left}, {tip, origin, right}}; }
  std::vector<Triangle> swapped() const { return {{right, tip, left}, {left, origin, right}}; }
  std::vector<Triangle> split_at(const Corner& middle) const {
    return {
        {origin, middle, left}, {middle, tip, left}, {tip, middle, right}, {middle, origin, right}};
  }
};

/// Corrects the triangles of one patch.
class SagCorrector {
 public:
  SagCorrector(PatchMesh& patch, double aim)
      : patch_(patch), delaunay_(*patch.delaunay), aim_(aim) {}

  SagCorrections run() {
    boundary_count_ = boundary_vertices(patch_.boundary).size();
    measure_new_faces();
    const std::size_t limit = kFreeFaces + delaunay_.n_faces() / 2;
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<FaceHandle> far = far_faces();
      // Where most triangles are too far the sizes are to blame, or hmin is in the way.
      if (far.empty() || far.size() > limit || result_.nodes > limit) break;
      const SagCorrections before = result_;
      for (const FaceHandle fh : far) correct(fh);
      if (result_.swaps == before.swaps && result_.nodes == before.nodes) break;
    }
    return result_;
  }

 private:
  const TriMesh& mesh() const { return delaunay_.mesh(); }

  Corner corner(VertexHandle vh) const {
    const auto v = index(vh);
    return {delaunay_.uv(vh), patch_.points[v], patch_.normals[v]};
  }

  Corner corner_at(Uv uv) const {
    const Jet jet = patch_.surface->evaluate(uv, Order::First);
    return {uv, jet.point, jet.du.cross(jet.dv)};
  }

  // --- sag ---

  double& sag(FaceHandle fh) { return sags_[index(fh)]; }

  double sag_of(const Triangle& t) const {
    return plane_sag(*patch_.surface,
                     {{t[0].point, t[1].point, t[2].point}, {t[0].uv, t[1].uv, t[2].uv}},
                     kSearchedShare * aim_);
  }

  double sag_of(const std::vector<Triangle>& triangles) const {
    double sag = ridge_sag(triangles);
    for (const Triangle& t : triangles) sag = std::max(sag, sag_of(t));
    return sag;
  }

  /// The greatest distance between the surface and the middles of the edges between some triangles,
  /// both ways: over a sharp bend the planes of the two triangles pass nearer than their edge.
  double ridge_sag(const std::vector<Triangle>& triangles) const {
    double sag = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner &a = triangles[i][k], &b = triangles[i][(k + 1) % 3];
        for (std::size_t j = 0; j < i; ++j) {
          if (has_edge(triangles[j], b.uv, a.uv)) {
            sag = std::max(sag, ridge_sag(a, b, triangles[i], triangles[j]));
          }
        }
      }
    }
    return sag;
  }

  double ridge_sag(const Corner& a, const Corner& b, const Triangle& left,
                   const Triangle& right) const {
    const Uv middle = lerp(a.uv, b.uv, 0.5);
    const Vec3 on_surface = patch_.surface->evaluate(middle, Order::Position).point;
    const Vec3 on_edge = 0.5 * (a.point + b.point);
    const double from_mesh = std::min(distance(on_surface, left), distance(on_surface, right));
    if ((on_surface - on_edge).norm() <= aim_) return from_mesh;
    return std::max(from_mesh, find_near_point(*patch_.surface, on_edge, middle).distance);
  }

  double sag_now(FaceHandle fh) const {
    const TriangleVertices v = vertices(mesh(), fh);
    double sag = sag_of(Triangle{corner(v[0]), corner(v[1]), corner(v[2])});
    for (const EdgeHandle eh : inner_edges(fh)) {
      sag = std::max(sag, ridge_sag(around(eh).triangles()));
    }
    return sag;
  }

  void measure_new_faces() {
    while (sags_.size() < delaunay_.n_faces()) {
      sags_.push_back(sag_now(FaceHandle(static_cast<int>(sags_.size()))));
    }
  }

  std::vector<FaceHandle> far_faces() const {
    std::vector<FaceHandle> faces;
    for (std::size_t f = 0; f < sags_.size(); ++f) {
      if (sags_[f] > aim_) faces.emplace_back(static_cast<int>(f));
    }
    return faces;
  }

  // --- edges ---

  bool is_inner(EdgeHandle eh) const {
    return !delaunay_.is_constrained(eh) && !mesh().is_boundary(mesh().halfedge_handle(eh, 0)) &&
           !mesh().is_boundary(mesh().halfedge_handle(eh, 1));
  }

  std::vector<EdgeHandle> inner_edges(FaceHandle fh) const {
    std::vector<EdgeHandle> edges;
    HalfedgeHandle heh = mesh().halfedge_handle(fh);
    for (int k = 0; k < 3; ++k, heh = mesh().next_halfedge_handle(heh)) {
      if (is_inner(mesh().edge_handle(heh))) edges.push_back(mesh().edge_handle(heh));
    }
    return edges;
  }

  Diamond around(EdgeHandle eh) const {
    const HalfedgeHandle a = mesh().halfedge_handle(eh, 0), b = mesh().halfedge_handle(eh, 1);
    return {corner(mesh().to_vertex_handle(b)),
            corner(mesh().to_vertex_handle(mesh().next_halfedge_handle(b))),
            corner(mesh().to_vertex_handle(a)),
            corner(mesh().to_vertex_handle(mesh().next_halfedge_handle(a)))};
  }

  void flip(EdgeHandle eh) {
    delaunay_.flip(eh);
    for (const unsigned int side : {0u, 1u}) {
      const FaceHandle fh = mesh().face_handle(mesh().halfedge_handle(eh, side));
      sag(fh) = sag_now(fh);
    }
    ++result_.swaps;
  }

  // --- corrections ---

  void correct(FaceHandle fh) {
    if (sag(fh) <= aim_) return;
    const std::vector<EdgeHandle> edges = inner_edges(fh);
    const bool is_swapped =
        std::any_of(edges.begin(), edges.end(), [this](EdgeHandle eh) { return swap_for_sag(eh); });
    if (!is_swapped) split_longest(edges);
  }

  /// Swap the edge if both new triangles are near enough and no worse in shape than is allowed.
  bool swap_for_sag(EdgeHandle eh) {
    if (!delaunay_.can_flip(eh)) return false;
    const Diamond diamond = around(eh);
    const double shape = shape_of(diamond.swapped());
    if (shape < kLeastShape && shape < shape_of(diamond.triangles())) return false;
    if (sag_of(diamond.swapped()) > aim_) return false;
    flip(eh);
    return true;
  }

  void swap_for_shape(EdgeHandle eh) {
    if (!is_inner(eh) || !delaunay_.can_flip(eh)) return;
    const Diamond diamond = around(eh);
    if (shape_of(diamond.swapped()) < shape_of(diamond.triangles()) + kLeastGain) return;
    if (sag_of(diamond.swapped()) > std::max(aim_, sag_of(diamond.triangles()))) return;
    flip(eh);
  }

  /// Give a node to the middle of the longest edge where that helps; without one the sizes are to
  /// blame.
  void split_longest(std::vector<EdgeHandle> edges) {
    std::sort(edges.begin(), edges.end(),
              [this](EdgeHandle a, EdgeHandle b) { return squared_length(a) > squared_length(b); });
    for (const EdgeHandle eh : edges) {
      if (!helps_to_split(eh) || !split_chord(patch_, eh)) continue;
      tidy_new_node();
      return;
    }
  }

  double squared_length(EdgeHandle eh) const {
    const Diamond diamond = around(eh);
    return (diamond.tip.point - diamond.origin.point).squaredNorm();
  }

  /// True if a node in the middle brings the triangles nearer to the surface and leaves no slivers:
  /// these are never near, for their planes stand across the surface.
  bool helps_to_split(EdgeHandle eh) const {
    const Diamond diamond = around(eh);
    const auto after = diamond.split_at(corner_at(lerp(diamond.origin.uv, diamond.tip.uv, 0.5)));
    return shape_of(after) >= kLeastSplitShape &&
           sag_of(after) <= std::max(aim_, kLeastReduction * sag_of(diamond.triangles()));
  }

  /// Measure the triangles of the last node, and make them better.
  void tidy_new_node() {
    ++result_.nodes;
    evaluate_vertices(patch_);
    const VertexHandle vh(static_cast<int>(delaunay_.n_vertices()) - 1);
    measure_new_faces();
    measure_around(vh);
    for (int sweep = 0; sweep < 2; ++sweep) {
      std::vector<EdgeHandle> rim;
      for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
        rim.push_back(mesh().edge_handle(mesh().next_halfedge_handle(heh)));
      }
      for (const EdgeHandle eh : rim) swap_for_shape(eh);
      smooth(vh);
      for (const VertexHandle near : ring(vh)) smooth(near);
    }
  }

  void measure_around(VertexHandle vh) {
    for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
      if (mesh().is_boundary(heh)) continue;
      const FaceHandle fh = mesh().face_handle(heh);
      sag(fh) = sag_now(fh);
    }
  }

  std::vector<VertexHandle> ring(VertexHandle vh) const {
    std::vector<VertexHandle> vertices;
    for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
      vertices.push_back(mesh().to_vertex_handle(heh));
    }
    return vertices;
  }

  /// The triangles around an inner vertex, were it there.
  std::vector<Triangle> star(VertexHandle vh, const Corner& centre) const {
    std::vector<Triangle> triangles;
    for (const HalfedgeHandle heh : mesh().voh_range(vh)) {
      const HalfedgeHandle next = mesh().next_halfedge_handle(heh);
      triangles.push_back(
          {centre, corner(mesh().to_vertex_handle(heh)), corner(mesh().to_vertex_handle(next))});
    }
    return triangles;
  }

  /// Move an inner node towards the middle of its neighbours if that makes the shapes around
  /// better.
  void smooth(VertexHandle vh) {
    if (index(vh) < boundary_count_) return;
    const Corner now = corner(vh);
    const double shape = shape_of(star(vh, now));
    if (shape > kGoodShape) return;
    Uv middle{0, 0};
    const std::vector<VertexHandle> neighbours = ring(vh);
    for (const VertexHandle near : neighbours) middle = middle + delaunay_.uv(near);
    middle = 1.0 / static_cast<double>(neighbours.size()) * middle;
    for (const double share : {1.0, 0.5, 0.25}) {
      const Corner then = corner_at(lerp(now.uv, middle, share));
      const std::vector<Triangle> moved = star(vh, then);
      const bool is_valid = std::all_of(moved.begin(), moved.end(), [](const Triangle& t) {
        return orient2d(t[0].uv, t[1].uv, t[2].uv) > 0;
      });
      if (!is_valid || shape_of(moved) < shape + kLeastGain) continue;
      if (sag_of(moved) > std::max(aim_, sag_of(star(vh, now)))) continue;
      move(vh, then);
      return;
    }
  }

  void move(VertexHandle vh, const Corner& to) {
    const auto v = index(vh);
    QueryHint hint;
    delaunay_.uv(vh) = to.uv;
    delaunay_.metric(vh) = patch_.field->at(to.uv, hint);
    patch_.points[v] = to.point;
    patch_.normals[v] = to.normal;
    measure_around(vh);
  }

  PatchMesh& patch_;
  DelaunayMesh& delaunay_;
  double aim_;
  std::size_t boundary_count_ = 0;
  std::vector<double> sags_;  ///< by face
  SagCorrections result_;
};

}  // namespace

SagCorrections correct_sag(PatchMesh& patch, double aim) {
  const SagCorrections result = SagCorrector(patch, aim).run();
  patch.delaunay->shrink();
  return result;
}

}  // namespace surfmesh::detail
