// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/parameter_curve.hh"

#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>

#include <cmath>
#include <utility>

#include "surfmesh/nurbs/nurbs_curve.hh"
#include "surfmesh_cad/spline_net.hh"

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

/// A curve of the file by its own object, which keeps nothing between calls.
class FileCurve : public Curve {
 public:
  FileCurve(Handle(Geom2d_Curve) curve, double first, double last)
      : curve_(std::move(curve)), first_(first), last_(last) {}

  Uv evaluate(double t) const override { return at(*curve_, std::lerp(first_, last_, t)); }

 private:
  Handle(Geom2d_Curve) curve_;
  double first_;
  double last_;
};

/// A curve that is moved by a step of its own at each end.
class PinnedCurve : public Curve {
 public:
  PinnedCurve(std::shared_ptr<const Curve> curve, const ParameterCurve& given)
      : curve_(std::move(curve)),
        move_first_(given.move_first),
        move_last_(given.move_last),
        start_(given.start()),
        end_(given.end()) {}

  Uv evaluate(double t) const override {
    if (t == 0) return start_;
    if (t == 1) return end_;
    return curve_->evaluate(t) + lerp(move_first_, move_last_, t);
  }

 private:
  std::shared_ptr<const Curve> curve_;
  Uv move_first_;
  Uv move_last_;
  Uv start_;
  Uv end_;
};

/// Splines are evaluated as polynomials, in a third of the time; but files may go on beyond knots.
std::shared_ptr<const Curve> file_curve(const ParameterCurve& given) {
  Handle(Geom2d_Curve) curve = untrimmed(given.curve);
  if (!Handle(Geom2d_BezierCurve)::DownCast(curve).IsNull()) {
    curve = Geom2dConvert::CurveToBSplineCurve(curve);
  }
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
  const bool is_within =
      !spline.IsNull() && (spline->IsPeriodic() || (given.first >= spline->FirstParameter() &&
                                                    given.last <= spline->LastParameter()));
  if (!is_within) return std::make_shared<FileCurve>(curve, given.first, given.last);
  return std::make_shared<NurbsCurve>(spline_polygon(spline, given.first, given.last),
                                      CurveRange{given.first, given.last});
}

}  // namespace

Uv ParameterCurve::start() const { return at(*curve, first) + move_first; }

Uv ParameterCurve::end() const { return at(*curve, last) + move_last; }

std::shared_ptr<const Curve> make_curve(const ParameterCurve& curve) {
  if (!Handle(Geom2d_Line)::DownCast(untrimmed(curve.curve)).IsNull()) {
    return std::make_shared<SegmentCurve>(curve.start(), curve.end());
  }
  return std::make_shared<PinnedCurve>(file_curve(curve), curve);
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
