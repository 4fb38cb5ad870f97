// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/pin_ends.hh"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/core/disjoint_sets.hh"

namespace surfmesh {
namespace {

/// Shares of the domain by which (u,v) of one corner differ that do not follow each other.
constexpr double kRounding = 1e-9;

/// Share of the domain by which ends that follow each other may be apart.
constexpr double kMostMove = 0.02;

/// A curve whose ends are moved.
class PinnedCurve : public Curve {
 public:
  PinnedCurve(std::shared_ptr<const Curve> curve, Uv start, Uv end)
      : curve_(std::move(curve)),
        start_(start),
        end_(end),
        at_start_(start - curve_->evaluate(0)),
        at_end_(end - curve_->evaluate(1)) {}

  Uv evaluate(double t) const override {
    if (t == 0) return start_;
    if (t == 1) return end_;
    return curve_->evaluate(t) + (1 - t) * at_start_ + t * at_end_;
  }

 private:
  std::shared_ptr<const Curve> curve_;
  Uv start_, end_;
  Uv at_start_, at_end_;  ///< by which the ends are moved
};

std::shared_ptr<const Curve> pinned(const std::shared_ptr<const Curve>& curve, Uv start, Uv end) {
  if (dynamic_cast<const SegmentCurve*>(curve.get())) {
    return std::make_shared<SegmentCurve>(start, end);
  }
  return std::make_shared<PinnedCurve>(curve, start, end);
}

/// An end of a use, in one patch.
struct End {
  LoopEntry entry;
  bool is_at_one = false;  ///< t = 1
  int vertex = -1;
  Uv uv;
};

class PatchPins {
 public:
  PatchPins(Model& model, int patch) : model_(model), patch_(patch) {
    for (const PatchLoop& loop : model.patch(patch).loops) {
      for (const LoopEntry& entry : loop) {
        const bool is_forward = model.use(entry).is_forward;
        add_end(entry, !is_forward);
        add_end(entry, is_forward);
      }
    }
  }

  void run() {
    DisjointSets corners(ends_.size());
    unite_followers(corners);
    unite_equal(corners);
    std::vector<std::vector<std::size_t>> members(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) members[corners.find(i)].push_back(i);
    std::vector<Uv> targets(ends_.size());
    for (const std::vector<std::size_t>& corner : members) {
      if (corner.empty()) continue;
      const Uv target = target_of(corner);
      for (const std::size_t i : corner) targets[i] = target;
    }
    move_ends(targets);
  }

 private:
  void add_end(const LoopEntry& entry, bool is_at_one) {
    const Contour& contour = model_.contour(entry);
    ends_.push_back({entry, is_at_one, is_at_one ? contour.end : contour.start,
                     model_.use(entry).curve->evaluate(is_at_one ? 1 : 0)});
  }

  Vec3 point(const End& end) const {
    return model_.surface(patch_).evaluate(end.uv, Order::Position).point;
  }

  /// Ends are in the order of the loops: the start and the end of each entry.
  void unite_followers(DisjointSets& corners) const {
    std::size_t first = 0;
    for (const PatchLoop& loop : model_.patch(patch_).loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t end = first + 2 * i + 1, next = first + 2 * ((i + 1) % loop.size());
        const double gap = (point(ends_[end]) - point(ends_[next])).norm();
        const double allowed = allowed_gap(model_, model_.contour(ends_[end].entry),
                                           model_.contour(ends_[next].entry));
        if (gap <= allowed && are_near(ends_[end].uv, ends_[next].uv)) corners.unite(end, next);
      }
      first += 2 * loop.size();
    }
  }

  /// False across a seam or a pole whose side is missing.
  bool are_near(Uv a, Uv b) const {
    const Domain domain = model_.surface(patch_).domain();
    return std::abs(a.u - b.u) <= kMostMove * (domain.u1 - domain.u0) &&
           std::abs(a.v - b.v) <= kMostMove * (domain.v1 - domain.v0);
  }

  void unite_equal(DisjointSets& corners) const {
    const Domain domain = model_.surface(patch_).domain();
    const double du = kRounding * (domain.u1 - domain.u0);
    const double dv = kRounding * (domain.v1 - domain.v0);
    std::vector<std::size_t> order(ends_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
      return ends_[a].vertex < ends_[b].vertex;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const End& a = ends_[order[i]];
      for (std::size_t j = i + 1; j < order.size() && ends_[order[j]].vertex == a.vertex; ++j) {
        const Uv step = ends_[order[j]].uv - a.uv;
        if (std::abs(step.u) <= du && std::abs(step.v) <= dv) corners.unite(order[i], order[j]);
      }
    }
  }

  Uv target_of(const std::vector<std::size_t>& corner) const {
    const Domain domain = model_.surface(patch_).domain();
    Uv target = ends_[corner.front()].uv;
    const auto is_there = [&](std::size_t i) { return ends_[i].uv == target; };
    if (std::all_of(corner.begin(), corner.end(), is_there)) return target;
    Uv sum{0, 0};
    for (const std::size_t i : corner) sum = sum + ends_[i].uv;
    target = (1.0 / static_cast<double>(corner.size())) * sum;
    for (const std::size_t i : corner) {
      const Uv uv = ends_[i].uv;
      if (uv.u == domain.u0 || uv.u == domain.u1) target.u = uv.u;
      if (uv.v == domain.v0 || uv.v == domain.v1) target.v = uv.v;
    }
    return target;
  }

  void move_ends(const std::vector<Uv>& targets) {
    for (std::size_t i = 0; i < ends_.size(); i += 2) {
      if (ends_[i].uv == targets[i] && ends_[i + 1].uv == targets[i + 1]) continue;
      const bool is_forward = !ends_[i].is_at_one;
      const Uv start = targets[is_forward ? i : i + 1], end = targets[is_forward ? i + 1 : i];
      ContourUse& use = model_.use(ends_[i].entry);
      use.curve = pinned(use.curve, start, end);
    }
  }

  Model& model_;
  int patch_;
  std::vector<End> ends_;
};

}  // namespace

void pin_ends(Model& model) {
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    PatchPins(model, static_cast<int>(p)).run();
  }
}

}  // namespace surfmesh
