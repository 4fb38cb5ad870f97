// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/frontal.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surfmesh/metric/tensor.hh"
#include "surfmesh/quad/front_levels.hh"
#include "surfmesh/quad/front_quads.hh"
#include "surfmesh/quad/front_smoother.hh"

namespace surfmesh {
namespace {

/// The least scaled Jacobian of a quad at the first, second and third attempt.
constexpr std::array kLeastJacobians = {0.4, 0.2, 0.05};

/// After these attempts, any quad is taken that smoothing makes convex.
constexpr int kAttempts = static_cast<int>(kLeastJacobians.size());
constexpr double kAnyJacobian = -1;

/// What is left is tried again so often, for the vertices around have moved.
constexpr int kRounds = 4;

/// Lengths of the base between which a quad is made by its side edges; with mixed fronts, lengths
/// of its top edge, in which the gradation of the metric shows. Rows of quads that go on where
/// sizes change become too long or short.
constexpr double kShortestBase = 0.6, kLongestBase = 1.5;
constexpr double kShortestTop = 0.7, kLongestTop = 1.4;

bool is_between(double x, double least, double most) { return x > least && x < most; }

std::size_t sum(std::span<const std::size_t> sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
}

bool has_odd(std::span<const std::size_t> sizes) {
  return std::any_of(sizes.begin(), sizes.end(), [](std::size_t n) { return n % 2 != 0; });
}

class Conversion {
 public:
  Conversion(PolyMesh& mesh, FaceEditor& editor, const FrontalInput& input)
      : editor_(editor),
        mode_(input.front),
        mesh_(mesh, editor, input.field, sum(input.loop_sizes)),
        smoother_(mesh_),
        quads_(mesh_, has_odd(input.loop_sizes)) {}

  FrontalReport run(const RunContext& context) {
    for (int round = 0; round < kRounds; ++round) {
      if (!put_all_fronts()) break;
      convert_all(context);
    }
    for (std::size_t f = 0; f < editor_.face_bound(); ++f) {
      if (mesh_.is_triangle(FaceHandle(static_cast<int>(f)))) ++report_.triangles;
    }
    report_.queries = mesh_.queries();
    return report_;
  }

 private:
  /// Returns  whether there are any
  bool put_all_fronts() {
    bool is_any = false;
    for (std::size_t i = 0; i < mesh_.mesh().n_halfedges(); ++i) {
      const HalfedgeHandle heh(static_cast<int>(i));
      if (!mesh_.is_front(heh)) continue;
      put_afresh(heh, 0);
      is_any = true;
    }
    return is_any;
  }

  void convert_all(const RunContext& context) {
    std::size_t steps = 0;
    for (HalfedgeHandle heh = levels_.pop(); heh.is_valid(); heh = levels_.pop()) {
      if (++steps % kSearchesBetweenCancellation == 0) context.throw_if_cancelled();
      if (mesh_.is_front(heh)) convert(heh);
    }
  }

  void convert(HalfedgeHandle heh) {
    const FrontEdge edge = measure_front(mesh_, heh);
    const int level = levels_.level(heh);
    attempts_.resize(mesh_.mesh().n_halfedges(), 0);
    const int attempt = attempts_[index(heh)];
    if (attempt == kAttempts) {
      force(edge, level);
      return;
    }
    const FaceHandle quad = make(edge, kLeastJacobians[static_cast<std::size_t>(attempt)]);
    if (quad.is_valid()) {
      smoother_.smooth_around(quad);
      put_around(quad, level);
    } else {
      ++attempts_[index(heh)];
      levels_.put(edge, level + 1);
    }
  }

  /// Drop a corner that is in the way, or merge two triangles, to whatever quad that gives, and
  /// open it by smoothing; or else close the gap where only two triangles are left, or sew fronts
  /// together.
  void force(const FrontEdge& edge, int level) {
    if (keep_if_opened(quads_.drop_corner(edge.base), level) ||
        keep_if_opened(quads_.merge(edge, kAnyJacobian), level)) {
      return;
    }
    if (close(mesh_.close_gap(edge.base)) || close(mesh_.sew(edge.base))) return;
    const VertexPair parts = mesh_.open_corner(edge.base);
    if (parts[0].is_valid()) untangle(parts);
  }

  bool close(VertexHandle merged) { return merged.is_valid() && untangle({&merged, 1}); }

  bool keep_if_opened(FaceHandle quad, int level) {
    if (!quad.is_valid()) return false;
    std::vector<VertexHandle> corners;
    for (const VertexHandle vh : mesh_.mesh().fv_range(quad)) corners.push_back(vh);
    if (!untangle(corners)) return false;
    ++report_.forced;
    put_around(quad, level);
    return true;
  }

  /// Open the faces at some vertices, or undo the last change.
  bool untangle(std::span<const VertexHandle> vertices) {
    const bool is_open = smoother_.untangle(vertices);
    if (is_open) {
      mesh_.keep();
    } else {
      mesh_.undo();
    }
    return is_open;
  }

  FaceHandle make(const FrontEdge& edge, double least_jacobian) {
    if (is_to_advance(edge)) {
      const FaceHandle quad = quads_.advance(edge, least_jacobian);
      if (quad.is_valid()) {
        ++report_.advanced;
        return quad;
      }
    }
    const FaceHandle quad = quads_.merge(edge, least_jacobian);
    if (quad.is_valid()) ++report_.merged;
    return quad;
  }

  /// True if a quad with side edges fits.
  bool is_to_advance(const FrontEdge& edge) {
    switch (mode_) {
      case QuadFront::LeeLo:
        return false;
      case QuadFront::QMorph:
        return is_between(edge.length, kShortestBase, kLongestBase);
      default:
        return is_between(length_above(edge), kShortestTop, kLongestTop);
    }
  }

  /// The length of the base in the metric where the top of a unit square would be.
  double length_above(const FrontEdge& edge) {
    const Uv a = mesh_.uv(edge.from.vertex), b = mesh_.uv(edge.to.vertex);
    const Uv along = edge.frame.in_frame(b - a);
    const Direction up{-along.v / edge.length, along.u / edge.length};
    const Metric above = mesh_.metric_at(lerp(a, b, 0.5) + edge.frame.step(up));
    return std::sqrt(squared_length(above, b - a));
  }

  /// The sides of a new quad are fronts now, and the fronts beside them have other angles.
  void put_around(FaceHandle quad, int level) {
    for (const HalfedgeHandle heh : mesh_.mesh().fh_range(quad)) {
      const HalfedgeHandle side = mesh_.mesh().opposite_halfedge_handle(heh);
      if (!mesh_.is_front(side)) continue;
      put_afresh(side, level + 1);
      for (const HalfedgeHandle beside : {mesh_.previous_front(side), mesh_.next_front(side)}) {
        put_afresh(beside, levels_.level(beside));
      }
    }
  }

  void put_afresh(HalfedgeHandle heh, int level) {
    attempts_.resize(mesh_.mesh().n_halfedges(), 0);
    attempts_[index(heh)] = 0;
    levels_.put(measure_front(mesh_, heh), level);
  }

  FaceEditor& editor_;
  QuadFront mode_;
  FrontMesh mesh_;
  FrontSmoother smoother_;
  FrontQuads quads_;
  FrontLevels levels_;
  std::vector<int> attempts_;  ///< by halfedge: that have failed
  FrontalReport report_;
};

}  // namespace

FrontalReport convert_frontal(PolyMesh& mesh, FaceEditor& editor, const FrontalInput& input,
                              const RunContext& context) {
  return Conversion(mesh, editor, input).run(context);
}

}  // namespace surfmesh
