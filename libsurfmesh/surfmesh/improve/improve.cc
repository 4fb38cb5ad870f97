// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/improve.hh"

#include <algorithm>
#include <utility>
#include <vector>

#include "surfmesh/core/option_range.hh"
#include "surfmesh/improve/fit_lengths.hh"
#include "surfmesh/improve/smooth_sweeps.hh"
#include "surfmesh/improve/vertex_moves.hh"

namespace surfmesh {
namespace {

/// Triangles below this quality are repaired.
constexpr double kBadQuality = 0.85;

/// A further round of collapses and splits, which looks at all edges, is worth while only if the
/// last one changed more than one edge in so many.
constexpr std::size_t kEdgesPerChange = 2000;

/// Rounds of them: smoothing after a change may undo another one.
constexpr int kMaxFits = 3;

class Improvement {
 public:
  Improvement(DelaunayMesh& delaunay, const MetricField& field, const RunContext& context)
      : delaunay_(delaunay), moves_(delaunay, field), context_(context) {}

  void smooth(Smoothing kind, int sweeps) {
    smooth_sweeps(delaunay_, moves_, kind, sweeps, context_);
  }

  void swap() { report_.swapped += swap_edges(delaunay_, context_); }

  /// Collapse and split edges, again while that changes more than hardly any.
  void fit() {
    for (int round = 0; round < kMaxFits; ++round) {
      const FitReport fitted = fit_lengths(delaunay_, moves_, context_);
      report_.collapsed += fitted.collapsed;
      report_.split += fitted.split;
      if (fitted.collapsed + fitted.split <= delaunay_.n_edges() / kEdgesPerChange) break;
    }
  }

  /// Search better places for the vertices of bad triangles, then swap around them; then again for
  /// the triangles around these vertices.
  void repair(int passes) {
    std::vector<FaceHandle> bad;
    for (std::size_t i = 0; i < delaunay_.n_faces(); ++i) {
      if (i % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      add_if_bad(FaceHandle(static_cast<int>(i)), bad);
    }
    std::vector<char> is_searched(delaunay_.n_vertices(), 0);
    for (int pass = 0; pass < passes && !bad.empty(); ++pass) {
      bad = repair(bad, is_searched);
    }
  }

  ImproveReport report() const {
    ImproveReport report = report_;
    report.moved = moves_.count();
    report.queries = moves_.queries();
    return report;
  }

 private:
  void add_if_bad(FaceHandle fh, std::vector<FaceHandle>& bad) const {
    if (quality(delaunay_, fh) < kBadQuality) bad.push_back(fh);
  }

  /// One pass. `is_searched` is 0 for all vertices before and after.
  /// Returns  the triangles around the vertices that are bad now
  std::vector<FaceHandle> repair(const std::vector<FaceHandle>& bad,
                                 std::vector<char>& is_searched) {
    std::vector<EdgeHandle> edges;
    std::vector<VertexHandle> searched;
    std::size_t steps = 0;
    for (const FaceHandle fh : bad) {
      if (++steps % kStepsBetweenCancellation == 0) context_.throw_if_cancelled();
      HalfedgeHandle heh = delaunay_.mesh().halfedge_handle(fh);
      for (int k = 0; k < 3; ++k, heh = delaunay_.mesh().next_halfedge_handle(heh)) {
        edges.push_back(delaunay_.mesh().edge_handle(heh));
        const VertexHandle vh = delaunay_.mesh().to_vertex_handle(heh);
        char& flag = is_searched[index(vh)];
        if (flag) continue;
        flag = 1;
        moves_.search(vh);
        searched.push_back(vh);
      }
    }
    report_.swapped += swap_edges(delaunay_, std::move(edges), context_);
    std::vector<FaceHandle> left;
    for (const VertexHandle vh : searched) {
      is_searched[index(vh)] = 0;
      for (const FaceHandle fh : delaunay_.mesh().vf_range(vh)) add_if_bad(fh, left);
    }
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    return left;
  }

  DelaunayMesh& delaunay_;
  VertexMoves moves_;
  const RunContext& context_;
  ImproveReport report_;
};

}  // namespace

void check(const ImproveOptions& options) {
  check_option(ranges::kSmoothing, options.smoothing);
  check_option(ranges::kSweeps, options.sweeps);
  check_option(ranges::kRepairs, options.repairs);
}

ImproveReport improve(DelaunayMesh& delaunay, const MetricField& field,
                      const ImproveOptions& options, const RunContext& context) {
  check(options);
  Improvement improvement(delaunay, field, context);
  if (options.smoothing != Smoothing::Off) {
    const int count = static_cast<int>(options.smoothing);
    const Smoothing kind = count > 0 ? Smoothing::Best : options.smoothing;
    const int sweeps = count > 0 ? count : options.sweeps;
    improvement.smooth(kind, sweeps);
    improvement.swap();
  }
  if (options.repairs > 0) {
    improvement.fit();
    improvement.repair(options.repairs);
  }
  return improvement.report();
}

}  // namespace surfmesh
