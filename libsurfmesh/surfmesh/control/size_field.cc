// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/size_field.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/control/place_sources.hh"
#include "surfmesh/control/point_nodes.hh"
#include "surfmesh/control/regular_place.hh"
#include "surfmesh/control/table_sizes.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/difference_surface.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// Intervals of a curve or of a side of a polygon between whose ends its size is looked for.
constexpr int kPlacesOnCurve = 64;

/// Rays on which the ring around an extraordinary vertex is sampled, from side to side.
constexpr int kRingSamples = 5;

/// What the curvature of the surface asks for: where sizes that hold the sag are known, its factor
/// alone.
CurvatureLength length_on(const Sizing& sizing, const PatchSources& sources, double diagonal) {
  if (sources.sag.empty()) return CurvatureLength(sizing, diagonal);
  Sizing by_factor = sizing;
  by_factor.curvature = sizing.curvature_factor();
  by_factor.sag.reset();
  return CurvatureLength(by_factor, diagonal);
}

}  // namespace

SizeField::SizeField(const Surface& surface, const Sizing& sizing, const PatchSources& sources,
                     double diagonal, double precision)
    : surface_(surface),
      differences_(sizing.curvature_from == CurvatureFrom::Differences
                       ? std::make_shared<DifferenceSurface>(surface)
                       : nullptr),
      domain_(surface.domain()),
      bounds_(sizing, diagonal),
      length_(length_on(sizing, sources, diagonal)),
      stretch_(sizing.stretch),
      rounded_sides_(surface.rounded_sides()) {
  check_sizing(stretch_ >= 1, "stretch", stretch_, "1 or above");
  check_sizing(sizing.grade == 0 || (sizing.grade >= 1 && std::isfinite(sizing.grade)), "grade",
               sizing.grade, "0 (off), or 1 and above");
  take_sources(sources, sizing, precision);
  if (length_.is_off()) return;
  for (const SingularPoint& singular : surface.singular_points()) {
    discs_.push_back(make_disc(singular));
  }
}

void SizeField::take_sources(const PatchSources& sources, const Sizing& sizing, double precision) {
  for (const EverywhereSource& source : sources.everywhere) {
    const SizeTensor size = bounds_.clamp(bounds_.tensor(source.size));
    everywhere_ = everywhere_ ? bounds_.clamp(minimum(*everywhere_, size)) : size;
  }
  fields_ = sources.fields;
  for (const TableSource& source : sources.tables) {
    tables_.push_back(std::make_shared<NodeInterpolation>(
        interpolate_table(source, surface_, bounds_, precision)));
  }
  for (const TableSource& source : sources.sag) {
    tables_.push_back(std::make_shared<NodeInterpolation>(
        surface_, table_nodes(source, surface_, bounds_)));
  }
  std::vector<PlacedSize> placed;
  for (const InsideSource& source : sources.inside) {
    areas_.push_back({source.polygon, bounds_.clamp(bounds_.tensor(source.wish.size))});
    add_border(source, surface_, bounds_, placed);
  }
  for (const AlongSource& source : sources.along) add_along(source, surface_, bounds_, placed);
  const bool is_interpolated =
      !has_area_source() && (!placed.empty() || !sources.trees.empty()) && !sources.at.empty();
  if (is_interpolated) {
    tables_.push_back(
        std::make_shared<NodeInterpolation>(surface_, point_nodes(sources.at, surface_, bounds_)));
  }
  for (const AtSource& source : sources.at) add_at(source, surface_, bounds_, placed);
  take_places(sources);
  take_tree(std::make_shared<SourceTree>(std::move(placed), sizing.grade));
  for (const auto& tree : sources.trees) take_tree(tree);
  has_wishes_ =
      everywhere_ || !areas_.empty() || !fields_.empty() || !tables_.empty() || !trees_.empty();
}

void SizeField::take_places(const PatchSources& sources) {
  const auto take_curve = [this](const Curve& curve) {
    for (int i = 0; i <= kPlacesOnCurve; ++i) {
      places_.push_back(domain_.fold(domain_.clamp(curve.evaluate(double(i) / kPlacesOnCurve))));
    }
  };
  for (const AtSource& source : sources.at) places_.push_back(domain_.clamp(source.at));
  for (const AlongSource& source : sources.along) {
    for (const auto& curve : source.curves) take_curve(*curve);
  }
  for (const InsideSource& source : sources.inside) {
    for (std::size_t i = 0; i < source.polygon.size(); ++i) {
      take_curve(SegmentCurve(source.polygon[i], source.polygon[(i + 1) % source.polygon.size()]));
    }
  }
}

void SizeField::take_tree(std::shared_ptr<const SourceTree> tree) {
  if (!tree->empty()) trees_.push_back(std::move(tree));
}

bool SizeField::has_area_source() const {
  return !length_.is_off() || everywhere_ || !areas_.empty() || !fields_.empty() || !tables_.empty();
}

bool SizeField::has_source() const { return has_area_source() || !trees_.empty(); }

/// The point itself, or one towards the far corner of the domain that lies outside of a rounding.
Uv SizeField::beside_roundings(Uv uv) const {
  for (const RoundedSide& rounded : rounded_sides_) {
    const Uv a = domain_.corner(rounded.side);
    const Uv b = domain_.corner((rounded.side + 1) % domain_.corner_count());
    // The step that leads from the side to the far end of the domain.
    const Uv opposite = domain_.corner((rounded.side + 2) % domain_.corner_count());
    const double distance = cross(b - a, uv - a) / cross(b - a, opposite - a);
    if (distance >= rounded.reach) continue;
    uv = lerp(uv, opposite, (rounded.reach - distance) / (1 - distance));
  }
  return uv;
}

SizeTensor SizeField::size_from_curvature(const Jet& jet) const {
  const PrincipalCurvatures k = principal_curvatures(jet);
  double h1 = bounds_.clamp(length_.of_surface(k.k1));
  double h2 = bounds_.clamp(length_.of_surface(k.k2));
  h1 = std::min(h1, stretch_ * h2);
  h2 = std::min(h2, stretch_ * h1);
  return size_tensor(h1, h2, k.angle);
}

/// The least size on the ring at a parameter distance from a corner, and the ring's least
/// distance from it in space.
double SizeField::least_size_on_ring(Uv corner, double distance, double& radius) const {
  const Vec3 centre = surface_.evaluate(corner, Order::Position).point;
  const double width = domain_.u1 - domain_.u0, height = domain_.v1 - domain_.v0;
  const double towards_u = corner.u == domain_.u0 ? 1 : -1;
  const double towards_v = corner.v == domain_.v0 ? 1 : -1;
  double size = bounds_.hmax;
  radius = INFINITY;
  for (int i = 0; i < kRingSamples; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / (kRingSamples - 1);
    const Uv at{corner.u + towards_u * distance * width * std::cos(angle),
                corner.v + towards_v * distance * height * std::sin(angle)};
    const Jet jet = second_order(beside_roundings(domain_.fold(at)));
    const PrincipalCurvatures k = principal_curvatures(jet);
    const double greatest = std::max(std::abs(k.k1), std::abs(k.k2));
    size = std::min(size, std::max(bounds_.hmin, length_.around_vertex(greatest)));
    radius = std::min(radius, (jet.point - centre).norm());
  }
  return size;
}

SizeField::Disc SizeField::make_disc(const SingularPoint& singular) const {
  // Rings of half the size of the one before, until a ring is as near as half the size on it.
  double radius = 0;
  double distance = 0.5;
  double size = least_size_on_ring(singular.at, distance, radius);
  while (radius > 0.5 * size && 0.5 * distance >= singular.reach) {
    distance *= 0.5;
    size = least_size_on_ring(singular.at, distance, radius);
  }
  return {surface_.evaluate(singular.at, Order::Position).point, radius, size};
}

void SizeField::blend_with_discs(Sample& sample) const {
  for (const Disc& disc : discs_) {
    const double distance = (sample.point - disc.centre).norm();
    if (distance >= 2 * disc.radius) continue;
    const double share = std::min(1.0, 2 - distance / disc.radius);
    SizeTensor& h = sample.size;
    const SizeTensor inside = isotropic(disc.size);
    h = {(1 - share) * h.h11 + share * inside.h11, (1 - share) * h.h12,
         (1 - share) * h.h22 + share * inside.h22};
  }
}

Jet SizeField::second_order(Uv uv) const {
  return (differences_ ? *differences_ : surface_).evaluate(uv, Order::Second);
}

/// Set the size that follows from the curvature, if there is a tangent plane here or beside.
void SizeField::add_curvature(Uv uv, const Jet& jet, Sample& sample) const {
  const Uv place = is_regular(sample.form) ? beside_roundings(uv) : beside_pole(surface_, uv);
  const Jet there = place == uv ? jet : second_order(place);
  if (!is_regular(first_form_factor(there.du, there.dv))) return;
  sample.size = size_from_curvature(there);
  blend_with_discs(sample);
}

SizeTensor SizeField::size_of_field(const FieldSource& field, Uv uv, const Sample& sample) const {
  if (field.metric) {
    return size_from_metric_at(surface_, uv, sample.form, field.metric(uv, sample.point));
  }
  const double size = field.size(uv, sample.point);
  if (!(size > 0 && std::isfinite(size))) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("the size {} that a field wants at (u,v) = ({}, {}) is not positive and "
                    "finite",
                    size, uv.u, uv.v));
  }
  return isotropic(size);
}

void SizeField::add_sources(Uv uv, const Jet& jet, Sample& sample) const {
  SizeTensor& size = sample.size;
  if (everywhere_) size = minimum(size, *everywhere_);
  for (const Area& area : areas_) {
    if (contains(area.polygon, uv)) size = minimum(size, area.size);
  }
  for (const FieldSource& field : fields_) {
    size = minimum(size, bounds_.clamp(size_of_field(field, uv, sample)));
  }
  for (const auto& table : tables_) size = minimum(size, table->at({uv, sample.point, sample.form}).size);
  if (!trees_.empty()) {
    const TangentPlace place = tangent_place(jet);
    for (const auto& tree : trees_) size = tree->minimum_at(place, size);
  }
  // Where stretched sizes cross, their minimum is shorter than both.
  size = bounds_.clamp(size);
}

SizeField::Sample SizeField::at(Uv uv) const {
  uv = domain_.fold(uv);
  const bool is_curved = !length_.is_off();
  const Jet jet = is_curved ? second_order(uv) : surface_.evaluate(uv, Order::First);
  Sample sample;
  sample.point = jet.point;
  sample.form = first_form_factor(jet.du, jet.dv);
  sample.size = isotropic(bounds_.hmax);
  if (is_curved) add_curvature(uv, jet, sample);
  if (has_wishes_) add_sources(uv, jet, sample);
  return sample;
}

}  // namespace surfmesh
