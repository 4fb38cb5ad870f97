// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/sampled_surface.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

/// A function of single points as one of batches.
template <class Function>
BatchFunction batches(Function function) {
  return [function](std::span<const Uv> uvs, std::span<Vec3> points) {
    for (std::size_t i = 0; i < uvs.size(); ++i) points[i] = function(uvs[i].u, uvs[i].v);
  };
}

Vec3 wave(double u, double v) { return {u, v, std::sin(3 * u) * std::cos(2 * v)}; }

PointGrid grid_of(const Domain& domain, std::size_t columns, std::size_t rows,
                  Vec3 (*function)(double, double)) {
  PointGrid grid{columns, rows, {}};
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const Uv uv = domain.at(static_cast<double>(i) / static_cast<double>(columns - 1),
                              static_cast<double>(j) / static_cast<double>(rows - 1));
      grid.points.push_back(function(uv.u, uv.v));
    }
  }
  return grid;
}

double greatest_error(const Surface& surface, Vec3 (*function)(double, double)) {
  double greatest = 0;
  for (int i = 0; i <= 97; ++i) {
    for (int j = 0; j <= 89; ++j) {
      const Uv uv = surface.domain().at(i / 97., j / 89.);
      const Vec3 point = surface.evaluate(uv, Order::Position).point;
      greatest = std::max(greatest, (point - function(uv.u, uv.v)).norm());
    }
  }
  return greatest;
}

TEST(SampledSurface, HasPolynomialsOfDegreeFiveExactly) {
  const auto polynomial = [](double u, double v) {
    return Vec3(std::pow(u, 5) - u * v, std::pow(v, 5) + u, std::pow(u, 3) * v * v);
  };
  const Domain domain{-1, 2, 0.5, 1.5};
  for (const std::size_t count : {6u, 7u, 20u}) {
    const SampledSurface surface(domain, grid_of(domain, count, count + 1, polynomial));
    EXPECT_LT(greatest_error(surface, polynomial), 1e-12) << count;
  }
}

TEST(SampledSurface, PassesThroughItsPoints) {
  const Domain domain{0, 2, -1, 1};
  const PointGrid grid = grid_of(domain, 12, 9, wave);
  const SampledSurface surface(domain, grid);
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const Uv uv = domain.at(static_cast<double>(i) / 11, static_cast<double>(j) / 8);
      const Vec3 point = surface.evaluate(uv, Order::Position).point;
      EXPECT_LT((point - grid.points[j * grid.columns + i]).norm(), 1e-14);
    }
  }
}

TEST(SampledSurface, HasAnErrorOfStepsToTheSixth) {
  const Domain domain{0, 2, -1, 1};
  const double coarse = greatest_error(SampledSurface(domain, grid_of(domain, 33, 33, wave)), wave);
  const double fine = greatest_error(SampledSurface(domain, grid_of(domain, 65, 65, wave)), wave);
  EXPECT_GT(std::log2(coarse / fine), 5.5);
}

TEST(SampledSurface, HasDerivatives) {
  const Domain domain{0, 2, -1, 1};
  const SampledSurface surface(domain, grid_of(domain, 129, 129, wave));
  const double u = 0.7, v = 0.31;
  const Jet jet = surface.evaluate({u, v}, Order::Second);
  EXPECT_LT((jet.du - Vec3(1, 0, 3 * std::cos(3 * u) * std::cos(2 * v))).norm(), 1e-9);
  EXPECT_LT((jet.dv - Vec3(0, 1, -2 * std::sin(3 * u) * std::sin(2 * v))).norm(), 1e-9);
  EXPECT_LT((jet.duu - Vec3(0, 0, -9 * std::sin(3 * u) * std::cos(2 * v))).norm(), 1e-6);
  EXPECT_LT((jet.duv - Vec3(0, 0, -6 * std::cos(3 * u) * std::sin(2 * v))).norm(), 1e-6);
  EXPECT_LT((jet.dvv - Vec3(0, 0, -4 * std::sin(3 * u) * std::cos(2 * v))).norm(), 1e-6);
}

TEST(SampledSurface, HasNoDerivativeAlongAPole) {
  const auto lid = [](double u, double v) {
    return Vec3(7 + v * std::cos(u), v * std::sin(u), 1 - v * v);
  };
  const Domain domain{0, 2 * pi, 0, 1};
  const SampledSurface surface(domain, grid_of(domain, 65, 33, lid));
  for (const double u : {0., 0.1, 1., 2., 6.2}) {
    const Jet jet = surface.evaluate({u, 0}, Order::Second);
    EXPECT_EQ(jet.du, Vec3(0, 0, 0));
    EXPECT_EQ(jet.duu, Vec3(0, 0, 0));
    EXPECT_NEAR(jet.dv.norm(), 1, 1e-6);
  }
}

TEST(SampledSurface, RefusesBadGrids) {
  const Domain domain{0, 1, 0, 1};
  PointGrid grid = grid_of(domain, 6, 6, wave);
  EXPECT_NO_THROW(SampledSurface(domain, grid));
  EXPECT_THROW(SampledSurface({1, 0, 0, 1}, grid), Error);
  grid.points.pop_back();
  EXPECT_THROW(SampledSurface(domain, grid), Error);
  grid.points.push_back(Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_THROW(SampledSurface(domain, grid), Error);
  EXPECT_THROW(SampledSurface(domain, grid_of(domain, 5, 6, wave)), Error);
}

TEST(SampledCurve, IsASplineThroughItsPoints) {
  std::vector<Uv> points;
  for (int i = 0; i <= 40; ++i) points.push_back({std::cos(i / 40.), std::sin(i / 40.)});
  const SampledCurve curve(points);
  EXPECT_EQ(curve.evaluate(0), points.front());
  EXPECT_EQ(curve.evaluate(1), points.back());
  for (int i = 1; i < 100; ++i) {
    const Uv uv = curve.evaluate(i / 100.);
    EXPECT_NEAR(uv.u, std::cos(i / 100.), 1e-11);
    EXPECT_NEAR(uv.v, std::sin(i / 100.), 1e-11);
  }
  EXPECT_THROW(SampledCurve(std::vector<Uv>(5, Uv{0, 0})), Error);
  EXPECT_THROW(SampledCurve(std::vector<Uv>(9, Uv{0, kUnset})), Error);
}

TEST(SampleSurface, ReachesItsTolerance) {
  const Domain domain{0, 2, -1, 1};
  for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
    const Sampling sampling =
        sample_surface(batches(wave), domain, {.tolerance = Length::units(tolerance)});
    EXPECT_LE(sampling.error, tolerance);
    EXPECT_LE(greatest_error(*sampling.surface, wave), tolerance);
    EXPECT_LE(sampling.columns * sampling.rows, 129u * 129u);
  }
}

TEST(SampleSurface, SamplesEachDirectionAsItNeeds) {
  const auto roll = [](double u, double v) { return Vec3(std::cos(u), std::sin(u), v); };
  const Sampling sampling = sample_surface(batches(roll), {0, 2 * pi, 0, 1});
  EXPECT_EQ(sampling.rows, 9u);
  EXPECT_EQ(sampling.columns, 65u);
  EXPECT_EQ(sampling.surface->cells().u, 8);
  EXPECT_EQ(sampling.surface->cells().v, 1);
}

TEST(SampleSurface, TellsWhereAFunctionBendsSharply) {
  const auto roof = [](double u, double v) { return Vec3(u, v, std::abs(u - 0.3)); };
  try {
    sample_surface(batches(roof), {0, 1, 0, 1}, {.max_samples = 10'000});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Limit);
    EXPECT_NE(std::string(error.what()).find("at (u,v) = (0.29"), std::string::npos)
        << error.what();
  }
}

TEST(SampleSurface, RefusesWhatIsNotFinite) {
  const auto hole = [](double u, double v) { return Vec3(u, v, 1 / (u - 0.5)); };
  EXPECT_THROW(sample_surface(batches(hole), {0, 1, 0, 1}), Error);
  EXPECT_THROW(sample_surface(batches(wave), {0, 1, 0, 1}, {.tolerance = Length::units(0)}), Error);
}

}  // namespace
}  // namespace surfmesh
