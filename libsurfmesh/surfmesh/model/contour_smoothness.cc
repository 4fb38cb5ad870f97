// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/contour_smoothness.hh"

#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {
namespace {

/// Tangent planes that differ by less than this angle (radians, about half a degree) are one.
constexpr double kSmoothAngle = 0.01;

/// True if all patches have the same tangent planes along the contour, also turned ones.
bool has_common_planes(const Model& model, const Contour& contour) {
  const auto normal = [&](const ContourUse& use, const Vec3& near, double t) {
    const Surface& surface = model.surface(use);
    const double foot = use.is_same_speed ? t : project_to_curve(surface, *use.curve, near, t);
    const Jet jet = surface.evaluate(use.curve->evaluate(foot), Order::First);
    return Vec3(jet.du.cross(jet.dv).normalized());
  };
  const ContourUse& front = contour.uses.front();
  for (const double t : sample_parameters(kLineSamples / 4)) {
    const Vec3 near = model.point(front, t);
    const Vec3 first = normal(front, near, t);
    for (const ContourUse& use : contour.uses) {
      if (first.cross(normal(use, near, t)).norm() > kSmoothAngle) return false;
    }
  }
  return true;
}

}  // namespace

void set_smoothness(Model& model) {
  for (Contour& contour : model.contours) {
    contour.is_smooth =
        contour.is_degenerate || (contour.uses.size() > 1 && has_common_planes(model, contour));
  }
}

}  // namespace surfmesh
