// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/model/surface_walk.hh"
#include "surfmesh/quad/corner_terms.hh"

namespace surfmesh {

/// A symmetric matrix in space.
struct SpaceTensor {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Vec3 operator*(const Vec3& e) const {
    return {xx * e.x() + xy * e.y() + xz * e.z(), xy * e.x() + yy * e.y() + yz * e.z(),
            xz * e.x() + yz * e.y() + zz * e.z()};
  }

  double squared_length(const Vec3& e) const { return e.dot(*this * e); }

  friend SpaceTensor operator+(const SpaceTensor& a, const SpaceTensor& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
  }
};

/// A vertex on the surface of a model with the metric there, as a tensor in space, so that vertices
/// of different patches can be measured against each other.
///
/// A step in the chart has its metric length: the two axes are unit steps, at right angles in the
/// metric.
struct VertexChart {
  /// Share of a step, squared, within which two steps count as the same.
  static constexpr double kSameStep = 0.25;

  SurfacePlace place;
  bool meets_itself = false;      ///< the patch does, at a contour
  Metric metric;                  ///< in (u,v) of the patch
  Uv u_axis, v_axis;              ///< the axes as steps in (u,v)
  Vec3 point, x, y;               ///< position; the axes as steps in space
  Eigen::Matrix3d from_space;     ///< takes a step in space to (x, y) and the part along the normal
  Vec3 normal;                    ///< of length 1, on the side from which the mesh goes around
  SpaceTensor tensor;             ///< the metric in space, with the mean size along the normal
  double density = 0;             ///< √det M in space: metric area of a unit of area
  double area_of_parameters = 0;  ///< √det M in (u,v); negative for patches that are turned

  /// A step in space as the chart sees it, with the part along the normal in the mean size.
  Vec3 in_chart(const Vec3& step) const { return from_space * step; }

  /// Sine in the metric of the angle from one step in (u,v) to another, positive if they are
  /// counter-clockwise as the mesh goes around the patch.
  double sine(Uv a, Uv b) const {
    const double product = squared_length(metric, a) * squared_length(metric, b);
    return product > 0 ? area_of_parameters * cross(a, b) / std::sqrt(product) : 0;
  }

  Uv in_parameters(ChartStep step) const { return step.x * u_axis + step.y * v_axis; }

  /// True if a straight line in (u,v) leads to another chart: it lies on the same patch and not
  /// beyond a contour at which the patch meets itself.
  bool is_beside(const VertexChart& other) const {
    if (place.patch != other.place.patch) return false;
    if (!meets_itself) return true;
    const Vec3 step = in_chart(other.point - point);
    const Uv ahead = in_parameters({step.x(), step.y()});
    return squared_length(metric, other.place.uv - place.uv - ahead) <
           kSameStep * squared_length(metric, ahead);
  }

  Vec3 in_space(ChartStep step) const { return step.x * x + step.y * y; }
};

/// Makes charts of vertices, and moves them over the surface.
class ChartMaker {
 public:
  /// `is_turned` is 1 for patches that the mesh goes around the other way. All must outlive this.
  ChartMaker(const Model& model, const std::vector<const MetricField*>& fields,
             const SurfaceWalk& walk, const std::vector<char>& is_turned);

  /// The chart at a place; nothing where surface or metric are singular.
  /// Cost     an evaluation of first order and a metric query
  std::optional<VertexChart> make(const SurfacePlace& place);

  /// The same with a metric that is known, without a query.
  std::optional<VertexChart> make(const SurfacePlace& place, const Metric& metric) const;

  /// The chart after a step; nothing where that leads off the surface, or to where it is singular.
  std::optional<VertexChart> move(const VertexChart& from, ChartStep step);

  /// True if a contour has two uses on a patch.
  bool meets_itself(int patch) const { return meets_itself_[static_cast<std::size_t>(patch)] != 0; }

  /// True if the mesh goes around a patch the other way.
  bool is_turned(int patch) const { return is_turned_[static_cast<std::size_t>(patch)] != 0; }

  /// Queries of the metric fields so far.
  QueryCounts queries() const;

 private:
  std::optional<VertexChart> make(const SurfacePlace& place, const Jet& jet,
                                  const Metric& metric) const;

  const Model& model_;
  const std::vector<const MetricField*>& fields_;
  const SurfaceWalk& walk_;
  const std::vector<char>& is_turned_;
  std::vector<char> meets_itself_;  ///< by patch
  std::vector<QueryHint> hints_;    ///< by patch
};

}  // namespace surfmesh
