// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/size_field.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/curvature.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

/// Where the first form is singular (a pole), sizes are taken this share of the way to the middle
/// of the domain: near enough to be those of the pole, far enough for full accuracy.
constexpr double kStepFromPole = 1e-3;

/// Rays on which the ring around an extraordinary vertex is sampled, from side to side.
constexpr int kRingSamples = 5;

void check(bool is_good, const char* member, double value, const char* range) {
  if (!is_good) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("sizing.{} = {} is outside its range: {}", member, value, range));
  }
}

}  // namespace

SizeField::SizeField(const Surface& surface, const Sizing& sizing,
                     const std::vector<EverywhereSource>& everywhere, double diagonal)
    : surface_(surface),
      domain_(surface.domain()),
      diagonal_(diagonal),
      factor_(sizing.curvature),
      hmin_(sizing.hmin.in_units(diagonal)),
      hmax_(sizing.hmax.in_units(diagonal)),
      stretch_(sizing.stretch),
      rounded_sides_(surface.rounded_sides()) {
  check(factor_ >= 0 && std::isfinite(factor_), "curvature", factor_, "0 (off) or above");
  check(hmin_ > 0 && std::isfinite(hmin_), "hmin", hmin_, "above 0");
  check(hmax_ >= hmin_ && std::isfinite(hmax_), "hmax", hmax_, "at least hmin");
  check(stretch_ >= 1, "stretch", stretch_, "1 or above");
  for (const EverywhereSource& source : everywhere) {
    const SizeTensor size = clamp(tensor(source.size));
    everywhere_ = everywhere_ ? clamp(minimum(*everywhere_, size)) : size;
  }
  if (factor_ == 0) return;
  for (const SingularPoint& singular : surface.singular_points()) {
    discs_.push_back(make_disc(singular));
  }
}

SizeTensor SizeField::clamp(const SizeTensor& size) const {
  return clamp_sizes(size, hmin_, hmax_);
}

SizeTensor SizeField::tensor(const Size& size) const {
  const double along = size.along.in_units(diagonal_), across = size.across.in_units(diagonal_);
  if (!(along > 0 && across > 0 && std::isfinite(along) && std::isfinite(across))) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a size of [{}, {}] is not positive and finite", along, across));
  }
  if (!std::isfinite(size.angle)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the angle {} of a size is not finite", size.angle));
  }
  return size_tensor(along, across, size.angle);
}

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

/// A point near one without a tangent plane that has one; the point itself if there is none.
Uv SizeField::beside_pole(Uv uv) const {
  // Towards the middle first, which is inside; then across, for lines through the middle.
  for (const Uv target : {domain_.at(0.5, 0.5), domain_.at(0.25, 0.4), domain_.at(0.6, 0.25)}) {
    const Uv place = lerp(uv, target, kStepFromPole);
    const Jet jet = surface_.evaluate(place, Order::First);
    if (is_regular(first_form_factor(jet.du, jet.dv))) return place;
  }
  return uv;
}

SizeTensor SizeField::size_from_curvature(const Jet& jet) const {
  const PrincipalCurvatures k = principal_curvatures(jet);
  double h1 = std::clamp(factor_ / std::abs(k.k1), hmin_, hmax_);
  double h2 = std::clamp(factor_ / std::abs(k.k2), hmin_, hmax_);
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
  double size = hmax_;
  radius = INFINITY;
  for (int i = 0; i < kRingSamples; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / (kRingSamples - 1);
    const Uv at{corner.u + towards_u * distance * width * std::cos(angle),
                corner.v + towards_v * distance * height * std::sin(angle)};
    const Jet jet = surface_.evaluate(beside_roundings(domain_.fold(at)), Order::Second);
    const PrincipalCurvatures k = principal_curvatures(jet);
    const double greatest = std::max(std::abs(k.k1), std::abs(k.k2));
    size = std::min(size, std::max(hmin_, factor_ / greatest));
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

SizeField::Sample SizeField::at(Uv uv) const {
  uv = domain_.fold(uv);
  Jet jet = surface_.evaluate(uv, factor_ > 0 ? Order::Second : Order::First);
  Sample sample;
  sample.point = jet.point;
  sample.form = first_form_factor(jet.du, jet.dv);
  sample.size = isotropic(hmax_);
  if (factor_ > 0) {
    const Uv place = is_regular(sample.form) ? beside_roundings(uv) : beside_pole(uv);
    if (!(place == uv)) jet = surface_.evaluate(place, Order::Second);
    if (!is_regular(first_form_factor(jet.du, jet.dv))) return sample;  // no curvature here
    sample.size = size_from_curvature(jet);
    blend_with_discs(sample);
  }
  // Where stretched sizes cross, their minimum is shorter than both.
  if (everywhere_) sample.size = clamp(minimum(sample.size, *everywhere_));
  return sample;
}

}  // namespace surfmesh
