// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/space_triangles.hh"

#include <algorithm>
#include <array>

#include "surfmesh/across/space_moves.hh"
#include "surfmesh/across/triangle_measures.hh"
#include "surfmesh/across/triangle_state.hh"
#include "surfmesh/across/triangle_trial.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Sweeps of smoothing, passes over edges to be mended, and of repairs.
constexpr int kSweeps = 2;
constexpr int kMendingPasses = 4;
constexpr int kRepairs = 3;

/// Triangles below this quality are repaired.
constexpr double kBadQuality = 0.7;

/// Least gain of quality for which an edge is swapped, so that swaps end.
constexpr double kLeastGain = 1e-6;

/// Two triangles that are both better than this are not made better by a swap: the best pair with
/// either diagonal is the square, with 0.866.
constexpr double kBestOfEitherDiagonal = 0.87;

/// Swaps an edge of the list may cause in all, in the mean.
constexpr std::size_t kSwapsPerEdge = 10;

/// Triangles around a vertex inside.
constexpr int kRegular = 6;

int square(int x) { return x * x; }

class SpaceTriangles {
 public:
  SpaceTriangles(PolyMesh& mesh, FaceEditor& editor, std::vector<VertexChart>& charts,
                 ChartMaker& maker, const RunContext& context)
      : state_(mesh, editor, charts, maker), moves_(state_), trial_(state_), context_(context) {}

  void run() {
    swap_all();
    for (int i = 0; i < kSweeps; ++i) smooth_all();
    swap_all();
    mend_all(Mend::Lengths);
    mend_all(Mend::Regularity);
    mend_all(Mend::Lengths);
    repair();
  }

 private:
  template <class Visit>
  void for_each_face(Visit visit) {
    for (std::size_t f = 0; f < state_.editor.face_bound(); ++f) {
      if (f % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      const FaceHandle fh(static_cast<int>(f));
      if (state_.editor.is_used(fh)) visit(fh);
    }
  }

  std::array<HalfedgeHandle, 3> sides(FaceHandle fh) const {
    const HalfedgeHandle a = state_.mesh.halfedge_handle(fh);
    const HalfedgeHandle b = state_.mesh.next_halfedge_handle(a);
    return {a, b, state_.mesh.next_halfedge_handle(b)};
  }

  void smooth_all() {
    for (std::size_t i = 0; i < state_.editor.vertex_bound(); ++i) {
      if (i % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      const VertexHandle vh(static_cast<int>(i));
      if (state_.editor.is_used(vh)) moves_.smooth(vh);
    }
  }

  // --- swaps ---

  void swap_all() {
    std::vector<EdgeHandle> edges;
    for_each_face([&](FaceHandle fh) {
      for (const HalfedgeHandle heh : sides(fh)) {
        if (heh < state_.mesh.opposite_halfedge_handle(heh)) {
          edges.push_back(state_.mesh.edge_handle(heh));
        }
      }
    });
    swap(std::move(edges));
  }

  bool is_worth_swapping(const EdgeSurroundings& e) const {
    const VertexChart &origin = state_.chart(e.origin), &tip = state_.chart(e.tip);
    const VertexChart &left = state_.chart(e.left), &right = state_.chart(e.right);
    const double before =
        std::min(triangle_quality(origin, tip, left), triangle_quality(tip, origin, right));
    if (before > kBestOfEitherDiagonal) return false;
    const double least = before + kLeastGain;
    return triangle_quality(right, tip, left) > least &&
           triangle_quality(left, origin, right) > least;
  }

  /// Swap the edges of a list, and those around them, where that raises the lower quality.
  void swap(std::vector<EdgeHandle> edges) {
    const PolyMesh& mesh = state_.mesh;
    std::size_t left = kSwapsPerEdge * edges.size(), steps = 0;
    while (!edges.empty() && left > 0) {
      if (++steps % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      const EdgeHandle eh = edges.back();
      edges.pop_back();
      if (!state_.is_inner(eh)) continue;
      const EdgeSurroundings e = state_.around(eh);
      if (!is_worth_swapping(e) || !state_.may_join(e.left, e.right)) continue;
      for (const HalfedgeHandle heh : {e.halfedge, e.opposite}) {
        const HalfedgeHandle next = mesh.next_halfedge_handle(heh);
        edges.push_back(mesh.edge_handle(next));
        edges.push_back(mesh.edge_handle(mesh.next_halfedge_handle(next)));
      }
      old_ = {mesh.face_handle(e.halfedge), mesh.face_handle(e.opposite)};
      fresh_.clear();
      fresh_.add({e.right, e.tip, e.left});
      fresh_.add({e.left, e.origin, e.right});
      state_.editor.replace(old_, fresh_, made_);
      --left;
    }
  }

  // --- trials ---

  enum class Mend { Lengths, Regularity };

  /// Mend all edges, again while that changes any.
  void mend_all(Mend what) {
    for (int pass = 0; pass < kMendingPasses; ++pass) {
      bool is_any = false;
      for_each_face([&](FaceHandle fh) { is_any = mend_sides(fh, what) || is_any; });
      if (!is_any) return;
    }
  }

  /// Returns  whether the face has changed
  bool mend_sides(FaceHandle fh, Mend what) {
    if (!is_flat(fh)) return false;
    for (const HalfedgeHandle heh : sides(fh)) {
      const HalfedgeHandle opposite = state_.mesh.opposite_halfedge_handle(heh);
      if (state_.mesh.is_boundary(opposite) || opposite < heh) continue;
      if (what == Mend::Lengths ? mend_length(heh)
                                : mend_regularity(state_.mesh.edge_handle(heh))) {
        return true;
      }
    }
    return false;
  }

  bool mend_length(HalfedgeHandle heh) {
    const double length = metric_length(state_.chart(state_.mesh.from_vertex_handle(heh)),
                                        state_.chart(state_.mesh.to_vertex_handle(heh)));
    if (length < kShortestUnit) return collapse(heh) || swap_beside(heh);
    if (length > kLongestUnit) {
      return trial_.split(state_.mesh.edge_handle(heh)) || swap_beside(heh);
    }
    return false;
  }

  bool collapse(HalfedgeHandle heh) {
    return trial_.collapse(heh) || trial_.collapse(state_.mesh.opposite_halfedge_handle(heh));
  }

  /// Swap an edge, or another side of the two triangles.
  bool swap_beside(HalfedgeHandle heh) {
    const PolyMesh& mesh = state_.mesh;
    if (trial_.swap(mesh.edge_handle(heh))) return true;
    for (const HalfedgeHandle side : {heh, mesh.opposite_halfedge_handle(heh)}) {
      const HalfedgeHandle next = mesh.next_halfedge_handle(side);
      if (trial_.swap(mesh.edge_handle(next)) ||
          trial_.swap(mesh.edge_handle(mesh.next_halfedge_handle(next)))) {
        return true;
      }
    }
    return false;
  }

  /// Triangles at a vertex beyond six; none at the border, where that does not matter.
  int excess(VertexHandle vh) const {
    return state_.is_at_border(vh) ? 0 : static_cast<int>(state_.mesh.valence(vh)) - kRegular;
  }

  /// Change an edge if that leaves fewer irregular vertices.
  bool mend_regularity(EdgeHandle eh) {
    const EdgeSurroundings e = state_.around(eh);
    const int a = excess(e.origin), b = excess(e.tip), c = excess(e.left), d = excess(e.right);
    if (a == 0 && b == 0 && c == 0 && d == 0) return false;
    const int gain = square(a) + square(b) + square(c) + square(d) - square(a - 1) - square(b - 1) -
                     square(c + 1) - square(d + 1);
    if (gain > 0) return trial_.swap(eh);
    if (a + b <= -2 && c >= 0 && d >= 0 && c + d > 0) return collapse(e.halfedge);
    if (a + b >= 2 && c <= 0 && d <= 0 && c + d < 0) return trial_.split(eh);
    return false;
  }

  // --- repairs ---

  const VertexChart& chart_ahead(HalfedgeHandle heh) const {
    return state_.chart(state_.mesh.to_vertex_handle(heh));
  }

  /// True if the normals at the corners tell how long sides are.
  bool is_flat(FaceHandle fh) const {
    const auto [a, b, c] = sides(fh);
    return do_normals_agree(chart_ahead(c), chart_ahead(a), chart_ahead(b));
  }

  /// True for a triangle that better places of its vertices may mend.
  bool is_bad(FaceHandle fh) const {
    const auto [a, b, c] = sides(fh);
    return triangle_quality(chart_ahead(c), chart_ahead(a), chart_ahead(b)) < kBadQuality &&
           is_flat(fh);
  }

  void repair() {
    std::vector<FaceHandle> bad;
    for_each_face([&](FaceHandle fh) {
      if (is_bad(fh)) bad.push_back(fh);
    });
    for (int pass = 0; pass < kRepairs && !bad.empty(); ++pass) bad = repair(bad);
  }

  /// Search better places for the vertices of bad triangles, then swap around them.
  /// Returns  the triangles around these vertices that are bad now
  std::vector<FaceHandle> repair(const std::vector<FaceHandle>& bad) {
    std::vector<EdgeHandle> edges;
    std::vector<VertexHandle> vertices;
    for (const FaceHandle fh : bad) {
      for (const HalfedgeHandle heh : sides(fh)) {
        edges.push_back(state_.mesh.edge_handle(heh));
        vertices.push_back(state_.mesh.to_vertex_handle(heh));
      }
    }
    remove_repeats(vertices);
    std::size_t steps = 0;
    for (const VertexHandle vh : vertices) {
      if (++steps % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      moves_.search(vh);
    }
    swap(std::move(edges));
    std::vector<FaceHandle> left;
    for (const VertexHandle vh : vertices) {
      for (const FaceHandle fh : state_.mesh.vf_range(vh)) {
        if (is_bad(fh)) left.push_back(fh);
      }
    }
    remove_repeats(left);
    return left;
  }

  template <class Handle>
  static void remove_repeats(std::vector<Handle>& handles) {
    std::sort(handles.begin(), handles.end());
    handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
  }

  TriangleState state_;
  SpaceMoves moves_;
  TriangleTrial trial_;
  const RunContext& context_;
  std::vector<FaceHandle> old_, made_;  ///< of a swap
  FaceCycles fresh_;
};

}  // namespace

void improve_space_triangles(PolyMesh& mesh, FaceEditor& editor, std::vector<VertexChart>& charts,
                             ChartMaker& maker, const RunContext& context) {
  SpaceTriangles(mesh, editor, charts, maker, context).run();
}

}  // namespace surfmesh
