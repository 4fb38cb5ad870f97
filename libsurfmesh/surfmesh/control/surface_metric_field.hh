// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Metric from the sizes of a control space and the exact first form of the surface.
class SurfaceMetricField : public MetricField {
 public:
  /// Both must outlive the field.
  SurfaceMetricField(const Surface& surface, const ControlSpace& control)
      : surface_(surface), control_(control) {}

  Metric at(Uv uv, QueryHint& hint) const override {
    return at_jet(uv, surface_.evaluate(uv, Order::First), hint);
  }

  Metric at_jet(Uv uv, const Jet& jet, QueryHint& hint) const override {
    return control_.metric({uv, jet.point, first_form_factor(jet.du, jet.dv)}, hint);
  }

  std::span<const MetricCorner> required_points() const override { return control_.node_metrics(); }

 private:
  const Surface& surface_;
  const ControlSpace& control_;
};

}  // namespace surfmesh
