// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/field_size.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/sizes/source_place.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

/// Samples of the surface along each side of a box, by the cells that it spans.
constexpr int kFewestSamples = 3;
constexpr int kMostSamples = 9;

/// Margin around samples, as a share of their range. Between three samples a quadratic function
/// leaves their range by an eighth of it at most.
constexpr double kMarginShare = 0.25;

/// Share of the domain below which boxes at a pole are not divided any more.
constexpr double kPoleShare = 1.0 / 64;

/// What a field reads of the surface in a box.
struct BoxSamples {
  std::vector<SurfacePoint> points;
  Eigen::AlignedBox3d positions;
};

int samples_across(double share, int cells) {
  return std::clamp(2 * static_cast<int>(std::ceil(share * cells)) + 1, kFewestSamples,
                    kMostSamples);
}

Uv shares_of(const Domain& domain, const UvBox& box) {
  return {box.u.width() / (domain.u1 - domain.u0), box.v.width() / (domain.v1 - domain.v0)};
}

SurfacePoint point_at(const FieldSource& field, const Surface& surface, Uv uv) {
  if (field.metric) {
    const Jet jet = surface.evaluate(uv, Order::First);
    return {uv, jet.point, first_form_factor(jet.du, jet.dv)};
  }
  if (!field.uses_position) return {uv, Vec3::Constant(kUnset), {}};
  return {uv, surface.evaluate(uv, Order::Position).point, {}};
}

BoxSamples sample_box(const FieldSource& field, const Surface& surface, const UvBox& box) {
  const Domain domain = surface.domain();
  const Uv shares = shares_of(domain, box);
  const int columns = samples_across(shares.u, surface.cells().u);
  const int rows = samples_across(shares.v, surface.cells().v);
  BoxSamples samples;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Uv uv = {std::lerp(box.u.lower, box.u.upper, double(i) / (columns - 1)),
                     std::lerp(box.v.lower, box.v.upper, double(j) / (rows - 1))};
      samples.points.push_back(point_at(field, surface, domain.fold(uv)));
      samples.positions.extend(samples.points.back().point);
    }
  }
  const Vec3 margin = kMarginShare * samples.positions.sizes();
  samples.positions.min() -= margin;
  samples.positions.max() += margin;
  return samples;
}

Interval with_margin(const Interval& range) {
  const double margin = kMarginShare * range.width();
  return {range.lower - margin, range.upper + margin};
}

/// The range of one entry of the first form's factor, with a margin.
Interval range_of(const std::vector<SurfacePoint>& points, double FirstFormFactor::*entry) {
  Interval range = Interval::of(points[0].form.*entry);
  for (const SurfacePoint& point : points) {
    range = hull(range, Interval::of(point.form.*entry));
  }
  return with_margin(range);
}

/// The greatest eigenvalue of I⁻¹ M, that is of N = M_p⁻¹ M M_p⁻ᵀ, grows with n11, n22 and |n12|.
double greatest_eigenvalue(const MetricBounds& m, const std::vector<SurfacePoint>& points) {
  const Interval l11 = range_of(points, &FirstFormFactor::l11);
  const Interval l22 = range_of(points, &FirstFormFactor::l22);
  const Interval skew = range_of(points, &FirstFormFactor::l21) / l11;
  const double n11 = (m.m11 / square(l11)).upper;
  const double n12 = abs((m.m12 - skew * m.m11) / (l11 * l22)).upper;
  const Interval twice = Interval::of(2) * skew * m.m12;
  const double n22 = ((m.m22 - twice + square(skew) * m.m11) / square(l22)).upper;
  return 0.5 * (n11 + n22) + std::hypot(0.5 * (n11 - n22), n12);
}

double least_of_metric(const FieldSource& field, const Surface& surface, const UvBox& box) {
  const BoxSamples samples = sample_box(field, surface, box);
  const bool is_regular = range_of(samples.points, &FirstFormFactor::l11).lower > 0 &&
                          range_of(samples.points, &FirstFormFactor::l22).lower > 0;
  if (is_regular) {
    const double square_of_inverse =
        greatest_eigenvalue(field.metric_bounds(box, samples.positions), samples.points);
    return square_of_inverse > 0 ? 1 / std::sqrt(square_of_inverse) : 0;  // 0 for NaN
  }
  const Uv shares = shares_of(surface.domain(), box);
  if (std::max(shares.u, shares.v) > kPoleShare) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& point : samples.points) {
    least = std::min(least, size_range(size_of_field(field, surface, point)).least);
  }
  return least;
}

SizeTensor size_of(const FieldSource& field, const Surface& surface, const SurfacePoint& at) {
  if (field.metric) {
    return size_from_metric_at(surface, at.uv, at.form, field.metric(at.uv, at.point));
  }
  const double size = field.size(at.uv, at.point);
  if (!(size > 0 && std::isfinite(size))) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("the size {} that a field wants at (u,v) = ({}, {}) is not positive and "
                    "finite",
                    size, at.uv.u, at.uv.v));
  }
  return isotropic(size);
}

}  // namespace

SizeTensor size_of_field(const FieldSource& field, const Surface& surface, const SurfacePoint& at) {
  return at_source(field, [&] { return size_of(field, surface, at); });
}

double least_length(const FieldSource& field, const Surface& surface, Uv uv) {
  return size_range(size_of_field(field, surface, point_at(field, surface, uv))).least;
}

FirstFormBounds first_form_in(const Surface& surface, const UvBox& box) {
  FieldSource metric;
  metric.metric = [](Uv, const Vec3&) { return Metric(); };  // so that samples have first forms
  const BoxSamples samples = sample_box(metric, surface, box);
  std::optional<FirstFormBounds> all;
  for (const SurfacePoint& point : samples.points) {
    const FirstFormFactor& p = point.form;
    const FirstFormBounds here = {Interval::of(p.l11 * p.l11), Interval::of(p.l11 * p.l21),
                                  Interval::of(p.l21 * p.l21 + p.l22 * p.l22)};
    if (!all) all = here;
    all = {hull(all->e, here.e), hull(all->f, here.f), hull(all->g, here.g)};
  }
  return {with_margin(all->e), with_margin(all->f), with_margin(all->g)};
}

double least_length_in(const FieldSource& field, const Surface& surface, const UvBox& box) {
  if (field.metric) return least_of_metric(field, surface, box);
  if (!field.uses_position) return field.size_bounds(box, {}).lower;
  return field.size_bounds(box, sample_box(field, surface, box).positions).lower;
}

}  // namespace surfmesh
