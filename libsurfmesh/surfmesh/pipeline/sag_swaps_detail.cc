// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/sag_swaps_detail.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "surfmesh/assemble/turned_triangles.hh"
#include "surfmesh/quality/triangle_distance_detail.hh"

namespace surfmesh::detail {
namespace {

constexpr int kMostSweeps = 4;

/// Share of the sag below which nothing has to be done.
constexpr double kLeastShare = 0.5;

/// Ratio of the sags after and before from which a swap is worth it.
constexpr double kLeastGain = 0.9;

/// Shape, 1 for an equilateral triangle, below which a swap must not lead.
constexpr double kLeastShape = 0.4;

/// An edge with the apexes of its two triangles, counter-clockwise from the edge's origin.
struct Diamond {
  VertexHandle origin, right, tip, left;
};

class SagSwaps {
 public:
  SagSwaps(PatchMesh& patch, double asked) : patch_(patch), asked_(asked) {}

  std::size_t run() {
    std::size_t swaps = 0;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      const std::size_t before = swaps;
      for (std::size_t e = 0; e < patch_.delaunay->n_edges(); ++e) {
        if (try_swap(EdgeHandle(static_cast<int>(e)))) ++swaps;
      }
      if (swaps == before) break;
    }
    return swaps;
  }

 private:
  bool try_swap(EdgeHandle eh) {
    DelaunayMesh& delaunay = *patch_.delaunay;
    const TriMesh& mesh = delaunay.mesh();
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const HalfedgeHandle opposite = mesh.halfedge_handle(eh, 1);
    if (delaunay.is_constrained(eh) || mesh.is_boundary(heh) || mesh.is_boundary(opposite)) {
      return false;
    }
    const Diamond now{mesh.from_vertex_handle(heh),
                      mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)),
                      mesh.to_vertex_handle(heh),
                      mesh.to_vertex_handle(mesh.next_halfedge_handle(heh))};
    const Diamond then{now.right, now.tip, now.left, now.origin};
    const double sag = sag_of(now);
    if (sag <= kLeastShare * asked_ || !delaunay.can_flip(eh)) return false;
    if (shape_of(then) < std::min(kLeastShape, shape_of(now))) return false;
    if (sag_of(then) > kLeastGain * sag) return false;
    delaunay.flip(eh);
    const bool is_bad =
        is_turned(patch_, mesh.face_handle(heh)) || is_turned(patch_, mesh.face_handle(opposite));
    if (is_bad) delaunay.flip(eh);
    return !is_bad;
  }

  const Vec3& point(VertexHandle vh) const {
    return patch_.points[static_cast<std::size_t>(vh.idx())];
  }

  /// The greatest distance of the surface from the edge and the middles of its triangles.
  double sag_of(const Diamond& d) const {
    const Uv a = patch_.delaunay->uv(d.origin), b = patch_.delaunay->uv(d.tip);
    const double on_edge = segment_distance(position(lerp(a, b, 0.5)), point(d.origin), point(d.tip));
    return std::max({on_edge, sag_of(d.origin, d.tip, d.left), sag_of(d.tip, d.origin, d.right)});
  }

  double sag_of(VertexHandle a, VertexHandle b, VertexHandle c) const {
    const DelaunayMesh& delaunay = *patch_.delaunay;
    const Uv middle = 1.0 / 3 * (delaunay.uv(a) + delaunay.uv(b) + delaunay.uv(c));
    return triangle_distance(position(middle), {point(a), point(b), point(c)}).distance;
  }

  Vec3 position(Uv uv) const { return patch_.surface->evaluate(uv, Order::Position).point; }

  double shape_of(const Diamond& d) const {
    return std::min(shape_of(point(d.origin), point(d.tip), point(d.left)),
                    shape_of(point(d.tip), point(d.origin), point(d.right)));
  }

  static double shape_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double squares =
        (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0 ? 2 * std::numbers::sqrt3 * (b - a).cross(c - a).norm() / squares : 0;
  }

  PatchMesh& patch_;
  double asked_;
};

}  // namespace

std::size_t swap_for_sag(PatchMesh& patch, double asked) { return SagSwaps(patch, asked).run(); }

}  // namespace surfmesh::detail
