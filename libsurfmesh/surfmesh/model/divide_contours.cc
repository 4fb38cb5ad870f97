// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/divide_contours.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/curve_kinks.hh"

namespace surfmesh {
namespace {

/// The place of a curve on a patch that is nearest to the point at t of the contour: t itself, if
/// both have the same speed.
double same_place(const Surface& surface, const Curve& curve, const SpaceCurve& in_space,
                  double t) {
  const Vec3 point = in_space.evaluate(t);
  const auto distance = [&](double at) {
    return (surface.evaluate(curve.evaluate(at), Order::Position).point - point).norm();
  };
  const double projected = project_to_curve(surface, curve, point, t);
  return distance(t) <= distance(projected) ? t : projected;
}

/// Kinks between both ends.
std::vector<double> with_ends(std::vector<double> kinks) {
  kinks.insert(kinks.begin(), 0);
  kinks.push_back(1);
  return kinks;
}

/// Where a curve on a patch has the kinks of the contour.
std::vector<double> kinks_on(const Surface& surface, const Curve& curve, const SpaceCurve& in_space,
                             const std::vector<double>& kinks) {
  std::vector<double> own;
  for (const double t : kinks) own.push_back(same_place(surface, curve, in_space, t));
  // A curve that is elsewhere is told of later.
  const std::vector<double> ends = with_ends(own);
  const bool is_growing =
      std::adjacent_find(ends.begin(), ends.end(), std::greater_equal<>()) == ends.end();
  return is_growing ? own : kinks;
}

/// The part of a curve between two of its ends, by number; null for none.
template <class Whole>
std::shared_ptr<const Whole> part_of(const std::shared_ptr<const Whole>& curve,
                                     const std::vector<double>& ends, std::size_t number) {
  if (!curve) return nullptr;
  return std::make_shared<CurvePart<Whole>>(curve, ends[number], ends[number + 1]);
}

}  // namespace

std::vector<ContourInput> divide_at_kinks(const ContourInput& contour,
                                          const std::vector<PatchInput>& patches,
                                          const PatchNumbers& patch_numbers) {
  const std::shared_ptr<const SpaceCurve> in_space =
      curve_in_space(contour, patches, patch_numbers);
  const std::vector<double> kinks = curve_kinks(*in_space);
  if (kinks.empty()) return {contour};
  const std::vector<double> ends = with_ends(kinks);
  std::vector<ContourInput> parts(ends.size() - 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = {fmt::format("{}#{}", contour.name, i),
                part_of(contour.xyz, ends, i),
                {},
                {contour.range.at(ends[i]), contour.range.at(ends[i + 1])},
                contour.origin};
  }
  for (const ContourInput::On& on : contour.on) {
    const auto patch = static_cast<std::size_t>(patch_numbers.at(on.patch));
    const std::vector<double> own =
        on.curve ? with_ends(kinks_on(*patches[patch].surface, *on.curve, *in_space, kinks)) : ends;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i].on.push_back({on.patch, part_of(on.curve, own, i)});
    }
  }
  return parts;
}

bool is_part_of(std::string_view part, std::string_view contour) {
  if (!part.starts_with(contour)) return false;
  const std::string_view rest = part.substr(contour.size());
  return rest.empty() || rest.starts_with('#');
}

}  // namespace surfmesh
