// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/metric_field.hh"

/// Metrics with a closed form, so that stages are tested without surfaces.
namespace surfmesh::testing {

/// A metric given by a function of (u,v), which counts how often it is asked for.
class FunctionField : public MetricField {
 public:
  explicit FunctionField(std::function<Metric(Uv)> function) : function_(std::move(function)) {}

  Metric at(Uv uv, QueryHint& hint) const override {
    ++queries_;
    ++hint.answers.triangle;
    return function_(uv);
  }

  Metric operator()(Uv uv) const { return function_(uv); }
  std::size_t queries() const { return queries_; }

 private:
  std::function<Metric(Uv)> function_;
  mutable std::size_t queries_ = 0;
};

inline FunctionField constant_field(const Metric& m) {
  return FunctionField([m](Uv) { return m; });
}

inline Metric isotropic_metric(double size) { return {1 / (size * size), 0, 1 / (size * size)}; }

/// One size in all directions, a function of (u,v).
inline FunctionField isotropic_field(const std::function<double(Uv)>& size) {
  return FunctionField([size](Uv p) { return isotropic_metric(size(p)); });
}

inline FunctionField isotropic_field(double size) { return constant_field(isotropic_metric(size)); }

/// One wanted length everywhere on a surface, which must outlive the field.
inline FunctionField isotropic_field_on(const Surface& surface, double size) {
  return FunctionField([&surface, size](Uv uv) {
    const Jet jet = surface.evaluate(uv, Order::First);
    return metric_from_size(first_form_factor(jet.du, jet.dv), {size, 0, size});
  });
}

/// Sizes at the corners of the unit square, 0.005 and 0.05 by turns, averaged with the inverse
/// squared distances as weights: the case c1 at `scale` 1; larger scales ask for smaller sizes.
inline double four_point_size(Uv p, double scale = 1) {
  struct Corner {
    Uv at;
    double size;
  };
  constexpr std::array<Corner, 4> corners = {
      {{{0, 0}, 0.005}, {{1, 1}, 0.005}, {{1, 0}, 0.05}, {{0, 1}, 0.05}}};
  double sum = 0, weights = 0;
  for (const Corner& corner : corners) {
    // Multiplied by all squared distances, so that corners need no case of their own.
    double weight = 1;
    for (const Corner& other : corners) {
      const Uv step = p - other.at;
      if (!(other.at == corner.at)) weight *= step.u * step.u + step.v * step.v;
    }
    sum += weight * corner.size;
    weights += weight;
  }
  return sum / weights / scale;
}

inline FunctionField four_point_field(double scale = 1) {
  return isotropic_field([scale](Uv p) { return four_point_size(p, scale); });
}

/// Sizes along and across a unit direction.
inline Metric directed_metric(Uv along, double size_along, double size_across) {
  const double a = 1 / (size_along * size_along), b = 1 / (size_across * size_across);
  const double c = along.u, s = along.v;
  return {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
}

/// A shock through the middle of the unit square at 30°: size `along` everywhere along it, across
/// it along / aspect, growing by 0.3 per unit of distance up to `along`.
inline FunctionField shock_field(double aspect, double along = 0.1) {
  return FunctionField([aspect, along](Uv p) {
    const Uv direction{std::cos(std::numbers::pi / 6), std::sin(std::numbers::pi / 6)};
    const double distance = std::abs(cross(direction, p - Uv{0.5, 0.5}));
    return directed_metric(direction, along, std::min(along, along / aspect + 0.3 * distance));
  });
}

/// A layer around the circle of radius 0.3 in the middle of the unit square: size `across` the
/// layer, growing by 0.3 per unit of distance; along it as long as the sagitta is 0.05 of that.
inline FunctionField ring_field(double across) {
  return FunctionField([across](Uv p) {
    constexpr double circle = 0.3, sagitta = 0.05;
    const Uv step = p - Uv{0.5, 0.5};
    const double radius = std::hypot(step.u, step.v);
    const double size = across + 0.3 * std::abs(radius - circle);
    if (radius == 0) return isotropic_metric(size);
    const double along = std::max(size, std::sqrt(8 * sagitta * radius * size));
    return directed_metric({-step.v / radius, step.u / radius}, along, size);
  });
}

/// The same field seen from parameters that are multiplied by u_scale and v_scale.
inline FunctionField with_scaled_parameters(const FunctionField& field, double u_scale,
                                            double v_scale) {
  return FunctionField([field, u_scale, v_scale](Uv p) {
    const Metric m = field({p.u / u_scale, p.v / v_scale});
    return Metric{m.m11 / (u_scale * u_scale), m.m12 / (u_scale * v_scale),
                  m.m22 / (v_scale * v_scale)};
  });
}

/// ∫√det M over the unit square by the midpoint rule: the number of unit squares.
inline double metric_area(const FunctionField& field, int count = 1000) {
  double sum = 0;
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      sum += std::sqrt(determinant(field({(i + 0.5) / count, (j + 0.5) / count})));
    }
  }
  return sum / count / count;
}

/// Number of unit triangles that fill the unit square.
inline double ideal_triangles(const FunctionField& field) {
  return metric_area(field) / (0.25 * std::numbers::sqrt3);
}

}  // namespace surfmesh::testing
