// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_grid.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/control_nodes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "surfmesh/metric/conformity.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::query;
using testing::random_points;

/// Small sizes, so that nodes of a mesh do not merge.
SizeTensor smooth(Uv uv) {
  return size_tensor(0.02 + 0.01 * std::sin(3 * uv.u), 0.01 + 0.005 * std::cos(2 * uv.v),
                     0.5 * uv.u * uv.v);
}

/// The greatest conformity with the smooth field at random points.
double error_of_control(const ControlSpace& control) {
  double worst = 0;
  for (const Uv uv : random_points({}, 3000)) {
    worst = std::max(worst, log_conformity(smooth(uv), query(control, uv)));
  }
  return worst;
}

TEST(ControlGrid, ReproducesAConstantFieldExactly) {
  const SizeTensor size = size_tensor(0.3, 0.07, 0.4);
  const ControlGrid control({}, testing::grid({}, 5, [&](Uv) { return size; }), {});
  for (const Uv uv : random_points({}, 500)) ASSERT_EQ(query(control, uv), size);
}

TEST(ControlGrid, ReproducesALinearField) {
  const Domain domain{-1, 2, 0, 5};
  const auto linear = [](Uv uv) { return isotropic(2 + 0.3 * uv.u + 0.1 * uv.v); };
  const ControlGrid control(domain, testing::grid(domain, 4, linear), {});
  for (const Uv uv : random_points(domain, 500)) {
    expect_near(query(control, uv), linear(uv), 1e-14);
  }
}

TEST(ControlGrid, ConvergesAtSecondOrderAndInverseDistancesAtFirst) {
  const auto coarse = testing::grid({}, 11, smooth), fine = testing::grid({}, 41, smooth);
  const double grid_order = std::log2(error_of_control(ControlGrid({}, coarse, {})) /
                                      error_of_control(ControlGrid({}, fine, {}))) /
                            2;
  const ControlSpaceOptions by_distance = {.interpolation = Interpolation::Triangle};
  const double mesh_order = std::log2(error_of_control(ControlMesh({}, coarse, by_distance)) /
                                      error_of_control(ControlMesh({}, fine, by_distance))) /
                            2;
  EXPECT_NEAR(grid_order, 2, 0.2);
  EXPECT_NEAR(mesh_order, 1, 0.2);
}

TEST(ControlGrid, TakesTheSizesOfItsRimOutside) {
  const auto linear = [](Uv uv) { return isotropic(1 + uv.u); };
  const ControlGrid control({}, testing::grid({}, 3, linear), {});
  EXPECT_EQ(query(control, {-5, 0.5}), isotropic(1));
  expect_near(query(control, {1e100, 0.5}), isotropic(2), 1e-15);
}

TEST(ControlGrid, LowersTheCellOfAFurtherNode) {
  const auto regular = testing::grid({}, 5, [](Uv) { return isotropic(1); });
  ControlGrid control({}, regular, {});
  control.hold_points({testing::node({0.6, 0.6}, isotropic(0.1))});
  EXPECT_EQ(query(control, {0.6, 0.6}), isotropic(0.1));
  EXPECT_EQ(query(control, {0.2, 0.2}), isotropic(1));
}

TEST(ControlGrid, IsGraded) {
  const auto spike = [](Uv uv) { return isotropic(uv == Uv{0.5, 0.5} ? 0.01 : 10); };
  ControlGrid control({}, testing::grid({}, 21, spike), {.grade = 1.5});
  control.grade_all(RunContext());
  for (const Uv uv : random_points({}, 300)) {
    const double distance = std::hypot(uv.u - 0.5, uv.v - 0.5);
    // A cell of rounding, and ways along rows and diagonals.
    EXPECT_LE(query(control, uv).h11, 0.01 + 1.1 * std::log(1.5) * (distance + 0.075));
  }
}

TEST(ControlGrid, GivesItsNodesAsAMesh) {
  ControlGrid control({}, testing::grid({}, 4, smooth), {});
  control.finish();
  testing::expect_valid(control.mesh());
  EXPECT_EQ(control.mesh().n_vertices(), 16U);
  EXPECT_EQ(control.mesh().n_faces(), 9U);
  const auto size = require(control.mesh(), keys::vertex_size);
  EXPECT_EQ(control.mesh().property(size, VertexHandle(15)), smooth({1, 1}));
}

TEST(ControlGrid, RefusesWhatIsNoSquareGrid) {
  auto nodes = testing::grid({}, 3, smooth);
  nodes.pop_back();
  const std::string error = error_of([&] { ControlGrid({}, nodes, {}); });
  EXPECT_EQ(error.rfind(name(ErrorCode::InvalidInput), 0), 0U) << error;
  EXPECT_NE(error.find("8 nodes"), std::string::npos) << error;
}

TEST(ControlGrid, RefusesANodeOutsideByItsPlace) {
  const auto nodes = testing::grid({}, 3, smooth);
  const std::string error = error_of([&] {
    ControlGrid({}, nodes, {}).hold_points({testing::node({0.5, 1.25}, isotropic(1))});
  });
  EXPECT_NE(error.find("(0.5, 1.25)"), std::string::npos) << error;
}

}  // namespace
}  // namespace surfmesh
