// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/joined_uses.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Where patches around a contour are put in order, and the step for its tangent.
constexpr double kPlace = 0.4375;
constexpr double kStep = 1e-4;

/// Share of the diagonal of the model at which the patches are seen beside the contour.
constexpr double kReach = 1e-4;

/// Patches nearer than this angle, in radians, have no order.
constexpr double kLeastAngle = 1e-6;

/// A patch around a contour.
struct Leaf {
  int use = -1;
  double angle = 0;  ///< in which it leaves the contour
  bool has_material_ahead = false;
};

bool is_of_one_solid(const Model& model, const Contour& contour) {
  const int solid = model.patch(contour.uses.front()).solid;
  std::set<int> patches;
  for (const ContourUse& use : contour.uses) {
    if (model.patch(use).solid != solid) return false;
    patches.insert(use.patch);
  }
  return solid >= 0 && patches.size() == contour.uses.size();
}

/// The step in (u,v) that leads nearest to a small step in the tangent plane.
Uv step_along(const Jet& jet, const Vec3& step) {
  const double e = jet.du.squaredNorm(), f = jet.du.dot(jet.dv), g = jet.dv.squaredNorm();
  const double a = step.dot(jet.du), b = step.dot(jet.dv), det = e * g - f * f;
  return {(g * a - f * b) / det, (e * b - f * a) / det};
}

/// Puts the patches around a contour in order.
class Leaves {
 public:
  Leaves(const Model& model, const Contour& contour) : model_(model), contour_(contour) {
    const ContourUse& first = contour.uses.front();
    near_ = model.point(first, kPlace);
    tangent_ = (model.point(first, kPlace + kStep) - near_).normalized();
    for (std::size_t use = 0; use < contour.uses.size(); ++use) add(static_cast<int>(use));
    has_order_ = std::all_of(leaves_.begin(), leaves_.end(),
                             [](const Leaf& leaf) { return std::isfinite(leaf.angle); });
    if (!has_order_) return;
    std::sort(leaves_.begin(), leaves_.end(),
              [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
  }

  /// None if material and air do not alternate.
  std::vector<UsePair> pairs() const {
    if (!has_order_) return {};
    std::vector<UsePair> pairs;
    const std::size_t n = leaves_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Leaf &here = leaves_[i], &next = leaves_[(i + 1) % n];
      if (here.has_material_ahead == next.has_material_ahead) return {};
      const double whole = i + 1 < n ? 0 : 2 * std::numbers::pi;
      if (!(next.angle + whole - here.angle >= kLeastAngle)) return {};
      if (here.has_material_ahead) pairs.push_back({here.use, next.use});
    }
    return pairs;
  }

 private:
  void add(int index) {
    const ContourUse& use = contour_.uses[static_cast<std::size_t>(index)];
    const Surface& surface = model_.surface(use);
    const double t =
        use.is_same_speed ? kPlace : project_to_curve(surface, *use.curve, near_, kPlace);
    const Jet jet = surface.evaluate(use.curve->evaluate(t), Order::First);
    const Vec3 normal = jet.du.cross(jet.dv).normalized();
    const Vec3 inward = (use.is_forward ? 1 : -1) * normal.cross(tangent_);
    // Patches that are tangent to each other have an order only at some distance.
    const Uv inside = use.curve->evaluate(t) + step_along(jet, kReach * model_.diagonal * inward);
    const Vec3 away = surface.evaluate(inside, Order::Position).point - near_;
    if (leaves_.empty()) axis_ = inward;
    const double angle = std::atan2(tangent_.dot(axis_.cross(away)), axis_.dot(away));
    const bool is_outside_ahead = model_.patch(use).is_reversed
                                      ? tangent_.cross(inward).dot(normal) < 0
                                      : tangent_.cross(inward).dot(normal) > 0;
    leaves_.push_back({index, angle, !is_outside_ahead});
  }

  const Model& model_;
  const Contour& contour_;
  Vec3 near_, tangent_;
  Vec3 axis_;  ///< from which angles are measured
  std::vector<Leaf> leaves_;
  bool has_order_ = false;  ///< false at a point without tangent planes
};

}  // namespace

std::vector<std::vector<UsePair>> joined_uses(const Model& model) {
  std::vector<std::vector<UsePair>> pairs;
  pairs.reserve(model.contours.size());
  for (const Contour& contour : model.contours) {
    std::vector<UsePair>& own = pairs.emplace_back();
    const std::size_t count = contour.uses.size();
    if (contour.is_degenerate || count < 2) continue;
    if (count == 2) {
      own.push_back({0, 1});
    } else if (count % 2 == 0 && is_of_one_solid(model, contour)) {
      own = Leaves(model, contour).pairs();
    }
  }
  return pairs;
}

}  // namespace surfmesh
