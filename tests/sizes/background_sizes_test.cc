// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/background_sizes.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/waves.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/quality/triangle_distance.hh"
#include "surfmesh/sizes/field_search.hh"
#include "surfmesh/sizes/field_size.hh"
#include "surfmesh/sizes/simplex_tree.hh"

namespace surfmesh {
namespace {

constexpr double kPi = std::numbers::pi;

/// Random numbers that are the same everywhere.
class Random {
 public:
  double between(double a, double b) {
    return a + (b - a) * static_cast<double>(engine_()) / static_cast<double>(engine_.max());
  }
  Vec3 point(double a, double b) { return {between(a, b), between(a, b), between(a, b)}; }

 private:
  std::mt19937 engine_{1};
};

/// The unit square as n × n squares of two triangles each, in the plane z = 0.
BackgroundMesh square(int n) {
  BackgroundMesh mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.points.emplace_back(double(i) / n, double(j) / n, 0);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + n + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

/// The unit cube as six tetrahedra around its diagonal.
BackgroundMesh cube() {
  BackgroundMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  mesh.tetrahedra = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                     {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  return mesh;
}

double linear(const Vec3& p) { return 1 + 0.25 * p.x() - 0.5 * p.y() + 0.125 * p.z(); }

template <class Function>
BackgroundMesh with_sizes(BackgroundMesh mesh, Function size) {
  for (const Vec3& point : mesh.points) mesh.sizes.push_back(size(point));
  return mesh;
}

template <class Function>
BackgroundMesh with_metrics(BackgroundMesh mesh, Function metric) {
  for (const Vec3& point : mesh.points) mesh.metrics.push_back(metric(point));
  return mesh;
}

/// Lengths h1 along the direction with an angle in the plane, h2 across and h3 along z.
SpaceMetric lengths(double h1, double h2, double h3, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double a = 1 / (h1 * h1), b = 1 / (h2 * h2);
  return {c * c * a + s * s * b, s * s * a + c * c * b, 1 / (h3 * h3), c * s * (a - b), 0, 0};
}

std::shared_ptr<const BackgroundSizes> made(BackgroundMesh mesh,
                                            BackgroundIn in = BackgroundIn::Space) {
  return std::make_shared<const BackgroundSizes>(std::move(mesh), in);
}

TEST(BackgroundSizes, AreLinearInTriangles) {
  const auto sizes = made(with_sizes(square(7), linear));
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p(random.between(0, 1), random.between(0, 1), 0);
    EXPECT_NEAR(sizes->size(p), linear(p), 1e-14);
    // Above the plane, that of the nearest point.
    EXPECT_NEAR(sizes->size(p + Vec3(0, 0, 0.1)), linear(p), 1e-14);
  }
}

TEST(BackgroundSizes, AreLinearInTetrahedra) {
  const auto sizes = made(with_sizes(cube(), linear));
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.point(0, 1);
    EXPECT_NEAR(sizes->size(p), linear(p), 1e-14);
    const Vec3 beside = random.point(-0.5, 1.5);
    EXPECT_NEAR(sizes->size(beside), linear(beside.cwiseMax(0.0).cwiseMin(1.0)), 1e-14);
  }
}

TEST(BackgroundSizes, HoldAsFarAsTheLongestSideNearby) {
  const auto sizes = made(with_sizes(square(10), linear));
  const double reach = std::sqrt(2.0) / 10;
  EXPECT_EQ(sizes->size({1 + 0.99 * reach, 0.5, 0}), linear({1, 0.5, 0}));
  EXPECT_EQ(sizes->size({1 + 1.01 * reach, 0.5, 0}), kNoWish);
  EXPECT_EQ(sizes->size({0.5, 0.5, -1.01 * reach}), kNoWish);
  BackgroundMesh far = with_sizes(square(10), linear);
  far.reach = 100;
  EXPECT_EQ(made(far)->size({1, 0.5, 99}), linear({1, 0.5, 0}));
  EXPECT_EQ(made(far)->size({1, 0.5, 101}), kNoWish);
}

TEST(BackgroundSizes, InParametersHaveNoHeight) {
  BackgroundMesh mesh = with_sizes(square(4), linear);
  for (Vec3& point : mesh.points) point.z() = 17;
  const auto sizes = made(mesh, BackgroundIn::Uv);
  EXPECT_NEAR(sizes->size({0.3, 0.6, 0}), linear({0.3, 0.6, 0}), 1e-14);
}

TEST(BackgroundSizes, HaveTheMetricThatIsTheSameEverywhere) {
  const SpaceMetric metric = lengths(0.01, 0.5, 20, 0.7);
  for (const BackgroundMesh& mesh : {square(3), cube()}) {
    const auto sizes = made(with_metrics(mesh, [&](const Vec3&) { return metric; }));
    const SpaceMetric m = sizes->metric({0.3, 0.4, 0.1});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(m[i], metric[i], 1e-9 * metric[0]);
  }
}

/// Half way between lengths 0.01 and 1, that is 0.1.
TEST(BackgroundSizes, HaveGeometricMeansOfMetrics) {
  const auto sizes = made(with_metrics(square(1), [](const Vec3& p) {
    const double h = p.x() == 0 ? 0.01 : 1;
    return lengths(h, h, h, 0);
  }));
  const SpaceMetric m = sizes->metric({0.5, 0.25, 0});
  EXPECT_NEAR(1 / std::sqrt(m[0]), 0.1, 1e-12);
  EXPECT_NEAR(1 / std::sqrt(m[1]), 0.1, 1e-12);
  EXPECT_NEAR(m[3], 0, 1e-9);
}

/// Between directions that differ by 90 degrees the area of the unit element stays.
TEST(BackgroundSizes, KeepTheAreaWhereDirectionsTurn) {
  const auto sizes = made(with_metrics(
      square(1), [](const Vec3& p) { return lengths(0.01, 1, 1, p.x() == 0 ? 0 : 0.5 * kPi); }));
  for (const double x : {0.1, 0.5, 0.9}) {
    const SpaceMetric m = sizes->metric({x, 0.25, 0});
    EXPECT_NEAR(m[0] * m[1] - m[3] * m[3], 1e4, 1e-7);
  }
}

TEST(BackgroundSizes, AskForNothingBeyondTheReachOfMetrics) {
  const auto sizes = made(with_metrics(square(1), [](const Vec3&) { return lengths(1, 1, 1, 0); }));
  const SpaceMetric m = sizes->metric({5, 5, 5});
  EXPECT_EQ(1 / std::sqrt(m[0]), kNoWish);
}

BackgroundMesh soup(int count, Random& random) {
  BackgroundMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle = random.point(0, 1);
    for (int k = 0; k < 3; ++k) mesh.points.push_back(middle + random.point(-0.2, 0.2));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(SimplexTree, FindsWhatAPlainSearchFinds) {
  Random random;
  const BackgroundMesh mesh = soup(200, random);
  std::vector<detail::Simplex> simplices;
  for (const auto& t : mesh.triangles) simplices.push_back({t[0], t[1], t[2], -1});
  const detail::SimplexTree tree(mesh.points, simplices);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(-0.5, 1.5);
    double least = INFINITY;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto corner = [&](std::size_t k) { return mesh.points[3 * t + k]; };
      const std::array<Vec3, 3> triangle = {corner(0), corner(1), corner(2)};
      least = std::min(least, detail::triangle_distance(p, triangle).distance);
    }
    const detail::NearSimplex near = tree.nearest(p);
    EXPECT_NEAR(std::sqrt(near.squared_distance), least, 1e-12);
    EXPECT_NEAR(near.weights[0] + near.weights[1] + near.weights[2], 1, 1e-12);
  }
}

TEST(SimplexTree, IsAskedFromSeveralThreads) {
  Random random;
  const auto sizes = made(with_sizes(soup(200, random), [](const Vec3& p) { return 2 + p.x(); }));
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) points.push_back(random.point(0, 1));
  std::vector<double> found(points.size());
  with_threads(4, [&] {
    share_indices(points.size(), [&](std::size_t i) { found[i] = sizes->size(points[i]); });
  });
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i], sizes->size(points[i]));
}

const auto kPlane = std::make_shared<test::PlanePatch>(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());

/// No value at a point of a box is below the bound of the box.
TEST(BackgroundField, HasBoundsThatHold) {
  Random random;
  const BackgroundMesh triangles = soup(100, random);
  for (const BackgroundMesh& mesh : {triangles, cube()}) {
    const auto sizes = made(with_sizes(mesh, [&](const Vec3&) { return random.between(0.1, 1); }));
    const FieldSource field = background_field(sizes, 0, kPlane);
    ASSERT_TRUE(field.has_bounds());
    for (int i = 0; i < 300; ++i) {
      const Vec3 low = random.point(-0.5, 1.3);
      const Eigen::AlignedBox3d box(low, low + random.point(0, 0.3));
      const Interval bounds = field.size_bounds({}, box);
      for (int k = 0; k < 30; ++k) {
        const Vec3 p = low + random.point(0, 1).cwiseProduct(box.sizes());
        EXPECT_GE(field.size({}, p), bounds.lower);
        EXPECT_LE(field.size({}, p), bounds.upper);
      }
    }
  }
}

/// A small size at one of 10,000 vertices.
TEST(BackgroundField, HidesNoSmallSize) {
  constexpr int n = 100;
  BackgroundMesh mesh = with_sizes(square(n), [](const Vec3&) { return 0.1; });
  mesh.sizes[61 * (n + 1) + 23] = 0.002;
  const auto metrics = [&] {
    BackgroundMesh result = mesh;
    for (const double h : mesh.sizes) result.metrics.push_back(lengths(h, h, h, 0));
    result.sizes.clear();
    return result;
  }();
  for (const BackgroundMesh& one : {mesh, metrics}) {
    for (const BackgroundIn in : {BackgroundIn::Space, BackgroundIn::Uv}) {
      PatchSources sources;
      sources.fields.push_back(background_field(made(one, in), 0, kPlane));
      const SizeField field(*kPlane, resolve(testing::sizing_of(0, 0.0001, 1, 2), 1), sources);
      FieldSearch search(field);
      const auto uv = search.find_smaller({{0, 1}, {0, 1}}, 0.01);
      ASSERT_TRUE(uv);
      EXPECT_NEAR(uv->u, 0.23, 0.01);
      EXPECT_NEAR(uv->v, 0.61, 0.01);
      EXPECT_FALSE(search.find_smaller({{0, 1}, {0, 0.5}}, 0.099));
      EXPECT_LT(search.evaluations(), 1000u);
    }
  }
}

SizeTensor size_at(const FieldSource& field, const Surface& surface, Uv uv) {
  const Jet jet = surface.evaluate(uv, Order::First);
  return size_of_field(field, surface, {uv, jet.point, first_form_factor(jet.du, jet.dv)});
}

/// A metric of equal lengths in space asks for these in any patch, at poles too.
TEST(BackgroundField, PullsLengthsBackToTheSphere) {
  const auto sphere = std::make_shared<test::Sphere>(1, Domain{0, 2 * kPi, -kPi / 2, kPi / 2});
  BackgroundMesh mesh = cube();
  for (Vec3& point : mesh.points) point = 4 * point - Vec3(2, 2, 2);
  const auto sizes =
      made(with_metrics(mesh, [](const Vec3&) { return lengths(0.3, 0.3, 0.3, 0); }));
  const FieldSource field = background_field(sizes, 0, sphere);
  for (const Uv uv : {Uv{0.1, 0.2}, Uv{3, 1.5}, Uv{5, -kPi / 2}, Uv{0, kPi / 2}}) {
    const SizeTensor h = size_at(field, *sphere, uv);
    EXPECT_NEAR(h.h11, 0.3, 1e-9);
    EXPECT_NEAR(h.h12, 0, 1e-9);
    EXPECT_NEAR(h.h22, 0.3, 1e-9);
  }
}

/// On a cylinder, 0.1 along its axis and 0.4 across, although it asks for 0.01 out of the surface.
TEST(BackgroundField, PullsDirectionsBackToTheCylinder) {
  const auto cylinder = std::make_shared<test::Cylinder>(1, Domain{0, 1, 0, 1});
  BackgroundMesh mesh;
  constexpr int n = 40;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double u = double(i) / n, v = double(j) / n;
      mesh.points.push_back(cylinder->evaluate({u, v}, Order::Position).point);
      const Vec3 out = Vec3(mesh.points.back().x(), mesh.points.back().y(), 0).normalized();
      const Vec3 around = Vec3(-out.y(), out.x(), 0);
      const Eigen::Matrix3d m = 1e4 * out * out.transpose() + 6.25 * around * around.transpose() +
                                100 * Vec3::UnitZ() * Vec3::UnitZ().transpose();
      mesh.metrics.push_back({m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)});
    }
  }
  mesh.triangles = square(n).triangles;
  const FieldSource field = background_field(made(mesh), 0, cylinder);
  for (const Uv uv : {Uv{0.11, 0.2}, Uv{0.5, 0.5}, Uv{0.97, 0.7}}) {
    const PrincipalSizes sizes = principal_sizes(size_at(field, *cylinder, uv));
    EXPECT_NEAR(sizes.l_s, 0.4, 0.004);
    EXPECT_NEAR(sizes.l_t, 0.1, 1e-6);
  }
  // The bound is that of the least length over all directions, which is the one across.
  const double bound = least_length_in(field, *cylinder, {{0.4, 0.41}, {0.4, 0.41}});
  EXPECT_LE(bound, 0.01 + 1e-9);
  EXPECT_GE(bound, 0.0099);
}

std::string refused(BackgroundMesh mesh, BackgroundIn in = BackgroundIn::Space) {
  return error_of([&] { BackgroundSizes(std::move(mesh), in); });
}

TEST(BackgroundSizes, RefuseBadInput) {
  const BackgroundMesh good = with_sizes(square(1), linear);
  const auto changed = [&](auto change) {
    BackgroundMesh mesh = good;
    change(mesh);
    return refused(std::move(mesh));
  };
  EXPECT_EQ(refused({}),
            "invalid input: the background mesh has no triangles, quads or tetrahedra");
  EXPECT_EQ(refused(square(1)),
            "invalid input: a background mesh needs either sizes or metrics at its vertices");
  EXPECT_EQ(changed([](auto& mesh) { mesh.sizes.pop_back(); }),
            "invalid input: 3 values at 4 vertices");
  for (const double size : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    const std::string text = changed([&](auto& mesh) { mesh.sizes[2] = size; });
    EXPECT_NE(text.find("at vertex 2, from 0, is not positive and finite"), text.npos) << text;
  }
  EXPECT_EQ(changed([](auto& mesh) { mesh.triangles[1][2] = 4; }),
            "invalid input: element 1, from 0, has the vertex 4");
  EXPECT_EQ(changed([](auto& mesh) { mesh.points[3].y() = NAN; }),
            "invalid input: vertex 3, from 0, is not finite");
  EXPECT_EQ(changed([](auto& mesh) { mesh.reach = 0; }),
            "invalid input: the reach of a background mesh must be above 0");
  EXPECT_EQ(changed([](auto& mesh) {
              for (Vec3& point : mesh.points) point.x() = 1;
            }),
            "invalid input: no element of the background mesh has an area or a volume");
  EXPECT_EQ(refused(with_sizes(cube(), linear), BackgroundIn::Uv),
            "invalid input: a background mesh in (u,v) cannot have tetrahedra");
}

TEST(BackgroundSizes, RefuseBadMetrics) {
  for (const SpaceMetric& bad :
       {SpaceMetric{1, 1, 1, 2, 0, 0}, SpaceMetric{1, 1, -1, 0, 0, 0}, SpaceMetric{},
        SpaceMetric{1, 1, 1, NAN, 0, 0}, SpaceMetric{1, 1, INFINITY, 0, 0, 0}}) {
    BackgroundMesh mesh = with_metrics(square(1), [](const Vec3&) { return lengths(1, 1, 1, 0); });
    mesh.metrics[1] = bad;
    EXPECT_EQ(refused(mesh),
              "invalid input: the metric at vertex 1, from 0, is not positive definite");
  }
}

/// Values of points that no element uses need not be there.
TEST(BackgroundSizes, IgnorePointsOfNoElement) {
  BackgroundMesh mesh = with_sizes(square(1), linear);
  mesh.points.emplace_back(NAN, NAN, NAN);
  mesh.sizes.push_back(NAN);
  EXPECT_EQ(made(mesh)->size({1, 1, 0}), linear({1, 1, 0}));
}

}  // namespace
}  // namespace surfmesh
