// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/file_points.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"

namespace surfmesh {

Jet file_jet(const Geom_Surface& surface, Uv uv, Order order) {
  Jet jet;
  gp_Pnt point;
  if (order == Order::Position) {
    surface.D0(uv.u, uv.v, point);
    jet.point = to_vec3(point);
    return jet;
  }
  gp_Vec du, dv;
  if (order == Order::First) {
    surface.D1(uv.u, uv.v, point, du, dv);
  } else {
    gp_Vec duu, dvv, duv;
    surface.D2(uv.u, uv.v, point, du, dv, duu, dvv, duv);
    jet.duu = to_vec3(duu);
    jet.duv = to_vec3(duv);
    jet.dvv = to_vec3(dvv);
  }
  jet.point = to_vec3(point);
  jet.du = to_vec3(du);
  jet.dv = to_vec3(dv);
  return jet;
}

const Jet& finite(const Jet& jet, Uv uv, Order order) {
  bool is_finite = jet.point.allFinite();
  if (order != Order::Position) is_finite = is_finite && jet.du.allFinite() && jet.dv.allFinite();
  if (order == Order::Second) {
    is_finite = is_finite && jet.duu.allFinite() && jet.duv.allFinite() && jet.dvv.allFinite();
  }
  if (!is_finite) fail_evaluation(uv);
  return jet;
}

void fail_evaluation(Uv uv) {
  throw Error(ErrorCode::Geometry,
              fmt::format("the surface cannot be evaluated at (u,v) = ({}, {})", uv.u, uv.v));
}

}  // namespace surfmesh
