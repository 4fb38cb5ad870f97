// SPDX-License-Identifier: BSD-3-Clause
#include "bench/contour_stations.hh"

#include <algorithm>
#include <cmath>
#include <optional>

#include "surfmesh/geometry/beside_pole.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh::judge {
namespace {

/// Samples for the length of a contour in steps of a grid, in each part of the contour.
constexpr int kSamplesInPart = 32;

constexpr double kStationsInStep = 2;

/// Step of t for the direction of a contour.
constexpr double kTangentStep = 1e-5;

Jet first_order(const Surface& surface, Uv uv) {
  return surface.evaluate(surface.domain().fold(uv), Order::First);
}

/// Steps of the grid that a curve passes, at least one.
double steps_along(const Curve& curve, int samples, const PatchGrid& grid) {
  double steps = 1;
  Uv last = grid.in_steps(curve.evaluate(0));
  for (int i = 1; i <= samples; ++i) {
    const Uv next = grid.in_steps(curve.evaluate(double(i) / samples));
    steps += std::max(std::abs(next.u - last.u), std::abs(next.v - last.v));
    last = next;
  }
  return steps;
}

class StationMaker {
 public:
  StationMaker(const Model& model, const Contour& contour, const SizeFields& fields)
      : model_(model), contour_(contour), fields_(fields) {}

  /// None where a patch has no tangent plane.
  std::optional<Station> at(double t) const {
    const ContourUse& first = contour_.uses.front();
    const Vec3 point = model_.point(first, t);
    const Vec3 direction = model_.point(first, std::min(1.0, t + kTangentStep)) -
                           model_.point(first, std::max(0.0, t - kTangentStep));
    Station station;
    for (const ContourUse& use : contour_.uses) {
      const auto side = side_of(use, own_t(use, t, point), direction);
      if (!side) return std::nullopt;
      station.push_back(*side);
    }
    return station;
  }

 private:
  double own_t(const ContourUse& use, double t, const Vec3& point) const {
    const bool is_same = use.is_same_speed && contour_.uses.front().is_same_speed;
    return is_same ? t : project_to_curve(model_.surface(use), *use.curve, point, t);
  }

  std::optional<StationSide> side_of(const ContourUse& use, double t, const Vec3& along) const {
    const Surface& surface = model_.surface(use);
    const Uv uv = surface.domain().clamp(use.curve->evaluate(t));
    if (!is_regular(form_at(surface, uv))) return std::nullopt;
    const SizedPoint point = sized_point(*fields_[static_cast<std::size_t>(use.patch)], uv);
    const double x = along.dot(point.frame.first), y = along.dot(point.frame.second);
    const double length = std::hypot(x, y);
    if (!(length > 0)) return std::nullopt;
    return StationSide{uv, point, x / length, y / length};
  }

  const Model& model_;
  const Contour& contour_;
  const SizeFields& fields_;
};

}  // namespace

FirstFormFactor form_at(const Surface& surface, Uv uv) {
  const Jet jet = first_order(surface, uv);
  return first_form_factor(jet.du, jet.dv);
}

SizedPoint sized_point(const SizeField& field, Uv uv) {
  const Surface& surface = field.surface();
  uv = surface.domain().fold(uv);
  if (!is_regular(form_at(surface, uv))) uv = beside_pole(surface, uv);
  return {tangent_frame(first_order(surface, uv)), field.at(uv).size};
}

std::vector<Station> make_stations(const Model& model, const Contour& contour,
                                   const SizeFields& fields, const std::vector<PatchGrid>& grids) {
  std::vector<Station> stations;
  if (contour.is_degenerate || contour.uses.empty()) return stations;
  double steps = 0;
  for (const ContourUse& use : contour.uses) {
    const PatchGrid& grid = grids[static_cast<std::size_t>(use.patch)];
    steps = std::max(steps, steps_along(*use.curve, kSamplesInPart * contour.part_count(), grid));
  }
  const int count = static_cast<int>(std::ceil(kStationsInStep * steps));
  const StationMaker maker(model, contour, fields);
  for (int i = 0; i <= count; ++i) {
    if (auto station = maker.at(double(i) / count)) stations.push_back(std::move(*station));
  }
  return stations;
}

}  // namespace surfmesh::judge
