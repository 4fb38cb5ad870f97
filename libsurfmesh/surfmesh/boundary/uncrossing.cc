// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/uncrossing.hh"

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "surfmesh/boundary/loop_steps.hh"
#include "surfmesh/boundary/pole_room.hh"
#include "surfmesh/geometry/crossing_segments.hh"

namespace surfmesh {
namespace {

/// Rounds of halving segments of loops that cross, and the most segments that these may become, as
/// a multiple and beyond: curves that do not cross, but overlap, would have no end.
constexpr int kMostUncrossings = 40;
constexpr std::size_t kMostGrowth = 4, kMostSurplus = 10'000;

/// Of two segments that cross the shorter is halved, too, if it is longer than this share.
constexpr double kShareHalvedToo = 0.6;

/// A segment of a contour.
struct ContourSegment {
  int contour = -1;
  std::size_t segment = 0;

  friend auto operator<=>(const ContourSegment&, const ContourSegment&) = default;
};

using ContourSegments = std::set<ContourSegment>;

/// The loops of a patch: the steps, and the node from which each starts.
struct Loops {
  std::vector<detail::NodeLoop> nodes;
  std::vector<std::vector<LoopStep>> steps;
};

double length_uv(const Loops& loops, const detail::LoopSegment& segment) {
  const detail::NodeLoop& nodes = loops.nodes[segment.loop];
  const Uv step = nodes[(segment.node + 1) % nodes.size()] - nodes[segment.node];
  return std::hypot(step.u, step.v);
}

/// `seams` are the contours that lead to the pole.
bool has_room(const Loops& loops, const detail::PoleSide& pole, const std::array<int, 2>& seams) {
  for (std::size_t l = 0; l < loops.nodes.size(); ++l) {
    const detail::NodeLoop& nodes = loops.nodes[l];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int contour = loops.steps[l][i].entry.contour;
      if (contour == seams[0] || contour == seams[1]) continue;
      if (detail::is_in_the_way(pole, nodes[i], nodes[(i + 1) % nodes.size()])) return false;
    }
  }
  return true;
}

class Uncrossing {
 public:
  Uncrossing(const Model& model, ContourDivisions& divisions, int multiple,
             const RunContext& context)
      : model_(model),
        divisions_(divisions),
        multiple_(multiple),
        context_(context),
        most_(kMostSurplus) {
    for (const auto& division : divisions_) {
      if (division) most_ += kMostGrowth * division->segment_count();
    }
  }

  void run() {
    std::vector<ContourDivision::Parameters> before;
    for (const auto& division : divisions_) {
      before.push_back(division ? division->parameters() : ContourDivision::Parameters{});
    }
    ContourSegments segments = crossing_or_beside_poles();
    for (int round = 0; round < kMostUncrossings && halve(segments); ++round) {
      segments = crossing_or_beside_poles();
    }
    // A ring without room may be meshed all the same.
    if (segments.empty() || crossing().empty()) return;
    for (std::size_t c = 0; c < divisions_.size(); ++c) {
      if (divisions_[c]) divisions_[c]->set_parameters(std::move(before[c]));
    }
  }

 private:
  std::optional<ContourDivision>& division(int contour) const {
    return divisions_[static_cast<std::size_t>(contour)];
  }

  /// Returns false if nothing crosses, or nothing can be done about it.
  bool halve(const ContourSegments& segments) {
    std::size_t halved = 0;
    // Backwards, for halving moves the segments behind.
    for (auto it = segments.rbegin(); it != segments.rend(); ++it) {
      if (halved_ < most_ && division(it->contour)->halve_crossing(it->segment)) ++halved;
    }
    for (const ContourSegment& segment : segments) {
      division(segment.contour)->round_up_to(multiple_);
    }
    halved_ += halved;
    return halved > 0;
  }

  ContourSegments crossing() const {
    ContourSegments segments;
    for (const Patch& patch : model_.patches) {
      context_.throw_if_cancelled();
      add_crossing(loops_of(patch), segments);
    }
    return segments;
  }

  ContourSegments crossing_or_beside_poles() const {
    ContourSegments segments;
    for (const Patch& patch : model_.patches) {
      context_.throw_if_cancelled();
      const Loops loops = loops_of(patch);
      add_crossing(loops, segments);
      for (std::size_t l = 0; l < loops.nodes.size(); ++l) add_beside_poles(loops, l, segments);
    }
    return segments;
  }

  Loops loops_of(const Patch& patch) const {
    Loops loops;
    for (const PatchLoop& loop : patch.loops) {
      loops.steps.push_back(steps_along(model_, loop, [this](int contour) {
        return division(contour) ? division(contour)->segment_count() : 1;
      }));
      detail::NodeLoop& nodes = loops.nodes.emplace_back();
      for (const LoopStep& step : loops.steps.back()) nodes.push_back(node_of(step));
    }
    return loops;
  }

  Uv node_of(const LoopStep& step) const {
    if (const auto& of_contour = division(step.entry.contour)) {
      return of_contour->uv(static_cast<std::size_t>(step.entry.use), step.node);
    }
    return model_.use(step.entry).curve->evaluate(step.node == 0 ? 0 : 1);
  }

  void add_crossing(const Loops& loops, ContourSegments& segments) const {
    for (const auto& [p, q] : detail::crossing_segments(loops.nodes)) {
      const double length_p = length_uv(loops, p), length_q = length_uv(loops, q);
      if (length_p >= kShareHalvedToo * length_q) add(loops.steps[p.loop][p.node], segments);
      if (length_q >= kShareHalvedToo * length_p) add(loops.steps[q.loop][q.node], segments);
    }
  }

  /// Add the segments next to those poles of a loop whose rings have no room.
  void add_beside_poles(const Loops& loops, std::size_t l, ContourSegments& segments) const {
    const std::vector<LoopStep>& steps = loops.steps[l];
    const detail::NodeLoop& nodes = loops.nodes[l];
    const std::size_t n = nodes.size();
    for (const PoleRun& run : pole_runs(model_, steps)) {
      const std::size_t before = (run.first + n - 1) % n, end = (run.first + run.count) % n;
      const LoopStep &to = steps[before], &from = steps[end];
      const detail::PoleSide pole{nodes[before], nodes[run.first], nodes[end],
                                  nodes[(end + 1) % n]};
      if (has_room(loops, pole, {to.entry.contour, from.entry.contour})) continue;
      add(to, segments);
      add(from, segments);
    }
  }

  void add(const LoopStep& step, ContourSegments& segments) const {
    if (division(step.entry.contour)) segments.insert({step.entry.contour, step.segment});
  }

  const Model& model_;
  ContourDivisions& divisions_;
  int multiple_;
  const RunContext& context_;
  std::size_t most_;
  std::size_t halved_ = 0;
};

}  // namespace

void uncross(const Model& model, ContourDivisions& divisions, int multiple,
             const RunContext& context) {
  Uncrossing(model, divisions, multiple, context).run();
}

}  // namespace surfmesh
