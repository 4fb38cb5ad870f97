// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/divide_far_quads.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "quad/grid_patch.hh"
#include "support/expect_valid.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh::detail {
namespace {

using testing::GridPatch;

/// A plane of 10 × 10 with a bump as wide as one quad in the middle of that at (5, 5).
std::shared_ptr<const Surface> bump(double height) {
  return make_callable_surface({0, 10, 0, 10}, [height](auto u, auto v) {
    const auto x = u - 5.5, y = v - 5.5;
    return std::array{u, v, height * exp(-8 * (x * x + y * y))};
  });
}

/// The greatest height of the surface above the four triangles on either side of the diagonals of
/// a quad, over all quads.
double greatest_sag(const GridPatch& patch, const Surface& surface) {
  const auto point = [&](Uv uv) { return surface.evaluate(uv, Order::Position).point; };
  double greatest = 0;
  for (const FaceHandle fh : patch.mesh.faces()) {
    const std::vector<VertexHandle> v = testing::cycle_of(patch.mesh, fh);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::array<Uv, 3> t = {patch.uv(v[k]), patch.uv(v[(k + 1) % 4]),
                                   patch.uv(v[(k + 2) % 4])};
      const Uv middle = 1.0 / 3 * (t[0] + t[1] + t[2]), half = 0.5 * (t[0] + t[2]);
      const double flat = (point(t[0]).z() + point(t[1]).z() + point(t[2]).z()) / 3;
      greatest = std::max({greatest, std::abs(point(middle).z() - flat),
                           std::abs(point(half).z() - 0.5 * (point(t[0]).z() + point(t[2]).z()))});
    }
  }
  return greatest;
}

QueryCounts divide(GridPatch& patch, const Surface& surface, double sag) {
  return divide_far_quads(patch.mesh, surface, patch.field, patch.number.fixed(), sag,
                          RunContext());
}

TEST(DivideFarQuads, BringsAQuadNearABumpOfItsSize) {
  GridPatch patch(10, 10);
  const auto surface = bump(0.3);
  constexpr double sag = 0.08;
  ASSERT_GT(greatest_sag(patch, *surface), 2 * sag);
  EXPECT_GT(divide(patch, *surface, sag).total(), 0u);
  testing::expect_valid(patch.mesh);
  EXPECT_GT(patch.mesh.n_faces(), 100u);
  EXPECT_LT(greatest_sag(patch, *surface), 1.05 * sag);
  for (const FaceHandle fh : patch.mesh.faces()) EXPECT_EQ(patch.mesh.valence(fh), 4u);
}

TEST(DivideFarQuads, LeavesTheBoundaryAndGoodShapes) {
  GridPatch patch(10, 10);
  const std::vector<Uv> before = patch.positions();
  divide(patch, *bump(0.3), 0.08);
  for (std::size_t v = 0; v < patch.number.fixed(); ++v) {
    EXPECT_EQ(patch.uv(VertexHandle(static_cast<int>(v))), before[v]);
  }
  const PatchGeometry geometry(patch.mesh, patch.field, patch.number.fixed());
  for (const FaceHandle fh : patch.mesh.faces()) {
    EXPECT_GE(geometry.measure(fh).least_jacobian, 0.2);
  }
}

TEST(DivideFarQuads, LeavesQuadsThatAreNear) {
  GridPatch patch(10, 10);
  const std::vector<Uv> before = patch.positions();
  EXPECT_EQ(divide(patch, *bump(0.3), 0.5).total(), 0u);
  EXPECT_EQ(patch.positions(), before);
  EXPECT_EQ(patch.mesh.n_faces(), 100u);
}

/// Then sizes are to become smaller.
TEST(DivideFarQuads, LeavesQuadsWhereTooManyAreFar) {
  GridPatch patch(10, 10);
  const auto wave = make_callable_surface({0, 10, 0, 10}, [](auto u, auto v) {
    return std::array{u, v, sin(2 * u)};
  });
  divide(patch, *wave, 0.01);
  EXPECT_EQ(patch.mesh.n_faces(), 100u);
}

}  // namespace
}  // namespace surfmesh::detail
