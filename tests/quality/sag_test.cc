// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/sag.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hh"
#include "support/models.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/counted_surfaces.hh"
#include "surfmesh/quality/project_mesh.hh"
#include "surfmesh/quality/surface_distance.hh"
#include "surfmesh/quality/triangle_sag.hh"

namespace surfmesh {
namespace {

Sag sag_of(PolyMesh mesh, const Model& model) {
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  return measure_sag(mesh, model, search);
}

/// An equilateral triangle on the unit sphere, its corners at an angle from its middle, far from
/// poles and seam.
PolyMesh triangle_on_sphere(double angle) {
  const Vec3 middle(std::cos(1), std::sin(1), 0), east(-std::sin(1), std::cos(1), 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 3; ++i) {
    const double turn = 2 * std::numbers::pi * i / 3;
    const Vec3 way = std::cos(turn) * east + std::sin(turn) * Vec3::UnitZ();
    points.push_back(std::cos(angle) * middle + std::sin(angle) * way);
  }
  return testing::mesh_of(points, {{0, 1, 2}});
}

/// The unit square, whose parameter u runs by u².
Model uneven_square() {
  return testing::model_of({make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u * u, v, 0 * u};
  })});
}

/// The half of a unit cylinder along y with x ≥ 0.
Model half_pipe() {
  return testing::model_of(
      {make_callable_surface({-1.5707963, 1.5707963, 0, 1}, [](auto u, auto v) {
        return std::array{cos(u), v, sin(u)};
      })});
}

TEST(Sag, OfATriangleOnASphereIsThatOfItsCircle) {
  const Model model = testing::model_of({testing::sphere()});
  for (const double angle : {0.01, 0.1, 0.4}) {
    const double exact = 1 - std::cos(angle);
    EXPECT_NEAR(sag_of(triangle_on_sphere(angle), model).max, exact, 0.03 * exact) << angle;
  }
}

TEST(Sag, IsNoneWhereOnlyParametersAreUneven) {
  const PolyMesh mesh =
      testing::mesh_of({{0.01, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.01, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_LT(sag_of(mesh, uneven_square()).max, 1e-9);
}

TEST(Sag, SeesWhatTheMeshCutsOff) {
  // A flat strip across the pipe: all of it is within 0.5 of the pipe's sides, the top is 1 away.
  const PolyMesh mesh =
      testing::mesh_of({{0, 0, -1}, {0, 0, 1}, {0, 1, 1}, {0, 1, -1}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_NEAR(sag_of(mesh, half_pipe()).max, 1, 0.01);
}

/// Rises within a fortieth of the domain and runs on flat.
template <class T>
T narrow_bend(T v) {
  using std::exp;
  return 0.1 * (1 - exp(-40 * v));
}

TEST(PlaneSag, SeesABendBetweenTheSamples) {
  const auto surface = make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, 0.0 * u + narrow_bend(v)};
  });
  const double end = narrow_bend(1.0), at = std::log(40.0) / 40;
  const double greatest = (narrow_bend(at) - at * end) / std::hypot(1, end);
  const detail::SurfaceTriangle triangle = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, end)},
                                            {Uv{0, 0}, Uv{1, 0}, Uv{0, 1}}};
  EXPECT_NEAR(detail::plane_sag(*surface, triangle), greatest, 5e-4);
  // By the samples alone it is 6 % less.
  EXPECT_LT(detail::plane_sag(*surface, triangle, {.searched_from = 1}), 0.95 * greatest);
}

/// A bowl that counts its evaluations. Along v its parameters are uneven by a power.
std::shared_ptr<const Surface> counting_bowl(int& count, int power) {
  return make_callable_surface({0, 1, 0, 1}, [&count, power](auto u, auto v) {
    ++count;
    auto y = v;
    for (int i = 1; i < power; ++i) y = y * v;
    return std::array{u, y, u * u + 2 * y * y};
  });
}

/// A triangle of a surface by its parameters.
detail::SurfaceTriangle triangle_on(const Surface& surface, const std::array<Uv, 3>& uvs) {
  detail::SurfaceTriangle triangle{{}, uvs};
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.points[k] = surface.evaluate(uvs[k], Order::Position).point;
  }
  return triangle;
}

TEST(PlaneSag, EvaluatesNoSampleTwice) {
  int count = 0;
  const auto bowl = counting_bowl(count, 4);
  const auto triangle = triangle_on(*bowl, {Uv{0, 0}, Uv{0.3, 0}, Uv{0, 0.3}});
  count = 0;
  // Parameters are too uneven for an estimate, and nothing is searched below this.
  detail::plane_sag(*bowl, triangle, {.searched_from = 1});
  EXPECT_EQ(count, 25);
}

TEST(PlaneSag, EndsAboveABound) {
  int count = 0;
  const auto bowl = counting_bowl(count, 1);
  const auto triangle = triangle_on(*bowl, {Uv{0, 0}, Uv{0.3, 0}, Uv{0, 0.3}});
  count = 0;
  EXPECT_GT(detail::plane_sag(*bowl, triangle, {.ends_above = 0.01}), 0.01);
  EXPECT_EQ(count, 1);
}

TEST(EstimatePlaneSag, IsExactOverAParaboloid) {
  const auto bowl = make_callable_surface({-1, 1, -1, 1}, [](auto u, auto v) {
    return std::array{u, v, u * u + 0.5 * u * v - v * v};
  });
  const auto triangle = triangle_on(*bowl, {Uv{0, 0}, Uv{0.3, 0.1}, Uv{0.1, 0.4}});
  const auto estimate = detail::estimate_plane_sag(*bowl, triangle);
  EXPECT_NEAR(estimate.sag, detail::plane_sag(*bowl, triangle), 1e-4);
  EXPECT_LT(estimate.error, 1e-12);
}

TEST(EstimatePlaneSag, IsGreatestInsideOverASphere) {
  const auto cap = make_callable_surface({-1, 1, -1, 1}, [](auto u, auto v) {
    return std::array{u, v, sqrt(4 - u * u - v * v)};
  });
  const auto triangle = triangle_on(*cap, {Uv{0.2, 0}, Uv{-0.1, 0.1732}, Uv{-0.1, -0.1732}});
  const auto estimate = detail::estimate_plane_sag(*cap, triangle);
  const double exact = 2 - std::sqrt(4 - 0.04);
  EXPECT_NEAR(estimate.sag, exact, 0.01 * exact);
  EXPECT_LT(estimate.error, 0.05 * exact);
}

TEST(EstimatePlaneSag, TellsThatItMissesANarrowBend) {
  const auto surface = make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, 0.0 * u + narrow_bend(v)};
  });
  const auto triangle = triangle_on(*surface, {Uv{0, 0}, Uv{1, 0}, Uv{0, 1}});
  const auto estimate = detail::estimate_plane_sag(*surface, triangle);
  EXPECT_GT(estimate.sag + estimate.error, detail::plane_sag(*surface, triangle));
}

TEST(EstimatePlaneSag, KnowsNothingWhereParametersAreUneven) {
  const auto surface = make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u * u * u * u, v, 0.0 * u};
  });
  const auto triangle = triangle_on(*surface, {Uv{0, 0}, Uv{1, 0}, Uv{0, 1}});
  EXPECT_TRUE(std::isinf(detail::estimate_plane_sag(*surface, triangle).error));
}

TEST(EstimateSag, IsNearTheMeasureOnASphere) {
  const Model model = testing::model_of({testing::sphere()});
  PolyMesh mesh = triangle_on_sphere(0.1);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  const double exact = 1 - std::cos(0.1);
  EXPECT_NEAR(estimate_sag(mesh, model).front(), exact, 0.03 * exact);
}

/// A hump of uneven curvature over the unit square.
Model hump() {
  return testing::model_of({make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, 2 * u * u * u * (1 - u) * v * (1 - v)};
  })});
}

/// A net of squares over the hump, each two triangles.
PolyMesh net_over_hump(const Model& model, int count) {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
  for (int j = 0; j <= count; ++j) {
    for (int i = 0; i <= count; ++i) {
      const Uv uv{double(i) / count, double(j) / count};
      points.push_back(model.surface(0).evaluate(uv, Order::Position).point);
      if (i == count || j == count) continue;
      const int a = j * (count + 1) + i, b = a + 1, c = b + count + 1, d = a + count + 1;
      faces.push_back({a, b, c});
      faces.push_back({a, c, d});
    }
  }
  return testing::mesh_of(points, faces);
}

TEST(Sag, IsMeasuredOfAllFacesAboveWhatIsAsked) {
  const Model model = hump();
  PolyMesh mesh = net_over_hump(model, 12);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  const Sag exact = measure_sag(mesh, model, search, RunContext(), {.asked = 0});
  const double asked = 0.3 * exact.max;
  const Sag sag = measure_sag(mesh, model, search, RunContext(), {.asked = asked});
  EXPECT_EQ(sag.max, exact.max);
  const Sag greatest_only = measure_sag(mesh, model, search);
  EXPECT_EQ(greatest_only.max, exact.max);
  EXPECT_NE(greatest_only.of_faces, sag.of_faces);
  std::size_t above = 0;
  for (std::size_t f = 0; f < exact.of_faces.size(); ++f) {
    EXPECT_EQ(sag.of_faces[f] > asked, exact.of_faces[f] > asked) << f;
    if (exact.of_faces[f] <= asked) continue;
    EXPECT_EQ(sag.of_faces[f], exact.of_faces[f]) << f;
    ++above;
  }
  EXPECT_GT(above, exact.of_faces.size() / 10);
  EXPECT_LT(above, exact.of_faces.size());
}

TEST(Sag, IsNotMeasuredAgainWhereNothingHasChanged) {
  const Model uncounted = hump();
  const detail::CountedModel counted(uncounted);
  const Model& model = counted.model();
  PolyMesh mesh = net_over_hump(model, 12);
  const SurfaceSearch search(model);
  project_mesh(mesh, {}, model, search);
  SagMemory memory;
  const SagDemands demands{.asked = 0.01, .memory = &memory};
  const Sag first = measure_sag(mesh, model, search, RunContext(), demands);
  const std::size_t before = counted.evaluations();
  const Sag second = measure_sag(mesh, model, search, RunContext(), demands);
  EXPECT_EQ(counted.evaluations(), before);
  EXPECT_EQ(second.max, first.max);
  EXPECT_EQ(second.of_faces, first.of_faces);

  // Another net shares no face.
  PolyMesh finer = net_over_hump(model, 13);
  project_mesh(finer, {}, model, search);
  EXPECT_EQ(measure_sag(finer, model, search, RunContext(), demands).max,
            measure_sag(finer, model, search, RunContext(), {.asked = 0.01}).max);
}

TEST(Sag, IsToldOfEachFace) {
  const PolyMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const Model model = testing::model_of({make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, u * u * (1 - u) * v * (1 - v)};
  })});
  const Sag sag = sag_of(mesh, model);
  ASSERT_EQ(sag.of_faces.size(), 2u);
  EXPECT_GT(sag.of_faces[0], sag.of_faces[1]);
  EXPECT_EQ(sag.max, sag.of_faces[0]);
}

}  // namespace
}  // namespace surfmesh
