// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/block_surface.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh {
namespace {

using testing::refined;

constexpr std::array kOrders = {Order::Position, Order::First, Order::Second};

Jet bump(double u, double v, Order order) {
  const auto surface = make_callable_surface({0, 3, 0, 2}, [](auto s, auto t) {
    return std::array{s + 0.1 * t * t, t - 0.2 * s * t, sin(s) * exp(0.3 * t) + 0.1 * s * s * t};
  });
  return surface->evaluate({u, v}, order);
}

/// The part of the bump over one cell, as a surface that lies rotated in it.
std::shared_ptr<const Surface> part(int column, int row, int rotation) {
  return make_callable_surface({0, 1, 0, 1}, [=](auto a, auto b) {
    const auto s = rotation == 0 ? a : rotation == 1 ? b : rotation == 2 ? 1 - a : 1 - b;
    const auto t = rotation == 0 ? b : rotation == 1 ? 1 - a : rotation == 2 ? 1 - b : a;
    const auto u = column + s, v = row + t;
    return std::array{u + 0.1 * v * v, v - 0.2 * u * v, sin(u) * exp(0.3 * v) + 0.1 * u * u * v};
  });
}

/// The bump over [0,3] × [0,2], of six cells that lie in all rotations.
BlockSurface block() {
  std::vector<BlockCell> cells;
  for (int k = 0; k < 6; ++k) cells.push_back({part(k % 3, k / 3, k % 4), k % 4});
  return BlockSurface(3, std::move(cells));
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " and " << b.transpose();
}

void expect_near(const Jet& a, const Jet& b, Order order, double tolerance) {
  expect_near(a.point, b.point, tolerance);
  if (order >= Order::First) {
    expect_near(a.du, b.du, tolerance);
    expect_near(a.dv, b.dv, tolerance);
  }
  if (order >= Order::Second) {
    expect_near(a.duu, b.duu, tolerance);
    expect_near(a.duv, b.duv, tolerance);
    expect_near(a.dvv, b.dvv, tolerance);
  }
}

TEST(BlockSurface, IsTheSurfaceOfItsCells) {
  const BlockSurface surface = block();
  for (const Order order : kOrders) {
    for (const double u : {0.0, 0.3, 1.0, 1.6, 2.0, 2.9, 3.0}) {
      for (const double v : {0.0, 0.45, 1.0, 1.7, 2.0}) {
        expect_near(surface.evaluate({u, v}, order), bump(u, v, order), order, 1e-13);
      }
    }
  }
}

TEST(BlockSurface, IsOverARectangleOfUnitCells) {
  const Domain domain = block().domain();
  EXPECT_EQ(domain.corner(0), (Uv{0, 0}));
  EXPECT_EQ(domain.corner(2), (Uv{3, 2}));
  EXPECT_EQ(block().cells().u, 3);
  EXPECT_EQ(block().cells().v, 2);
}

TEST(BlockSurface, AllowsPointsOutsideByRounding) {
  for (const Uv uv : {Uv{-1e-15, 0.5}, Uv{3 + 1e-15, 0.5}, Uv{1.5, -1e-15}, Uv{1.5, 2 + 1e-15}}) {
    expect_near(block().evaluate(uv, Order::Position).point,
                bump(uv.u, uv.v, Order::Position).point, 1e-13);
  }
}

TEST(BlockSurface, LeavesMembersAboveTheOrderUnset) {
  for (const double u : {0.5, 1.5, 2.5}) {
    const Jet jet = block().evaluate({u, 0.5}, Order::Position);
    EXPECT_FALSE(jet.du.allFinite() || jet.dv.allFinite() || jet.duu.allFinite());
  }
}

TEST(BlockSurface, NamesThePointInErrors) {
  const std::string error = error_of([] { (void)block().evaluate({kUnset, 1.5}, Order::First); });
  EXPECT_TRUE(error.starts_with("geometry: at (nan, 1.5) of a block of faces: ")) << error;
}

TEST(BlockSurface, RefusesCellsThatMakeNoRectangle) {
  const BlockCell cell{part(0, 0, 0), 0};
  EXPECT_EQ(error_of([&] {
              BlockSurface(2, {cell, cell, cell});
            }),
            "invalid input: 3 cells make no rectangle of 2 columns");
  EXPECT_NE(error_of([&] { BlockSurface(0, {cell}); }), "no error");
  EXPECT_NE(error_of([&] { BlockSurface(1, {}); }), "no error");
}

TEST(BlockSurface, RefusesCellsThatAreNotOverTheUnitSquare) {
  const auto wide = make_callable_surface({0, 2, 0, 1}, [](auto u, auto v) {
    return std::array{u, v, u * v};
  });
  EXPECT_EQ(error_of([&] {
              BlockSurface(1, {{wide, 0}});
            }),
            "invalid input: cell 0 of a block is no surface over the unit square");
  EXPECT_NE(error_of([&] { BlockSurface(1, {{nullptr, 0}}); }), "no error");
  EXPECT_NE(error_of([&] { BlockSurface(1, {{part(0, 0, 0), 4}}); }), "no error");
}

// --- of cages ---

/// The patches of a cage that are blocks of more than one face.
std::vector<std::shared_ptr<const Surface>> block_surfaces_of(const Cage& cage) {
  std::vector<std::shared_ptr<const Surface>> blocks;
  for (const Patch& patch : model_from_cage(cage).patches) {
    if (patch.cage_faces.size() > 1) blocks.push_back(patch.surface);
  }
  return blocks;
}

/// Greatest difference of first derivatives on both sides of the edges u = 1, 2, ...
double greatest_jump(const Surface& surface) {
  constexpr double beside = 1e-12;
  const CellCount cells = surface.cells();
  double jump = 0;
  for (int i = 1; i < cells.u; ++i) {
    for (int j = 0; j < cells.v; ++j) {
      for (const double share : {0.1, 0.37, 0.5, 0.93}) {
        const Jet a = surface.evaluate({i - beside, j + share}, Order::First);
        const Jet b = surface.evaluate({i + beside, j + share}, Order::First);
        jump = std::max({jump, (a.du - b.du).norm(), (a.dv - b.dv).norm()});
      }
    }
  }
  return jump;
}

TEST(BlockSurface, HasContinuousDerivativesAcrossEdgesOfACage) {
  for (const Cage& cage : {testing::torus(7, 5), testing::sheet(6, 4), refined(testing::cube(), 2),
                           refined(testing::pentagon_prism(), 2)}) {
    const auto blocks = block_surfaces_of(cage);
    ASSERT_FALSE(blocks.empty());
    for (const auto& block : blocks) EXPECT_LT(greatest_jump(*block), 1e-10);
  }
}

TEST(BlockSurface, HasTheSingularPointsOfItsFaces) {
  std::size_t count = 0;
  for (const auto& block : block_surfaces_of(refined(testing::quad_fan(6), 1))) {
    const Domain domain = block->domain();
    for (const SingularPoint& singular : block->singular_points()) {
      const auto [u, v] = singular.at;
      EXPECT_TRUE(u == domain.u0 || u == domain.u1 || v == domain.v0 || v == domain.v1);
      EXPECT_TRUE(u == std::round(u) && v == std::round(v));
      count += block->evaluate(singular.at, Order::Position).point.head<2>().norm() < 1e-9;
    }
  }
  EXPECT_EQ(count, 3u);
}

TEST(BlockSurface, IsBesideTheRoundingsOfItsFaces) {
  Cage cage = testing::sheet(4, 4);
  cage.creases = {{{10, 11}, 6}, {{11, 12}, 6}, {{12, 13}, 6}, {{13, 14}, 6}};
  for (const auto& block : block_surfaces_of(cage)) {
    const Domain domain = block->domain();
    double greatest = 0;
    for (const double s : {0.0, 0.25, 0.7, 1.0}) {
      for (const double t : {0.0, 1.0}) {
        const Uv uv = domain.at(s, t);
        const Uv beside = block->beside_roundings(uv);
        greatest = std::max({greatest, std::abs(beside.u - uv.u), std::abs(beside.v - uv.v)});
      }
    }
    EXPECT_NEAR(greatest, std::exp2(-5), 1e-12);
    const Uv middle = domain.at(0.5, 0.5);
    EXPECT_EQ(block->beside_roundings(middle), middle);
  }
}

}  // namespace
}  // namespace surfmesh
