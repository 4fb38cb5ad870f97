// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/smooth_sweeps.hh"

#include <vector>

namespace surfmesh {
namespace {

/// True if a step depends on the vertex and its neighbours alone. Smoothing by elements may take
/// the last answer of the metric field again, and so depends on the vertex before, too.
bool depends_on_star_alone(Smoothing kind) { return kind != Smoothing::Element; }

void wake_around(const PolyMesh& mesh, VertexHandle vh, std::vector<char>& is_quiet) {
  const HalfedgeHandle start = mesh.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  do {
    is_quiet[index(mesh.to_vertex_handle(heh))] = 0;
    heh = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(heh));
  } while (heh != start);
}

}  // namespace

std::size_t smooth_sweeps(DelaunayMesh& delaunay, VertexMoves& moves, Smoothing kind, int sweeps,
                          const RunContext& context) {
  std::vector<char> is_quiet(delaunay.n_vertices(), 0);
  std::size_t visits = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < is_quiet.size(); ++i) {
      if (i % kStepsBetweenCancellation == 0) context.throw_if_cancelled();
      if (is_quiet[i]) continue;
      ++visits;
      const VertexHandle vh(static_cast<int>(i));
      if (moves.smooth(vh, kind)) {
        wake_around(delaunay.mesh(), vh, is_quiet);
      } else {
        is_quiet[i] = depends_on_star_alone(kind) ? 1 : 0;
      }
    }
  }
  return visits;
}

}  // namespace surfmesh
