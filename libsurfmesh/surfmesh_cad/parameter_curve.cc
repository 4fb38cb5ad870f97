// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/parameter_curve.hh"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>

#include <cmath>
#include <utility>

namespace surfmesh {
namespace {

Uv at(const Geom2d_Curve& curve, double parameter) {
  gp_Pnt2d point;
  curve.D0(parameter, point);
  return {point.X(), point.Y()};
}

/// The curve itself: what is trimmed is only another range of it.
Handle(Geom2d_Curve) untrimmed(Handle(Geom2d_Curve) curve) {
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) {
    curve = trimmed->BasisCurve();
  }
  return curve;
}

/// Evaluates the file's curve, which keeps nothing between calls, and pins it at its ends.
class PinnedCurve : public Curve {
 public:
  explicit PinnedCurve(ParameterCurve curve)
      : curve_(std::move(curve)), start_(curve_.start()), end_(curve_.end()) {}

  Uv evaluate(double t) const override {
    if (t == 0) return start_;
    if (t == 1) return end_;
    const Uv point = at(*curve_.curve, std::lerp(curve_.first, curve_.last, t));
    return point + lerp(curve_.move_first, curve_.move_last, t);
  }

 private:
  ParameterCurve curve_;
  Uv start_;
  Uv end_;
};

}  // namespace

Uv ParameterCurve::start() const { return at(*curve, first) + move_first; }

Uv ParameterCurve::end() const { return at(*curve, last) + move_last; }

std::shared_ptr<const Curve> make_curve(const ParameterCurve& curve) {
  if (!Handle(Geom2d_Line)::DownCast(untrimmed(curve.curve)).IsNull()) {
    return std::make_shared<SegmentCurve>(curve.start(), curve.end());
  }
  return std::make_shared<PinnedCurve>(curve);
}

std::vector<double> corners_of(const ParameterCurve& curve) {
  std::vector<double> corners;
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(untrimmed(curve.curve));
  if (spline.IsNull()) return corners;
  for (Standard_Integer k = 2; k < spline->NbKnots(); ++k) {
    const double t = (spline->Knot(k) - curve.first) / (curve.last - curve.first);
    if (spline->Multiplicity(k) >= spline->Degree() && t > 0 && t < 1) corners.push_back(t);
  }
  return corners;
}

}  // namespace surfmesh
