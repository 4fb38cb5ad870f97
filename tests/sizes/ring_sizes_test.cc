// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/ring_sizes.hh"

#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "cage/cages.hh"
#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {
namespace {

using testing::Shape;

SizeBounds bounds(double hmin, double hmax) {
  return resolve(testing::sizing_of(0, hmin, hmax, 2), 1).bounds;
}

/// Length of the line of constant v over the patch, by many chords.
double line_length(const Surface& surface, double v) {
  double length = 0;
  Vec3 last = surface.evaluate({0, v}, Order::Position).point;
  for (int i = 1; i <= 4000; ++i) {
    const double u = surface.domain().u1 * i / 4000;
    const Vec3 next = surface.evaluate({u, v}, Order::Position).point;
    length += (next - last).norm();
    last = next;
  }
  return length;
}

TEST(RingSizes, AreTheLengthsAroundATube) {
  const Model model = model_from_cage(testing::tube(4, 3));
  ASSERT_EQ(model.patches.size(), 1u);
  const auto rings = short_rings(model, 0, 400);
  ASSERT_EQ(rings.size(), 1u);
  const Ring& ring = rings[0];
  ASSERT_TRUE(ring.is_along_u);
  for (const double v : {0.0, 0.3, 1.4, 3.0}) {
    const double exact = line_length(*model.patches[0].surface, v);
    EXPECT_LE(ring.length_at({0.7, v}, 0), exact);
    EXPECT_NEAR(ring.length_at({0.7, v}, 0), exact, 0.03 * exact);
  }
}

TEST(RingSizes, AreThereInBothDirectionsOfATorus) {
  const Model model = model_from_cage(testing::torus());
  const auto rings = short_rings(model, 0, 400);
  ASSERT_EQ(rings.size(), 2u);
  EXPECT_NE(rings[0].is_along_u, rings[1].is_along_u);
}

TEST(RingSizes, AreNotThereWhereBoundsAreSmaller) {
  const Model model = model_from_cage(testing::torus());
  EXPECT_TRUE(short_rings(model, 0, 2).empty());
  EXPECT_EQ(short_rings(model, 0, 8).size(), 1u);
}

TEST(RingSizes, AreNotThereWithoutASeam) {
  const Model model = model_from_cage(testing::sheet(5, 4));
  EXPECT_TRUE(short_rings(model, 0, 400).empty());
}

TEST(RingSizes, AreOfTheSeamOnly) {
  const Ring ring{false, 2, 4, {1, 2, 3}};
  EXPECT_EQ(ring.length_at({2.5, 9}, 0), 1.5);
  EXPECT_EQ(ring.length_at({4, 0}, 0), 3);
  EXPECT_TRUE(std::isinf(ring.length_at({4.5, 0}, 0)));
  EXPECT_TRUE(std::isinf(ring.length_at({1.5, 0}, 0)));
}

Shape tube_of_formula(double from, double to, double radius) {
  return make_callable_surface(Domain{from, to, 0, 100}, [=](auto u, auto v) {
    return std::array{radius * cos(u), radius * sin(u), v};
  });
}

TEST(RingSizes, AreThereAroundATubeOfOneOrMorePatches) {
  for (const int parts : {1, 2, 3, 4, 8}) {
    std::vector<Shape> shapes;
    for (int i = 0; i < parts; ++i) {
      const double part = 2 * std::numbers::pi / parts;
      shapes.push_back(tube_of_formula(part * i, part * (i + 1), 0.03));
    }
    const Model model = testing::model_of(shapes);
    for (int p = 0; p < parts; ++p) {
      SCOPED_TRACE(::testing::Message() << p << " of " << parts);
      const auto rings = short_rings(model, p, 40);
      ASSERT_EQ(rings.size(), 1u);
      EXPECT_TRUE(rings[0].is_along_u);
      const double exact = 2 * std::numbers::pi * 0.03;
      EXPECT_NEAR(rings[0].length_at({0, 37}, 1), exact, 0.003 * exact);
    }
  }
}

TEST(RingSizes, AreNotThereAroundAMoebiusBand) {
  const Model model = testing::model_of(
      {make_callable_surface(Domain{0, 2 * std::numbers::pi, -0.1, 0.1}, [](auto u, auto v) {
        const auto r = 1 + v * cos(u / 2);
        return std::array{r * cos(u), r * sin(u), v * sin(u / 2)};
      })});
  EXPECT_TRUE(short_rings(model, 0, 40).empty());
}

TEST(RingSizes, AtAPoleAreThoseOneElementAway) {
  const Model model = testing::model_of(
      {make_callable_surface(Domain{0, 2 * std::numbers::pi, 0, 1}, [](auto u, auto v) {
        return std::array{v * cos(u), v * sin(u), 20 * (1 - v)};
      })});
  const auto rings = short_rings(model, 0, 40);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].poles, std::vector<double>{0});
  const double slant = std::hypot(1, 20);
  const auto length_from = [&](double v, double element) {
    return rings[0].length_at({1, v}, element) / (2 * std::numbers::pi);
  };
  EXPECT_NEAR(length_from(0, 0.1 * slant), 0.1, 1e-3);
  EXPECT_NEAR(length_from(0.07, 0.1 * slant), 0.1, 1e-3);
  EXPECT_NEAR(length_from(0.3, 0.1 * slant), 0.3, 3e-3);
}

TEST(RingSizes, MayHaveAPoleInside) {
  // A double cone, and a horn torus.
  const std::vector<Shape> shapes = {
      make_callable_surface(Domain{0, 2 * std::numbers::pi, 0, 1},
                            [](auto u, auto v) {
                              const auto r = v - 0.3;
                              return std::array{r * cos(u), r * sin(u), r};
                            }),
      make_callable_surface(
          Domain{0, 2 * std::numbers::pi, 0, 2 * std::numbers::pi}, [](auto u, auto v) {
            return std::array{(1 + cos(v)) * cos(u), (1 + cos(v)) * sin(u), sin(v)};
          })};
  const std::vector<double> poles = {0.3 * std::numbers::sqrt2, std::numbers::pi};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE(i);
    const auto rings = short_rings(testing::model_of({shapes[i]}), 0, 40);
    const auto ring =
        std::find_if(rings.begin(), rings.end(), [](const Ring& r) { return r.is_along_u; });
    ASSERT_NE(ring, rings.end());
    ASSERT_EQ(ring->poles.size(), 1u);
    EXPECT_NEAR(ring->poles[0], poles[i], 0.02 * poles[i]);
  }
}

TEST(RingSizes, AreFoundAtAPoleBetweenLongLines) {
  // A double cone whose lines next to the pole are longer than any ring that is looked for.
  const Model model = testing::model_of(
      {make_callable_surface(Domain{0, 2 * std::numbers::pi, 0, 1}, [](auto u, auto v) {
        const auto r = v - 0.51;
        return std::array{r * cos(u), r * sin(u), r};
      })});
  const auto rings = short_rings(model, 0, 1e-3);
  ASSERT_EQ(rings.size(), 1u);
  ASSERT_EQ(rings[0].poles.size(), 1u);
  EXPECT_NEAR(rings[0].poles[0], 0.51 * std::numbers::sqrt2, 1e-6);
}

TEST(RingSizes, AreNotLookedForWhereCurvatureGivesEnoughElements) {
  const auto greatest = [](double curvature, std::optional<double> sag) {
    Sizing sizing = testing::sizing_of(curvature, 0.01, 3, 2);
    if (sag) sizing.sag = testing::units(*sag);
    return greatest_ring(resolve(sizing, 1));
  };
  EXPECT_DOUBLE_EQ(greatest(0, {}), 12);
  EXPECT_DOUBLE_EQ(greatest(0.25, {}), 0.08);
  EXPECT_DOUBLE_EQ(greatest(2, {}), 12);  // three elements around
  EXPECT_DOUBLE_EQ(greatest(0, 0.001), 0.08);
  EXPECT_DOUBLE_EQ(greatest(0, 0.01), 0.8);
  EXPECT_DOUBLE_EQ(greatest(0.25, 0.01), 0.08);
}

TEST(RingSizes, GoBelowHminButNotWithoutEnd) {
  EXPECT_EQ(size_around(2, bounds(1, 10)), 0.5);
  EXPECT_EQ(size_around(1000, bounds(1, 10)), 10);
  EXPECT_EQ(size_around(0, bounds(1, 10)), 1e-7);
}

}  // namespace
}  // namespace surfmesh
