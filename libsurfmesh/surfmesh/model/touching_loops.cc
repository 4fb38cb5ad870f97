// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/touching_loops.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "surfmesh/model/patch_loops.hh"

namespace surfmesh {
namespace {

/// Curves at a corner are put in order on a circle around it. Its radius is this share of the way
/// to the nearest other end of a curve there: small, for curves may bend back, but large against
/// the rounding of (u,v).
constexpr double kCircleShare = 1e-3;
constexpr int kBisections = 60;
/// Steps in which the circle is looked for along a curve.
constexpr int kSteps = 64;

/// The end of an entry at a corner.
struct CornerEnd {
  std::size_t entry = 0;    ///< of all loops, one after the other
  bool is_leaving = false;  ///< the loop runs away from the corner
  double angle = 0;         ///< in which the curve leaves the corner
};

bool is_counter_clockwise(const Model& model, const PatchLoop& loop) {
  return signed_area(loop_curves(model, loop)) > 0;
}

/// Brings the loops of one patch in order.
class LoopSeparator {
 public:
  LoopSeparator(Model& model, int patch)
      : model_(model), patch_(patch), domain_(model.surface(patch).domain()) {
    for (const PatchLoop& loop : model.patch(patch).loops) {
      const std::size_t first = entries_.size();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        entries_.push_back(loop[i]);
        next_.push_back(first + (i + 1) % loop.size());
      }
    }
  }

  void run() {
    bool is_changed = false;
    for (auto& [corner, ends] : touching_corners()) is_changed |= turn_into_sectors(ends);
    if (is_changed) model_.patch(patch_).loops = followed_loops();
  }

 private:
  using Corner = std::tuple<int, double, double>;  // vertex, u, v

  /// The corners that are passed more than once.
  std::map<Corner, std::vector<CornerEnd>> touching_corners() const {
    std::map<Corner, std::vector<CornerEnd>> corners;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      for (const bool is_leaving : {true, false}) {
        const Uv uv = loop_curve(model_, entries_[i]).at(is_leaving ? 0 : 1);
        const Contour& contour = model_.contour(entries_[i]);
        const bool is_start = model_.use(entries_[i]).is_forward == is_leaving;
        corners[{is_start ? contour.start : contour.end, uv.u, uv.v}].push_back({i, is_leaving});
      }
    }
    std::erase_if(corners, [](const auto& corner) { return corner.second.size() < 4; });
    return corners;
  }

  /// Let each loop that comes to a corner go on in the sector from which it comes.
  /// Returns  false if curves cross at the corner
  bool turn_into_sectors(std::vector<CornerEnd>& ends) {
    set_angles(ends);
    std::stable_sort(ends.begin(), ends.end(),
                     [](const CornerEnd& a, const CornerEnd& b) { return a.angle < b.angle; });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].is_leaving == ends[(i + 1) % ends.size()].is_leaving) return false;
    }
    // The inside lies on the left of what leaves, and on the right of what comes, seen from here.
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].is_leaving) next_[ends[(i + 1) % ends.size()].entry] = ends[i].entry;
    }
    return true;
  }

  Uv scaled(Uv step) const {
    return {step.u / (domain_.u1 - domain_.u0), step.v / (domain_.v1 - domain_.v0)};
  }

  /// From the corner, at a share of the way along an end.
  Uv step_along(const CornerEnd& end, double share) const {
    const LoopCurve run = loop_curve(model_, entries_[end.entry]);
    return scaled(end.is_leaving ? run.at(share) - run.at(0) : run.at(1 - share) - run.at(1));
  }

  /// Distance from the corner at a share of the way.
  double way(const CornerEnd& end, double share) const {
    const Uv step = step_along(end, share);
    return std::hypot(step.u, step.v);
  }

  double reach_of(const CornerEnd& end) const {
    double reach = 0;
    for (int i = 1; i <= kSteps; ++i) {
      reach = std::max(reach, way(end, static_cast<double>(i) / kSteps));
    }
    return reach;
  }

  void set_angles(std::vector<CornerEnd>& ends) const {
    double radius = reach_of(ends.front());
    for (const CornerEnd& end : ends) radius = std::min(radius, reach_of(end));
    radius *= kCircleShare;
    for (CornerEnd& end : ends) {
      double inside = 0, outside = 1;
      for (int i = 1; i <= kSteps; ++i) {
        outside = static_cast<double>(i) / kSteps;
        if (way(end, outside) > radius) break;
        inside = outside;
      }
      for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        (way(end, middle) > radius ? outside : inside) = middle;
      }
      const Uv step = step_along(end, outside);
      end.angle = std::atan2(step.v, step.u);
    }
  }

  std::vector<PatchLoop> followed_loops() const {
    std::vector<PatchLoop> outer, inner;
    std::vector<char> is_done(entries_.size(), 0);
    for (std::size_t first = 0; first < entries_.size(); ++first) {
      if (is_done[first] != 0) continue;
      PatchLoop loop;
      for (std::size_t i = first; is_done[i] == 0; i = next_[i]) {
        is_done[i] = 1;
        loop.push_back(entries_[i]);
      }
      (is_counter_clockwise(model_, loop) ? outer : inner).push_back(std::move(loop));
    }
    outer.insert(outer.end(), inner.begin(), inner.end());
    return outer;
  }

  Model& model_;
  int patch_;
  Domain domain_;
  std::vector<LoopEntry> entries_;
  std::vector<std::size_t> next_;  ///< by entry, the one behind it in its loop
};

}  // namespace

void separate_touching_loops(Model& model) {
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    LoopSeparator(model, static_cast<int>(p)).run();
  }
}

long outer_less_inner_loops(const Model& model, const Patch& patch) {
  if (patch.loops.size() == 1) return 1;
  long count = 0;
  for (const PatchLoop& loop : patch.loops) {
    count += is_counter_clockwise(model, loop) ? 1 : -1;
  }
  return count;
}

}  // namespace surfmesh
