// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "surfmesh/control/metric_field.hh"

/// Metrics with a closed form.
namespace surfmesh::testing {

/// A metric given by a function of (u,v).
class CallableField : public MetricField {
 public:
  explicit CallableField(std::function<Metric(Uv)> function) : function_(std::move(function)) {}

  Metric at(Uv uv, Hint&) const override { return function_(uv); }

 private:
  std::function<Metric(Uv)> function_;
};

inline CallableField constant_field(const Metric& metric) {
  return CallableField([=](Uv) { return metric; });
}

/// One wanted length everywhere, in the parameters themselves.
inline CallableField size_field(double size) {
  return constant_field({1 / (size * size), 0, 1 / (size * size)});
}

/// A wanted length given by a function of (u,v), in the parameters themselves.
inline CallableField size_field(const std::function<double(Uv)>& size) {
  return CallableField([=](Uv uv) {
    const double h = size(uv);
    return Metric{1 / (h * h), 0, 1 / (h * h)};
  });
}

/// One wanted length everywhere on a surface, which must outlive the field.
inline CallableField size_field_on(const Surface& surface, double size) {
  return CallableField([&surface, size](Uv uv) {
    const Jet jet = surface.evaluate(uv, Order::First);
    return metric_from_size(first_form_factor(jet.du, jet.dv), {size, 0, size});
  });
}

}  // namespace surfmesh::testing
