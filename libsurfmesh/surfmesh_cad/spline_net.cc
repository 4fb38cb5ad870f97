// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/spline_net.hh"

#include <fmt/format.h>

#include <Standard_Handle.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/turns.hh"

namespace surfmesh {
namespace {

/// Beyond an end of a period by less than this share of it, nothing is repeated.
constexpr double kPeriodSlack = 1e-13;

/// Splines that are repeated to more points are damaged: files have none as large.
constexpr std::size_t kMostPoints = 1 << 24;

/// The periods that cover a range, as numbers from the one that the knots are given for on. One
/// that is not periodic is there once.
struct Repeats {
  int first = 0;
  int last = 0;
  double period = 0;
};

/// Throws   Geometry if there are more than kMostTurns
Repeats repeats(double start, double period, double from, double to) {
  const double turns = std::max(std::abs(from - start), std::abs(to - start)) / period;
  if (!(turns <= kMostTurns)) {
    throw Error(ErrorCode::Geometry,
                fmt::format("it is {:.3g} periods away from where its spline starts", turns));
  }
  const int first = static_cast<int>(std::floor((from - start) / period + kPeriodSlack));
  const int end = static_cast<int>(std::ceil((to - start) / period - kPeriodSlack));
  return {first, std::max(first, end - 1), period};
}

/// The knots of clamped splines that follow each other, end to end. The last point of each is the
/// first of the next, so the knot between them counts once less than at the ends.
std::vector<double> knots_of(const TColStd_Array1OfReal& knots,
                             const TColStd_Array1OfInteger& counts, const Repeats& repeats) {
  std::vector<double> all;
  for (int r = repeats.first; r <= repeats.last; ++r) {
    for (Standard_Integer k = knots.Lower(); k <= knots.Upper(); ++k) {
      int count = counts(k);
      if (k == knots.Lower() && r > repeats.first) count = 0;
      if (k == knots.Upper() && r < repeats.last) count -= 1;
      all.insert(all.end(), static_cast<std::size_t>(count), knots(k) + r * repeats.period);
    }
  }
  return all;
}

/// The numbers of the points of such splines, in their order.
std::vector<Standard_Integer> points_of(Standard_Integer count, const Repeats& repeats) {
  std::vector<Standard_Integer> all;
  for (int r = repeats.first; r <= repeats.last; ++r) {
    for (Standard_Integer p = r == repeats.first ? 1 : 2; p <= count; ++p) all.push_back(p);
  }
  return all;
}

}  // namespace

NurbsNet spline_net(const Handle(Geom_BSplineSurface) & surface, const Domain& domain) {
  Repeats along_u, along_v;
  const Handle(Geom_BSplineSurface) clamped =
      Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
  if (surface->IsUPeriodic()) {
    along_u = repeats(surface->UKnot(1), surface->UPeriod(), domain.u0, domain.u1);
    clamped->SetUNotPeriodic();
  }
  if (surface->IsVPeriodic()) {
    along_v = repeats(surface->VKnot(1), surface->VPeriod(), domain.v0, domain.v1);
    clamped->SetVNotPeriodic();
  }
  NurbsNet net;
  net.degree = {clamped->UDegree(), clamped->VDegree()};
  net.knots = {knots_of(clamped->UKnots(), clamped->UMultiplicities(), along_u),
               knots_of(clamped->VKnots(), clamped->VMultiplicities(), along_v)};
  const bool is_rational = clamped->IsURational() || clamped->IsVRational();
  const std::vector<Standard_Integer> columns = points_of(clamped->NbUPoles(), along_u);
  const std::vector<Standard_Integer> rows = points_of(clamped->NbVPoles(), along_v);
  if (columns.size() > kMostPoints / rows.size()) {
    throw Error(ErrorCode::Geometry,
                fmt::format("it takes {} x {} points of its spline", columns.size(), rows.size()));
  }
  for (const Standard_Integer j : rows) {
    auto& points = net.points.emplace_back();
    if (is_rational) net.weights.emplace_back();
    for (const Standard_Integer i : columns) {
      const gp_Pnt& pole = clamped->Pole(i, j);
      points.emplace_back(pole.X(), pole.Y(), pole.Z());
      if (is_rational) net.weights.back().push_back(clamped->Weight(i, j));
    }
  }
  return net;
}

NurbsPolygon spline_polygon(const Handle(Geom2d_BSplineCurve) & curve, double from, double to) {
  Repeats along;
  const Handle(Geom2d_BSplineCurve) clamped = Handle(Geom2d_BSplineCurve)::DownCast(curve->Copy());
  if (curve->IsPeriodic()) {
    along = repeats(curve->Knot(1), curve->Period(), from, to);
    clamped->SetNotPeriodic();
  }
  NurbsPolygon polygon;
  polygon.degree = clamped->Degree();
  polygon.knots = knots_of(clamped->Knots(), clamped->Multiplicities(), along);
  for (const Standard_Integer p : points_of(clamped->NbPoles(), along)) {
    const gp_Pnt2d& pole = clamped->Pole(p);
    polygon.points.push_back({pole.X(), pole.Y()});
    if (clamped->IsRational()) polygon.weights.push_back(clamped->Weight(p));
  }
  return polygon;
}

}  // namespace surfmesh
