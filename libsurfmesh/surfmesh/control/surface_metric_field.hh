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
      : SurfaceMetricField(surface, control, control.node_metrics()) {}

  /// The same for a part of the patch, in which some of the nodes lie; they must outlive it, too.
  SurfaceMetricField(const Surface& surface, const ControlSpace& control,
                     std::span<const MetricCorner> required_points)
      : surface_(surface), control_(control), required_points_(required_points) {}

  Metric at(Uv uv, QueryHint& hint) const override {
    return at_jet(uv, surface_.evaluate(uv, Order::First), hint);
  }

  Metric at_jet(Uv uv, const Jet& jet, QueryHint& hint) const override {
    return control_.metric({uv, jet.point, first_form_factor(jet.du, jet.dv)}, hint);
  }

  std::span<const MetricCorner> required_points() const override { return required_points_; }

 private:
  const Surface& surface_;
  const ControlSpace& control_;
  std::span<const MetricCorner> required_points_;
};

}  // namespace surfmesh
