// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_cells.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/control_nodes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "surfmesh/core/validate.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::kFlat;
using testing::query;
using testing::random_points;

constexpr Domain kTriangle{0, 1, 0, 1, Domain::Shape::Triangle};

/// Cells of a plane, with sizes by a function.
template <class Size>
std::unique_ptr<ControlCells> cells_of(const Domain& domain, Size size,
                                       const ControlSpaceOptions& options = {},
                                       CellCount roots = {2, 2}) {
  return std::make_unique<ControlCells>(
      domain, roots, [size](Uv uv) { return testing::node(uv, size(uv)); }, options,
      std::vector<ControlNode>());
}

SizeTensor constant(Uv) { return isotropic(0.3); }

/// Halve the leaf at each of the points, along u and v in turn.
void halve_at(ControlCells& cells, const std::vector<Uv>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    cells.halve(cells.tree().find(points[i]), i % 2 == 0);
  }
}

/// Sum of the areas of the faces of a control mesh in parameters.
double area_of_faces(const PolyMesh& mesh) {
  const auto uv = require(mesh, keys::vertex_uv);
  double area = 0;
  for (const FaceHandle fh : mesh.faces()) {
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      area += 0.5 * cross(mesh.property(uv, mesh.from_vertex_handle(heh)),
                          mesh.property(uv, mesh.to_vertex_handle(heh)));
    }
  }
  return area;
}

/// To the last bit by bilinear shares; those of three nodes need not have the sum 1 exactly.
TEST(ControlCells, ReproduceAConstantFieldInATriangle) {
  const auto cells = cells_of(kTriangle, constant);
  halve_at(*cells, random_points(kTriangle, 40));
  for (const Uv uv : random_points(kTriangle, 500, 2)) {
    expect_near(query(*cells, uv), constant(uv), 1e-14);
  }
}

TEST(ControlCells, ReproduceAConstantFieldExactly) {
  const auto cells = cells_of({}, constant);
  halve_at(*cells, random_points({}, 40));
  for (const Uv uv : random_points({}, 500, 2)) ASSERT_EQ(query(*cells, uv), constant(uv));
}

TEST(ControlCells, ReproduceALinearField) {
  const Domain domain{-1, 2, 0, 5};
  const auto linear = [](Uv uv) { return isotropic(2 + 0.3 * uv.u + 0.1 * uv.v); };
  const auto cells = cells_of(domain, linear);
  halve_at(*cells, random_points(domain, 40));
  for (const Uv uv : random_points(domain, 500, 2)) {
    expect_near(query(*cells, uv), linear(uv), 1e-13);
  }
}

TEST(ControlCells, ReproduceALinearFieldBelowADiagonal) {
  const auto linear = [](Uv uv) { return isotropic(2 + 0.3 * uv.u + 0.1 * uv.v); };
  const auto cells = cells_of(kTriangle, linear);
  for (const Uv uv : random_points({}, 40)) halve_at(*cells, {kTriangle.fold(uv)});
  for (const Uv uv : random_points({}, 500, 2)) {
    expect_near(query(*cells, kTriangle.fold(uv)), linear(kTriangle.fold(uv)), 1e-13);
  }
}

TEST(ControlCells, HaveNoNodeBeyondADiagonal) {
  const auto cells = cells_of(kTriangle, constant);
  for (const Uv uv : random_points({}, 40)) halve_at(*cells, {kTriangle.fold(uv)});
  for (int node = 0; node < cells->node_count(); ++node) {
    EXPECT_LE(cells->uv(node).u + cells->uv(node).v, 1 + 1e-15);
  }
}

TEST(ControlCells, TakeTheSizesOfTheRimOutside) {
  const auto linear = [](Uv uv) { return isotropic(1 + uv.u); };
  const auto cells = cells_of({}, linear);
  EXPECT_EQ(query(*cells, {-5, 0.5}), isotropic(1));
  expect_near(query(*cells, {1e100, 0.5}), isotropic(2), 1e-15);
}

TEST(ControlCells, FindEveryLeafFromAnyOther) {
  const auto cells = cells_of({}, constant);
  halve_at(*cells, random_points({}, 60));
  int near = 0;
  for (const Uv uv : random_points({}, 300, 2)) {
    near = cells->tree().find(uv, near);
    EXPECT_TRUE(cells->tree().cell(near).is_leaf());
    EXPECT_EQ(near, cells->tree().find(uv));
  }
}

TEST(ControlCells, ShareNodesWithTheirNeighbours) {
  const auto cells = cells_of({}, constant);
  halve_at(*cells, random_points({}, 60));
  std::set<std::pair<double, double>> places;
  for (int node = 0; node < cells->node_count(); ++node) {
    const Uv uv = cells->uv(node);
    EXPECT_TRUE(places.insert({uv.u, uv.v}).second) << uv.u << ' ' << uv.v;
  }
}

class FacesOfCells : public ::testing::TestWithParam<bool> {};

TEST_P(FacesOfCells, CoverTheDomainAndConform) {
  const auto shape = GetParam() ? Domain::Shape::Triangle : Domain::Shape::Rectangle;
  const Domain domain{0, 1, 0, 1, shape};
  const auto cells = cells_of(domain, constant);
  for (const Uv uv : random_points({}, 60)) halve_at(*cells, {domain.fold(uv)});
  cells->finish();
  testing::expect_valid(cells->mesh());
  const MeshTopology topology = measure_topology(cells->mesh());
  EXPECT_EQ(topology.components, 1U);
  EXPECT_EQ(topology.euler, 1);
  EXPECT_NEAR(area_of_faces(cells->mesh()), GetParam() ? 0.5 : 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, FacesOfCells, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "Triangle" : "Rectangle"; });

TEST(ControlCells, GiveTheirNodesAsVerticesWithTheirProperties) {
  const auto cells = cells_of({}, [](Uv uv) { return isotropic(1 + uv.u); });
  cells->finish();
  const PolyMesh& mesh = cells->mesh();
  ASSERT_EQ(mesh.n_vertices(), 25U);
  EXPECT_EQ(mesh.n_faces(), 16U);
  for (const VertexHandle vh : mesh.vertices()) {
    const Uv uv = mesh.property(require(mesh, keys::vertex_uv), vh);
    EXPECT_EQ(mesh.property(require(mesh, keys::vertex_size), vh), isotropic(1 + uv.u));
  }
  EXPECT_TRUE(find(mesh, keys::vertex_radius).is_valid());
  EXPECT_TRUE(find(mesh, keys::face_class).is_valid());
}

TEST(ControlCells, AreGraded) {
  const auto spike = [](Uv uv) { return isotropic(uv == Uv{0.5, 0.5} ? 0.01 : 10); };
  const auto cells = cells_of({}, spike, {.grade = 1.5}, {16, 16});
  cells->grade_all(RunContext());
  for (const Uv uv : random_points({}, 300)) {
    const double distance = std::hypot(uv.u - 0.5, uv.v - 0.5);
    // A cell of rounding, and ways along rows and diagonals.
    EXPECT_LE(query(*cells, uv).h11, 0.01 + 1.1 * std::log(1.5) * (distance + 0.05));
    EXPECT_GE(query(*cells, uv).h11, 0.01 + 0.99 * std::log(1.5) * (distance - 0.05));
  }
}

TEST(ControlCells, AreHalvedBesideFinerOnesThatTheyMiss) {
  // A small size between the nodes of a wide cell, on its side, where only a fine neighbour has
  // one.
  const auto cells = cells_of({},
                              [](Uv uv) {
                                return isotropic(uv == Uv{0.5, 0.3125} ? 0.01 : 1);
                              },
                              {.grade = 1.5});
  halve_at(*cells, {{0.4, 0.3}, {0.4, 0.3}, {0.4, 0.3}, {0.45, 0.3}, {0.45, 0.3}, {0.45, 0.3}});
  cells->grade_all(RunContext());
  int left = cells->tree().find({0.499, 0.3125}), right = cells->tree().find({0.501, 0.3125});
  EXPECT_NEAR(cells->lattice_size({0.499, 0.3125}, left).h11, 0.01, 0.001);
  EXPECT_NEAR(cells->lattice_size({0.501, 0.3125}, right).h11, 0.01, 0.001);
}

// All were compared in each round of gradation, of which thin walls need hundreds.
TEST(ControlCells, AreComparedWithFinerOnesWhereSizesHaveChanged) {
  const auto cells = cells_of({}, constant, {.grade = 1.5}, {16, 16});
  halve_at(*cells, random_points({}, 40));
  while (!cells->divide_beside_finer().empty()) {
  }
  const std::size_t before = cells->comparisons();
  EXPECT_GE(before, 16u * 16u);
  EXPECT_TRUE(cells->divide_beside_finer().empty());
  EXPECT_EQ(cells->comparisons(), before);
  cells->set_size(0, isotropic(0.31));
  EXPECT_TRUE(cells->divide_beside_finer().empty());
  EXPECT_GT(cells->comparisons(), before);
  EXPECT_LE(cells->comparisons(), before + 4);
}

TEST(ControlCells, GradeFromANewNodeAsFromTheBeginning) {
  const auto peak = [](Uv uv) { return isotropic(uv == Uv{0, 0} ? 0.01 : 5); };
  const auto whole = cells_of({}, peak, {.grade = 1.5}, {8, 8});
  const auto later = cells_of({}, [](Uv) { return isotropic(5); }, {.grade = 1.5}, {8, 8});
  whole->grade_all(RunContext());
  later->grade_all(RunContext());
  later->set_size(0, isotropic(0.01));
  later->grade({0}, RunContext());
  for (int node = 0; node < whole->node_count(); ++node) {
    EXPECT_NEAR(later->size(node).h11, whole->size(node).h11, 2e-3 * whole->size(node).h11);
  }
}

TEST(ControlCells, HoldAGradedPointExactly) {
  const auto cells = cells_of({}, [](Uv) { return isotropic(1); }, {.grade = 1.5});
  cells->hold_points({testing::node({0.37, 0.61}, isotropic(0.05))});
  cells->grade_all(RunContext());
  cells->finish();
  expect_near(query(*cells, {0.37, 0.61}), isotropic(0.05), 1e-12);
  EXPECT_NEAR(query(*cells, {0.47, 0.61}).h11, 0.05 + std::log(1.5) * 0.1, 1e-3);
  EXPECT_LE(query(*cells, {1, 1}).h11, 0.05 + 1.1 * std::log(1.5) * std::hypot(0.63, 0.39));
}

TEST(ControlCells, PassTheSizesOfAPointToCellsThatAreHalvedLater) {
  const auto cells = cells_of({}, [](Uv) { return isotropic(1); }, {.grade = 1.5});
  cells->hold_points({testing::node({0.37, 0.61}, isotropic(0.05))});
  cells->grade_all(RunContext());
  const std::vector<int> added = cells->divide_cell({0.37, 0.61}, {400, 0, 400}, 1);
  ASSERT_FALSE(added.empty());
  cells->grade(cells->with_neighbours(added), RunContext());
  for (const int node : added) {
    const double distance = std::hypot(cells->uv(node).u - 0.37, cells->uv(node).v - 0.61);
    EXPECT_LE(cells->size(node).h11, 0.05 + 1.2 * std::log(1.5) * distance);
  }
}

TEST(ControlCells, JoinPointsAlongABand) {
  const auto cells = cells_of({}, [](Uv) { return isotropic(1); }, {.grade = 1.5});
  cells->join_row_nodes(cells->hold_points({testing::node({0.40, 0.6}, isotropic(0.1)),
                                            testing::node({0.52, 0.6}, isotropic(0.1)),
                                            testing::node({0.95, 0.1}, isotropic(0.1))}));
  cells->grade_all(RunContext());
  cells->finish();
  expect_near(query(*cells, {0.46, 0.6}), isotropic(0.1), 1e-12);
  EXPECT_GT(query(*cells, {0.73, 0.35}).h11, 0.15);
}

TEST(ControlCells, HoldAPointExactlyWithoutGradation) {
  const auto cells = cells_of({}, [](Uv) { return isotropic(1); });
  cells->hold_points({testing::node({0.37, 0.61}, isotropic(0.05))});
  EXPECT_EQ(query(*cells, {0.37, 0.61}), isotropic(0.05));
  EXPECT_EQ(query(*cells, {0.9, 0.1}), isotropic(1));
}

TEST(ControlCells, AverageLengthsGeometricallyIfAskedTo) {
  const auto two = [](Uv uv) { return isotropic(uv.u < 0.1 ? 0.01 : 1); };
  const auto cells = cells_of({}, two, {.blend = Blend::Logarithmic});
  cells->finish();
  EXPECT_NEAR(query(*cells, {0.125, 0.5}).h11, 0.1, 1e-12);
}

TEST(ControlCells, RefuseAPointOutsideByItsPlace) {
  const auto cells = cells_of({}, constant);
  const std::string error = error_of([&] {
    cells->hold_points({testing::node({0.5, 1.25}, isotropic(1))});
  });
  EXPECT_NE(error.find("(0.5, 1.25)"), std::string::npos) << error;
}

TEST(ControlCells, StopDividingAtTheEndOfTheirGrid) {
  const auto cells = cells_of({}, constant);
  const Metric tiny{1e40, 0, 1e40};
  int divided = 0;
  while (!cells->divide_cell({0.3, 0.3}, tiny, 1).empty()) ++divided;
  EXPECT_GT(divided, 40);
  EXPECT_LT(divided, 64);
}

}  // namespace
}  // namespace surfmesh
