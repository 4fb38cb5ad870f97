// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/divide_contours.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>

#include "surfmesh/geometry/parts.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/curve_kinks.hh"

namespace surfmesh {
namespace {

/// A break is a kink if the directions of short chords before and behind it differ by 5°, as in
/// curve_kinks. Chords are this share of the part beside it.
constexpr double kKinkCosine = 0.9962;
constexpr double kChordShare = 1e-6;

/// Kinks nearer to each other than this t are one.
constexpr double kSameKink = 1e-9;

/// True if a curve has a kink at one of its breaks.
bool is_kink(const SpaceCurve& curve, double before, double t, double behind) {
  const Vec3 at = curve.evaluate(t);
  const Vec3 in = at - curve.evaluate(std::lerp(t, before, kChordShare));
  const Vec3 out = curve.evaluate(std::lerp(t, behind, kChordShare)) - at;
  return in.dot(out) < kKinkCosine * in.norm() * out.norm();
}

/// The kinks of a curve: those that a search finds, and those at its breaks, which it may miss.
std::vector<double> kinks_of(const SpaceCurve& curve, const std::vector<double>& breaks) {
  std::vector<double> kinks = curve_kinks(curve);
  const std::vector<double> ends = divided_parts(breaks, 1);
  for (std::size_t i = 1; i + 1 < ends.size(); ++i) {
    const bool is_known = std::any_of(kinks.begin(), kinks.end(), [&](double kink) {
      return std::abs(kink - ends[i]) < kSameKink;
    });
    if (!is_known && is_kink(curve, ends[i - 1], ends[i], ends[i + 1])) kinks.push_back(ends[i]);
  }
  std::sort(kinks.begin(), kinks.end());
  return kinks;
}

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
  const std::vector<double> kinks = kinks_of(*in_space, contour.breaks);
  if (kinks.empty()) return {contour};
  const std::vector<double> ends = with_ends(kinks);
  std::vector<ContourInput> parts(ends.size() - 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = {fmt::format("{}#{}", contour.name, i),
                part_of(contour.xyz, ends, i),
                {},
                {contour.range.at(ends[i]), contour.range.at(ends[i + 1])},
                contour.origin,
                breaks_between(contour.breaks, ends[i], ends[i + 1])};
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
