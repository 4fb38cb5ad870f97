// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <BRep_Tool.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <ostream>
#include <string>

#include "cad/own_shapes.hh"
#include "surfmesh_cad/face_loops.hh"
#include "surfmesh_cad/face_surface.hh"
#include "surfmesh_cad/file_points.hh"

namespace surfmesh {
namespace {

/// The greatest difference of two jets, in units of the size of each.
double difference(const Jet& a, const Jet& b) {
  double greatest = 0;
  for (const auto& member : {&Jet::point, &Jet::du, &Jet::dv, &Jet::duu, &Jet::duv, &Jet::dvv}) {
    greatest = std::max(greatest, (a.*member - b.*member).norm() / (1 + (b.*member).norm()));
  }
  return greatest;
}

/// Our surfaces are those of the file, whichever way they are evaluated.
class CadSurfaces : public ::testing::TestWithParam<std::string> {};

TEST_P(CadSurfaces, AreThoseOfTheFile) {
  const TopoDS_Shape shape = testing::own_shape(GetParam()).make();
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    const FaceBoundary boundary = face_boundary(face);
    const auto surface = face_surface(surface_of(face), boundary.domain);
    const Handle(Geom_Surface) given = BRep_Tool::Surface(face);
    for (int i = 0; i <= 100; ++i) {
      const Domain domain = surface->domain();
      const Uv uv = domain.at(0.02 + 0.0095 * i, std::fmod(0.03 + 0.618 * i, 1));
      const Jet jet = surface->evaluate(uv, Order::Second);
      constexpr double kRounding = 1e-8;
      EXPECT_LT(difference(jet, file_jet(*given, uv, Order::Second)), kRounding)
          << uv.u << ' ' << uv.v;
      EXPECT_TRUE(jet.du.isApprox(surface->evaluate(uv, Order::First).du));
      EXPECT_TRUE(jet.point.isApprox(surface->evaluate(uv, Order::Position).point));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Some, CadSurfaces,
                         ::testing::Values("box", "cone", "sphere", "torus", "mirrored",
                                           "revolved_spline", "hill", "offset_hill", "pipe",
                                           "spring", "nurbs_torus", "periodic_prism", "ellipsoid",
                                           "fillet_uneven", "thread"),
                         [](const auto& test) { return test.param; });

/// Periodic splines go on beyond the ends of their period.
TEST(CadSplines, MayCrossTheEndOfTheirPeriod) {
  const TopoDS_Shape shape = testing::own_shape("periodic_prism").make();
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const Handle(Geom_Surface) given = surface_of(TopoDS::Face(it.Current()));
    if (!given->IsUPeriodic()) continue;
    const double period = given->UPeriod();
    const auto surface = face_surface(given, {0.3 * period, 1.3 * period, 0, 1});
    EXPECT_GT(surface->cells().u, 3);
    for (int i = 0; i <= 20; ++i) {
      const Uv uv = {(0.3 + 0.05 * i) * period, 0.5};
      constexpr double kRounding = 1e-9;
      EXPECT_LT(
          difference(surface->evaluate(uv, Order::Second), file_jet(*given, uv, Order::Second)),
          kRounding);
    }
  }
}

}  // namespace
}  // namespace surfmesh
