// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/metric_swaps.hh"

#include <algorithm>
#include <array>

namespace surfmesh {
namespace {

/// Least gain of quality for which an edge is swapped: far above rounding, so that swaps end.
constexpr double kLeastGain = 1e-6;

/// Swaps an edge of the list may cause in all, in the mean; a few tenths are usual.
constexpr std::size_t kSwapsPerEdge = 10;

/// Triangles of this quality or better never gain by a swap: of two that are halves of a square, in
/// which neither diagonal is better, each has the quality 0.866.
constexpr double kBeyondSwaps = 0.9;

struct Quadrilateral {
  HalfedgeHandle halfedge, opposite;
  MetricCorner origin, tip, left, right;
};

Quadrilateral around(const DelaunayMesh& delaunay, EdgeHandle eh) {
  const PolyMesh& mesh = delaunay.mesh();
  const HalfedgeHandle a = mesh.halfedge_handle(eh, 0), b = mesh.halfedge_handle(eh, 1);
  return {a,
          b,
          corner(delaunay, mesh.to_vertex_handle(b)),
          corner(delaunay, mesh.to_vertex_handle(a)),
          corner(delaunay, mesh.to_vertex_handle(mesh.next_halfedge_handle(a))),
          corner(delaunay, mesh.to_vertex_handle(mesh.next_halfedge_handle(b)))};
}

bool is_worth_swapping(const Quadrilateral& q) {
  const double before = std::min(triangle_quality(q.origin, q.tip, q.left),
                                 triangle_quality(q.tip, q.origin, q.right));
  const double after = std::min(triangle_quality(q.right, q.tip, q.left),
                                triangle_quality(q.left, q.origin, q.right));
  return after > before + kLeastGain;
}

void add_sides(const PolyMesh& mesh, FaceHandle fh, std::vector<EdgeHandle>& edges) {
  HalfedgeHandle heh = mesh.halfedge_handle(fh);
  for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
    edges.push_back(mesh.edge_handle(heh));
  }
}

}  // namespace

double quality(const DelaunayMesh& delaunay, FaceHandle fh) {
  const PolyMesh& mesh = delaunay.mesh();
  const HalfedgeHandle a = mesh.halfedge_handle(fh);
  const HalfedgeHandle b = mesh.next_halfedge_handle(a);
  const HalfedgeHandle c = mesh.next_halfedge_handle(b);
  return triangle_quality(corner(delaunay, mesh.to_vertex_handle(a)),
                          corner(delaunay, mesh.to_vertex_handle(b)),
                          corner(delaunay, mesh.to_vertex_handle(c)));
}

std::size_t swap_edges(DelaunayMesh& delaunay, std::vector<EdgeHandle> edges,
                       const RunContext& context) {
  const PolyMesh& mesh = delaunay.mesh();
  const std::size_t limit = kSwapsPerEdge * edges.size();
  std::size_t swaps = 0, steps = 0;
  while (!edges.empty() && swaps < limit) {
    if (++steps % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
    const EdgeHandle eh = edges.back();
    edges.pop_back();
    const HalfedgeHandle inner = mesh.halfedge_handle(eh, 0);
    if (delaunay.is_constrained(eh) || mesh.is_boundary(inner) ||
        mesh.is_boundary(mesh.opposite_halfedge_handle(inner))) {
      continue;
    }
    const Quadrilateral q = around(delaunay, eh);
    if (!is_worth_swapping(q) || !delaunay.can_flip(eh)) continue;
    for (const HalfedgeHandle heh : {q.halfedge, q.opposite}) {
      const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
      edges.push_back(mesh.edge_handle(next));
      edges.push_back(mesh.edge_handle(mesh.next_halfedge_handle(next)));
    }
    delaunay.flip(eh);
    ++swaps;
  }
  return swaps;
}

std::size_t swap_edges(DelaunayMesh& delaunay, const RunContext& context) {
  std::vector<EdgeHandle> edges;
  for (std::size_t i = 0; i < delaunay.n_faces(); ++i) {
    if (i % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
    const FaceHandle fh(static_cast<int>(i));
    if (quality(delaunay, fh) < kBeyondSwaps) add_sides(delaunay.mesh(), fh, edges);
  }
  // The least edge first, which is taken from the end.
  std::sort(edges.rbegin(), edges.rend());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return swap_edges(delaunay, std::move(edges), context);
}

}  // namespace surfmesh
