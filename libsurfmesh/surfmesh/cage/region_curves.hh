// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "surfmesh/cage/chart_surface.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// A side of a face, in the face's parameters.
struct FaceSide {
  std::shared_ptr<const Surface> surface;
  Uv from;
  Uv to;
};

/// Sides of faces end to end, as they lie in a chart. Each is the same share of t.
class SidesInChart : public Curve {
 public:
  SidesInChart(const ChartFrame& frame, std::vector<FaceSide> sides)
      : frame_(frame), sides_(std::move(sides)) {}

  /// Cost     one evaluation of a face
  Uv evaluate(double t) const override;

 private:
  ChartFrame frame_;
  std::vector<FaceSide> sides_;
};

/// A cubic B-spline of uniform knots from the first of its control points to the last.
class UniformSpline : public Curve {
 public:
  /// Pre      two points or more
  explicit UniformSpline(std::vector<Uv> points) : points_(std::move(points)) {}

  Uv evaluate(double t) const override;

 private:
  Uv control_point(int i) const;

  std::vector<Uv> points_;
};

/// A curve in a chart, as it lies in the frame of another one.
class CurveOfOtherChart : public Curve {
 public:
  CurveOfOtherChart(std::shared_ptr<const Chart> other, std::shared_ptr<const Curve> curve,
                    const ChartFrame& frame)
      : other_(std::move(other)), curve_(std::move(curve)), frame_(frame) {}

  /// Cost     one evaluation of the other chart
  Uv evaluate(double t) const override;

 private:
  std::shared_ptr<const Chart> other_;
  std::shared_ptr<const Curve> curve_;
  ChartFrame frame_;
};

/// Points with the zigzag taken out of them: each becomes the mean of itself and its neighbours, so
/// many times. The ends stay.
std::vector<Uv> smoothed(std::vector<Uv> points, int times);

}  // namespace surfmesh
