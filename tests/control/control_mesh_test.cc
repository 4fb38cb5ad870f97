// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/control_mesh.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>

#include "support/control_nodes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/waves.hh"
#include "surfmesh/control/grade_sizes.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/gradation.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::grid;
using testing::kFlat;
using testing::node;
using testing::place;
using testing::query;
using testing::random_points;
using testing::with_corners;

constexpr double kGradationTolerance = 1e-3;

ControlMesh random_space(int count, double grade = 0) {
  return ControlMesh({}, testing::random_nodes(count), {.grade = grade});
}

SizeTensor size_at(const ControlMesh& control, VertexHandle vh) {
  return control.mesh().property(require(control.mesh(), keys::vertex_size), vh);
}

Uv uv_at(const ControlMesh& control, VertexHandle vh) {
  return control.mesh().property(require(control.mesh(), keys::vertex_uv), vh);
}

TEST(ControlMesh, HasAValidMesh) {
  const ControlMesh control = random_space(1000);
  testing::expect_valid(control.mesh());
  const std::size_t vertices = control.mesh().n_vertices();
  EXPECT_GT(vertices, 950U);  // some are near each other
  EXPECT_EQ(vertices + control.mesh().n_faces(), control.mesh().n_edges() + 1);
}

TEST(ControlMesh, KeepsNothingOfItsTriangulationBesideTheMesh) {
  const ControlMesh control = random_space(100);
  EXPECT_FALSE(find(control.mesh(), keys::vertex_metric).is_valid());
  EXPECT_FALSE(find(control.mesh(), keys::edge_constrained).is_valid());
}

TEST(ControlMesh, ReproducesAConstantFieldExactly) {
  const SizeTensor size = size_tensor(0.3, 0.07, 0.4);
  const ControlMesh control({}, grid({}, 7, [&](Uv) { return size; }), {});
  QueryHint hint;
  for (const Uv uv : random_points({}, 1000)) {
    ASSERT_EQ(control.size(place(uv, {2, 0.5, 3}), hint), size);
  }
}

TEST(ControlMesh, GivesTheTensorOfANodeAtItsPosition) {
  const ControlMesh control = random_space(500);
  for (const VertexHandle vh : control.mesh().vertices()) {
    EXPECT_EQ(query(control, uv_at(control, vh)), size_at(control, vh));
  }
}

TEST(ControlMesh, StaysWithinTheSizesOfItsNodes) {
  const ControlMesh control = random_space(500);
  double least = 1, largest = 0;
  for (const VertexHandle vh : control.mesh().vertices()) {
    least = std::min(least, principal_sizes(size_at(control, vh)).l_t);
    largest = std::max(largest, principal_sizes(size_at(control, vh)).l_s);
  }
  for (const Uv uv : random_points({}, 2000)) {
    const PrincipalSizes sizes = principal_sizes(query(control, uv));
    ASSERT_GE(sizes.l_t, least * (1 - 1e-12));
    ASSERT_LE(sizes.l_s, largest * (1 + 1e-12));
  }
}

TEST(ControlMesh, WeighsByTheInverseSquaresOfDistances) {
  const Domain domain{};
  const ControlMesh control(domain,
                            with_corners(domain, isotropic(1), {node({0.5, 0.5}, isotropic(2))}),
                            {.interpolation = Interpolation::Triangle});
  // From (0.5, 0.25): 1/16 to the middle, 5/16 to the corners below, in any triangle that holds it.
  const double expected = (16 * 2 + 2 * 3.2 * 1) / (16 + 2 * 3.2);
  EXPECT_NEAR(query(control, {0.5, 0.25}).h11, expected, 1e-14);
}

TEST(ControlMesh, TakesDistancesThroughTheFirstForm) {
  const Domain domain{};
  const ControlMesh control(domain,
                            with_corners(domain, isotropic(1), {node({0.5, 0.5}, isotropic(2))}),
                            {.interpolation = Interpolation::Triangle});
  // u counts ten times: 1/16 to the middle, 25 + 1/16 to the corners below.
  const double expected = (16 * 2 + 2 / 25.0625) / (16 + 2 / 25.0625);
  EXPECT_NEAR(query(control, {0.5, 0.25}, {10, 0, 1}).h11, expected, 1e-14);
}

TEST(ControlMesh, TurnsSizesIntoTheMetric) {
  const ControlMesh control = random_space(100);
  QueryHint hint;
  const FirstFormFactor form{2, 0.5, 3};
  const Metric expected = metric_from_size(form, query(control, {0.3, 0.6}, form));
  EXPECT_EQ(control.metric(place({0.3, 0.6}, form), hint), expected);
}

TEST(ControlMesh, ConvergesToASmoothField) {
  const auto exact = [](Uv uv) { return isotropic(0.01 + 0.005 * std::sin(3 * uv.u + 2 * uv.v)); };
  std::array<double, 2> errors{};
  for (std::size_t k = 0; k < 2; ++k) {
    const ControlMesh control({}, grid({}, k == 0 ? 11 : 41, exact), {});
    for (const Uv uv : random_points({}, 2000)) {
      errors[k] = std::max(errors[k], std::abs(query(control, uv).h11 - exact(uv).h11));
    }
  }
  EXPECT_LT(errors[1], 0.35 * errors[0]);
}

// --- near nodes ---

TEST(ControlMesh, MakesOneOfNearNodesWithTheMinimumOfBoth) {
  const Domain domain{};
  const auto nodes = with_corners(
      domain, isotropic(1), {node({0.5, 0.5}, {0.2, 0, 0.4}), node({0.5, 0.51}, {0.4, 0, 0.2})});
  const ControlMesh control(domain, nodes, {});
  EXPECT_EQ(control.mesh().n_vertices(), 5U);
  expect_near(query(control, uv_at(control, VertexHandle(4))), isotropic(0.2), 1e-9);
}

TEST(ControlMesh, KeepsNodesThatAreATenthOfTheSizeApart) {
  const Domain domain{};
  const auto nodes = with_corners(
      domain, isotropic(1), {node({0.5, 0.5}, isotropic(0.2)), node({0.5, 0.521}, isotropic(0.2))});
  EXPECT_EQ(ControlMesh(domain, nodes, {}).mesh().n_vertices(), 6U);
}

TEST(ControlMesh, MakesOneOfNodesAtOnePosition) {
  const Domain domain{};
  const auto nodes = with_corners(
      domain, isotropic(1), {node({0.5, 0.5}, {0.2, 0, 0.4}), node({0.5, 0.5}, {0.4, 0, 0.2})});
  const ControlMesh control(domain, nodes, {});
  EXPECT_EQ(control.mesh().n_vertices(), 5U);
  expect_near(query(control, {0.5, 0.5}), isotropic(0.2), 1e-9);
}

TEST(ControlMesh, TakesTheMinimumOfNodesAtOneCorner) {
  const Domain domain{};
  const auto nodes = with_corners(domain, isotropic(1), {node({1, 1}, isotropic(0.2))});
  const ControlMesh control(domain, nodes, {});
  expect_near(query(control, {1, 1}), isotropic(0.2), 1e-9);
  EXPECT_EQ(query(control, {0, 0}), isotropic(1));
}

TEST(ControlMesh, KeepsTheCornersOfAPatchMuchSmallerThanItsElements) {
  const Domain domain{0, 1e-3, 0, 1e-3};
  const auto nodes = grid(domain, 5, [](Uv) { return isotropic(1); });
  const ControlMesh control(domain, nodes, {});
  EXPECT_EQ(control.mesh().n_vertices(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(query(control, domain.corner(i)), isotropic(1));
  }
}

// --- gradation ---

/// Greatest conformity between a size and the one its neighbours allow.
double worst_gradation(const ControlMesh& control, double grade,
                       const FirstFormFactor& form = kFlat) {
  double worst = 0;
  for (const HalfedgeHandle heh : control.mesh().halfedges()) {
    const VertexHandle i = control.mesh().from_vertex_handle(heh);
    const VertexHandle j = control.mesh().to_vertex_handle(heh);
    const Uv edge = uv_at(control, j) - uv_at(control, i);
    const Metric metric = metric_from_size(form, size_at(control, i));
    const double length_m = std::sqrt(squared_length(metric, edge));
    const SizeTensor allowed =
        limited_size(size_at(control, j), size_at(control, i), 1 + std::log(grade) * length_m);
    worst = std::max(worst, log_conformity(size_at(control, j), allowed));
  }
  return worst;
}

ControlMesh isotropic_space(int count, double grade) {
  std::vector<ControlNode> nodes = testing::random_nodes(count);
  for (ControlNode& node : nodes) node.size = isotropic(node.size.h11);
  return ControlMesh({}, nodes, {.grade = grade});
}

TEST(Gradation, LeavesNoNeighbourThatViolatesIt) {
  for (const double grade : {1.0, 1.2, 1.5, 3.0}) {
    EXPECT_LE(worst_gradation(isotropic_space(2000, grade), grade), kGradationTolerance) << grade;
  }
  EXPECT_GT(worst_gradation(isotropic_space(2000, 0), 1.5), 0.1);
}

TEST(Gradation, LeavesLittleWhereStretchedSizesCross) {
  // There the limit stops at the least length of both, of which one may fall later.
  for (const double grade : {1.2, 1.5, 3.0}) {
    EXPECT_LE(worst_gradation(random_space(2000, grade), grade), 0.05) << grade;
  }
}

TEST(Gradation, GivesACone) {
  // From one small size the others grow by ln g a unit of length.
  const auto spike = [](Uv uv) { return isotropic(uv == Uv{0.5, 0.5} ? 0.01 : 10); };
  const ControlMesh control({}, grid({}, 21, spike), {.grade = 1.5});
  for (const VertexHandle vh : control.mesh().vertices()) {
    const Uv step = uv_at(control, vh) - Uv{0.5, 0.5};
    const double size = size_at(control, vh).h11;
    const double distance = std::hypot(step.u, step.v);
    // Along edges the way is longer than straight, by at most the secant of π/8.
    EXPECT_GE(size, (0.01 + std::log(1.5) * distance) * (1 - 20 * kGradationTolerance));
    EXPECT_LE(size, (0.01 + 1.083 * std::log(1.5) * distance) * (1 + 20 * kGradationTolerance));
  }
}

TEST(Gradation, LeavesAFieldThatRespectsItBitByBit) {
  const auto gentle = [](Uv uv) { return isotropic(0.1 + 0.3 * uv.u); };
  const auto nodes = grid({}, 21, gentle);
  const ControlMesh control({}, nodes, {.grade = 1.5});
  for (const VertexHandle vh : control.mesh().vertices()) {
    EXPECT_EQ(size_at(control, vh), gentle(uv_at(control, vh)));
  }
}

TEST(Gradation, ByOneGivesTheLeastSizeEverywhere) {
  const auto spike = [](Uv uv) { return isotropic(uv == Uv{0.5, 0.5} ? 0.01 : 10); };
  const ControlMesh control({}, grid({}, 9, spike), {.grade = 1});
  for (const VertexHandle vh : control.mesh().vertices()) {
    EXPECT_NEAR(size_at(control, vh).h11, 0.01, 0.01 * 10 * kGradationTolerance);
  }
}

TEST(Gradation, NeverRaisesALength) {
  const ControlMesh before = random_space(500, 0), after = random_space(500, 1.2);
  for (const VertexHandle vh : before.mesh().vertices()) {
    const SizeRange old_range = size_range(size_at(before, vh));
    const SizeRange new_range = size_range(size_at(after, vh));
    EXPECT_LE(new_range.least, old_range.least * (1 + 1e-9));
    EXPECT_LE(new_range.greatest, old_range.greatest * (1 + 1e-9));
  }
}

TEST(Gradation, NeverGoesBelowTheLeastLength) {
  // The minimum of two stretched sizes that cross is shorter than both.
  double least = 1;
  const ControlMesh before = random_space(500, 0), after = random_space(500, 1.0);
  for (const VertexHandle vh : before.mesh().vertices()) {
    least = std::min(least, size_range(size_at(before, vh)).least);
  }
  for (const VertexHandle vh : after.mesh().vertices()) {
    EXPECT_GE(size_range(size_at(after, vh)).least, least * (1 - 1e-9));
  }
}

// --- queries ---

TEST(Query, FromFourThreadsEqualsTheSerialOneBitByBit) {
  const ControlMesh control = random_space(5000);
  std::array<std::vector<SizeTensor>, 4> parallel, serial;
  const auto ask = [&](std::size_t part, std::vector<SizeTensor>& answers) {
    QueryHint hint;
    for (const Uv uv : random_points({}, 5000, static_cast<unsigned>(part))) {
      answers.push_back(control.size(place(uv), hint));
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 4; ++k) threads.emplace_back([&, k] { ask(k, parallel[k]); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < 4; ++k) ask(k, serial[k]);
  EXPECT_EQ(parallel, serial);
}

TEST(Query, DoesNotDependOnTheHint) {
  const ControlMesh control = random_space(5000);
  QueryHint warm;
  for (const Uv uv : random_points({}, 5000)) {
    ASSERT_EQ(control.size(place(uv), warm), query(control, uv));
  }
}

TEST(Query, DoesNotDependOnTheOrderOfPoints) {
  const ControlMesh control = random_space(5000);
  std::vector<Uv> points = random_points({}, 3000);
  QueryHint hint;
  std::vector<SizeTensor> forth, back;
  for (const Uv uv : points) forth.push_back(control.size(place(uv), hint));
  std::reverse(points.begin(), points.end());
  for (const Uv uv : points) back.push_back(control.size(place(uv), hint));
  std::reverse(back.begin(), back.end());
  EXPECT_EQ(forth, back);
}

TEST(Query, OfAPointOutsideByRoundingIsThatOfTheBoundary) {
  const Domain domain{0.1, 0.7, -1.0 / 3, 2};
  const ControlMesh control(domain, grid(domain, 9, [](Uv uv) { return isotropic(1 + uv.u); }), {});
  for (const double v : {-1.0 / 3, 0.1, 1.9, 2.0}) {
    const double outside = 0.7 * (1 + 1e-15);
    expect_near(query(control, {outside, v}), query(control, {0.7, v}), 1e-9);
  }
  expect_near(query(control, {0.1 - 1e-16, 2 + 1e-15}), query(control, {0.1, 2}), 1e-9);
}

TEST(Query, OfAPointFarOutsideEnds) {
  const ControlMesh control = random_space(1000);
  for (const Uv uv : {Uv{-5, 0.5}, Uv{0.5, 1e9}, Uv{1e12, 1e12}, Uv{-1e100, 1}}) {
    const SizeTensor size = query(control, uv);
    EXPECT_GT(size.h11, 0);
    EXPECT_LT(size.h11, 1);
  }
}

TEST(Query, CountsTheStepsOfItsWalks) {
  const ControlMesh control({}, grid({}, 101, [](Uv) { return isotropic(0.1); }), {});
  QueryHint hint;
  control.size(place({0.5052, 0.5051}), hint);
  const std::size_t first = hint.answers.steps;
  control.size(place({0.5252, 0.5051}), hint);  // two squares on: four triangles
  EXPECT_EQ(hint.answers.walks, 2U);
  EXPECT_GE(hint.answers.steps - first, 3U);
  EXPECT_LE(hint.answers.steps - first, 5U);
  control.size(place({0.1, 0.1}), hint);  // far away: from the grid of start triangles
  EXPECT_LE(hint.answers.steps - first, 8U);
}

TEST(ControlMesh, KnowsTheFirstFormsOfItsNodes) {
  std::vector<ControlNode> nodes = testing::random_nodes(300);
  for (ControlNode& n : nodes) n.form = {1 + n.uv.u, n.uv.v, 2};
  const ControlMesh control({}, nodes, {.interpolation = Interpolation::Circles});
  for (const VertexHandle vh : control.mesh().vertices()) {
    const Uv uv = uv_at(control, vh);
    const FirstFormFactor form = control.form(vh.idx());
    EXPECT_EQ(form.l11, 1 + uv.u);
    EXPECT_EQ(form.l21, uv.v);
    EXPECT_EQ(form.l22, 2);
  }
}

TEST(Query, IsTheSameAtAnyScaleOfTheParameters) {
  constexpr double u_scale = 1e6, v_scale = 1e-3;
  const auto field = [](Uv uv) { return isotropic(0.1 + 0.05 * std::sin(5 * uv.u + uv.v)); };
  const ControlMesh plain({}, grid({}, 17, field), {.grade = 1.2});
  std::vector<ControlNode> nodes = grid({}, 17, field);
  for (ControlNode& n : nodes) {
    n.uv = {u_scale * n.uv.u, v_scale * n.uv.v};
    n.form = {1 / u_scale, 0, 1 / v_scale};
  }
  const ControlMesh stretched({0, u_scale, 0, v_scale}, nodes, {.grade = 1.2});
  ASSERT_EQ(stretched.mesh().n_vertices(), plain.mesh().n_vertices());
  for (const Uv uv : random_points({}, 1000)) {
    // Squares may be cut along either diagonal.
    const Uv far{u_scale * uv.u, v_scale * uv.v};
    expect_near(query(stretched, far, {1 / u_scale, 0, 1 / v_scale}), query(plain, uv), 0.05);
  }
}

TEST(Query, AtAPoleTakesANodeOfThePole) {
  const auto rows = [](Uv uv) { return isotropic(uv.v == 1 ? 0.1 : 0.5); };
  const ControlMesh control({}, grid({}, 5, rows), {});
  EXPECT_EQ(query(control, {0.4, 1}, {0, 1, 0}), isotropic(0.1));
}

TEST(ControlMesh, RefusesANodeOutsideTheDomainByItsPlace) {
  const Domain domain{};
  const auto nodes = with_corners(domain, isotropic(1), {node({0.5, 1.25}, isotropic(1))});
  const std::string error = error_of([&] { ControlMesh(domain, nodes, {}); });
  EXPECT_EQ(error.rfind(name(ErrorCode::InvalidInput), 0), 0U) << error;
  EXPECT_NE(error.find("(0.5, 1.25)"), std::string::npos) << error;
}

TEST(ControlMesh, TakesNodesInAnyOrder) {
  auto nodes = grid({}, 9, [](Uv uv) { return isotropic(0.05 + 0.1 * uv.u * uv.v); });
  const ControlMesh control({}, nodes, {.grade = 1.5});
  std::reverse(nodes.begin(), nodes.end());
  const ControlMesh reversed({}, nodes, {.grade = 1.5});
  for (const VertexHandle vh : control.mesh().vertices()) {
    const Uv uv = uv_at(control, vh);
    expect_near(query(reversed, uv), query(control, uv), 0.01);
  }
}

}  // namespace
}  // namespace surfmesh
