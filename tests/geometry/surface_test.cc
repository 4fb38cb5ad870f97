// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/geometry/plane_surface.hh"

namespace surfmesh {
namespace {

constexpr Domain kDomain{-1.5, 1.5, -1.2, 1.4};
constexpr std::array kOrders = {Order::Position, Order::First, Order::Second};

const SurfaceFormulas kTorusFormulas{"(3+cos(v))*cos(u)", "(3+cos(v))*sin(u)", "sin(v)"};

std::shared_ptr<const Surface> callable_torus() {
  return make_callable_surface(kDomain, [](auto u, auto v) {
    return std::array{(3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)};
  });
}

std::vector<Uv> points() {
  std::vector<Uv> result;
  for (double s : {0.0, 0.21, 0.5, 0.83, 1.0}) {
    for (double t : {0.0, 0.17, 0.64, 1.0}) result.push_back(kDomain.at(s, t));
  }
  return result;
}

void expect_equal(const Jet& a, const Jet& b, Order order) {
  EXPECT_EQ(a.point, b.point);
  if (order >= Order::First) {
    EXPECT_EQ(a.du, b.du);
    EXPECT_EQ(a.dv, b.dv);
  }
  if (order >= Order::Second) {
    EXPECT_EQ(a.duu, b.duu);
    EXPECT_EQ(a.duv, b.duv);
    EXPECT_EQ(a.dvv, b.dvv);
  }
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " and " << b.transpose();
}

template <class Call>
std::string geometry_message(Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Geometry);
    return error.what();
  }
  return "no error";
}

TEST(PlaneSurface, IsAffine) {
  const Vec3 origin(1, 2, 3), a(2, 0, 1), b(0, 1, -1);
  const PlaneSurface plane(origin, a, b, kDomain);
  const Jet jet = plane.evaluate({0.5, -1}, Order::Second);
  EXPECT_EQ(jet.point, Vec3(2, 1, 4.5));
  EXPECT_EQ(jet.du, a);
  EXPECT_EQ(jet.dv, b);
  EXPECT_EQ(jet.duu, Vec3::Zero());
  EXPECT_EQ(jet.duv, Vec3::Zero());
  EXPECT_EQ(jet.dvv, Vec3::Zero());
}

TEST(Surfaces, LeaveMembersAboveTheOrderUnset) {
  const PlaneSurface plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), kDomain);
  const FormulaSurface formula(kTorusFormulas, kDomain);
  const auto callable = callable_torus();
  for (const Surface* surface :
       std::initializer_list<const Surface*>{&plane, &formula, callable.get()}) {
    EXPECT_TRUE(surface->evaluate({0, 0}, Order::Position).du.hasNaN());
    EXPECT_TRUE(surface->evaluate({0, 0}, Order::First).duv.hasNaN());
    EXPECT_FALSE(surface->evaluate({0, 0}, Order::Second).dvv.hasNaN());
    EXPECT_EQ(surface->domain().v1, kDomain.v1);
  }
}

TEST(Surfaces, OrdersAgreeBitByBit) {
  const FormulaSurface formula(kTorusFormulas, kDomain);
  const auto callable = callable_torus();
  for (const Uv uv : points()) {
    for (const Surface* surface : std::initializer_list<const Surface*>{&formula, callable.get()}) {
      const Jet second = surface->evaluate(uv, Order::Second);
      for (const Order order : kOrders) expect_equal(surface->evaluate(uv, order), second, order);
    }
  }
}

TEST(Surfaces, FormulaAndCallableAgree) {
  const FormulaSurface formula(kTorusFormulas, kDomain);
  const auto callable = callable_torus();
  for (const Uv uv : points()) {
    for (const Order order : kOrders) {
      expect_equal(formula.evaluate(uv, order), callable->evaluate(uv, order), order);
    }
  }
}

TEST(FormulaSurface, IsTheTorus) {
  const FormulaSurface torus(kTorusFormulas, kDomain);
  for (const Uv uv : points()) {
    const double c = std::cos(uv.u), s = std::sin(uv.u), p = std::cos(uv.v), q = std::sin(uv.v);
    const Jet jet = torus.evaluate(uv, Order::Second);
    expect_near(jet.point, {(3 + p) * c, (3 + p) * s, q}, 1e-15);
    expect_near(jet.du, {-(3 + p) * s, (3 + p) * c, 0}, 1e-15);
    expect_near(jet.dv, {-q * c, -q * s, p}, 1e-15);
    expect_near(jet.duu, {-(3 + p) * c, -(3 + p) * s, 0}, 1e-15);
    expect_near(jet.duv, {q * s, -q * c, 0}, 1e-15);
    expect_near(jet.dvv, {-p * c, -p * s, -q}, 1e-15);
  }
}

TEST(FormulaSurface, IsAGraphByDefault) {
  const FormulaSurface graph({.z = "a*u*v"}, kDomain, {{"a", 2}});
  const Jet jet = graph.evaluate({0.5, 0.25}, Order::Second);
  EXPECT_EQ(jet.point, Vec3(0.5, 0.25, 0.25));
  EXPECT_EQ(jet.du, Vec3(1, 0, 0.5));
  EXPECT_EQ(jet.dv, Vec3(0, 1, 1));
  EXPECT_EQ(jet.duv, Vec3(0, 0, 2));
}

// Values of the case c2 of the benchmark scripts, `CurvatureSurface.surface` and `.derivatives`:
//   c = CurvatureSurface(); c.surface(u, v); c.derivatives(u, v)
TEST(FormulaSurface, GivesTheReferenceValuesOfTheWave) {
  struct Reference {
    Uv at;
    double z, zu, zv, zuu, zuv, zvv;
  };
  const std::vector<Reference> references = {
      {{0, 0}, 0, 3, -0, 0, -0, -0},
      {{0.5, -1},
       1.2355010407116771,
       1.5853766893995862,
       0.052560694048156532,
       -4.9476471538079716,
       0.067445106379361519,
       -0.051685742937860664},
      {{-1.25, 0.75},
       -0.88574371390795337,
       -2.3736126888448688,
       0.028102029439910459,
       3.5328838155136171,
       0.075307713296168352,
       0.037118922819170605},
      {{6, 6},
       -0.27138657815312806,
       0.85686154756722299,
       0.1428661243818134,
       1.0655634882944593,
       -0.45107790247334673,
       0.0080085289645219077},
      {{-5.5, 3.25},
       1.1463603271752205,
       0.022756952160066637,
       -0.18174497486882352,
       -4.5873720860072993,
       -0.0036079072176318874,
       -0.045832882791887707},
      {{0.785398, -6},
       0.52399401050994576,
       -0.00082274521859607846,
       0.27584633694964578,
       -2.0970227382338664,
       -0.00043311803234486813,
       -0.015462891492139655},
  };
  const FormulaSurface wave({.z = "1.5*sin(2*u)*cos(v/5)*exp(-(u^2+v^2)/1000)"}, kDomain);
  for (const Reference& r : references) {
    const Jet jet = wave.evaluate(r.at, Order::Second);
    EXPECT_NEAR(jet.point.z(), r.z, 1e-14);
    EXPECT_NEAR(jet.du.z(), r.zu, 1e-14);
    EXPECT_NEAR(jet.dv.z(), r.zv, 1e-14);
    EXPECT_NEAR(jet.duu.z(), r.zuu, 1e-14);
    EXPECT_NEAR(jet.duv.z(), r.zuv, 1e-14);
    EXPECT_NEAR(jet.dvv.z(), r.zvv, 1e-14);
  }
}

TEST(FormulaSurface, NamesTheCoordinateOfABadFormula) {
  try {
    FormulaSurface({.x = "u", .y = "v+", .z = "0"}, kDomain);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidInput);
    EXPECT_EQ(std::string(error.what()).rfind("y: formula \"v+\", column 3", 0), 0u)
        << error.what();
  }
}

TEST(FormulaSurface, ReportsWhereItIsNotFinite) {
  const FormulaSurface surface({.z = "sqrt(u)"}, kDomain);
  EXPECT_NO_THROW(surface.evaluate({0, 0.5}, Order::Position));
  const std::string text = geometry_message([&] { surface.evaluate({0, 0.5}, Order::First); });
  EXPECT_NE(text.find("(u,v) = (0, 0.5) is not finite: first derivatives of z"), std::string::npos)
      << text;
  EXPECT_TRUE(geometry_message([&] {
                surface.evaluate({-1, 0}, Order::Position);
              })
                  .ends_with("is not finite: z; let the domain keep away from it, or give the "
                             "surface a value there, in formulas by if(...)"));
  const FormulaSurface blunt({"sign(u)*abs(u)^1.5", "v", "abs(u)^1.2"}, kDomain);
  EXPECT_NO_THROW(blunt.evaluate({0, 0}, Order::First));
  EXPECT_TRUE(
      geometry_message([&] {
        blunt.evaluate({0, 0}, Order::Second);
      })
          .ends_with("is not finite: second derivatives of x, z; let the domain begin "
                     "beside it, or write the surface so that it has a tangent plane there"));
}

TEST(FormulaSurface, ReadsCommonPartsByName) {
  const FormulaSurface named({"r*cos(u)", "r*sin(u)", "v", {{"c", "0.2*cos(3*u)"}, {"r", "1+c"}}},
                             kDomain);
  const FormulaSurface plain({"(1+0.2*cos(3*u))*cos(u)", "(1+0.2*cos(3*u))*sin(u)", "v"}, kDomain);
  for (double u = 0.1; u < 1; u += 0.2) {
    expect_equal(named.evaluate({u, u}, Order::Second), plain.evaluate({u, u}, Order::Second),
                 Order::Second);
  }
}

TEST(CallableSurface, ReportsWhereItIsNotFinite) {
  const auto surface = make_callable_surface(kDomain, [](auto u, auto v) {
    return std::array{u, v, 1 / (u * v)};
  });
  EXPECT_NE(geometry_message([&] {
              surface->evaluate({0.25, 0}, Order::Position);
            }).find("(u,v) = (0.25, 0)"),
            std::string::npos);
}

TEST(CallableSurface, TakesEigenVectors) {
  const auto surface = make_callable_surface(kDomain, [](auto u, auto v) {
    using Vector = Eigen::Matrix<decltype(u), 3, 1>;
    const Vector axis(cos(u), sin(u), 0.0);
    return Vector(2.0 * axis + v * Vector::UnitZ());
  });
  const Jet jet = surface->evaluate({0, 1}, Order::Second);
  EXPECT_EQ(jet.point, Vec3(2, 0, 1));
  EXPECT_EQ(jet.du, Vec3(0, 2, 0));
  EXPECT_EQ(jet.dv, Vec3(0, 0, 1));
  EXPECT_EQ(jet.duu, Vec3(-2, 0, 0));
}

TEST(PlaneSurface, ReportsWhereItIsNotFinite) {
  const PlaneSurface plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), kDomain);
  EXPECT_NE(geometry_message([&] { plane.evaluate({kUnset, 0}, Order::First); }), "no error");
}

TEST(Surfaces, RefuseEmptyAndInfiniteDomains) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Domain& domain : {Domain{0, 0, 0, 1}, Domain{0, 1, 2, 1}, Domain{0, infinity, 0, 1},
                               Domain{0, 1, kUnset, 1}}) {
    EXPECT_THROW(FormulaSurface({}, domain), Error);
    EXPECT_THROW(PlaneSurface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), domain), Error);
    EXPECT_THROW(make_callable_surface(domain,
                                       [](auto u, auto v) {
                                         return std::array{u, v, u};
                                       }),
                 Error);
  }
}

}  // namespace
}  // namespace surfmesh
