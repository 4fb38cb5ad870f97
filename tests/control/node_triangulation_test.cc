// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/node_triangulation.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/control_nodes.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

/// Nodes crowded along a curve, as a user gives them.
std::vector<ControlNode> crowded_nodes() {
  std::vector<ControlNode> nodes;
  for (int i = 0; i < 60; ++i) {
    const double s = i / 59.0;
    nodes.push_back(testing::node({0.1 + 0.8 * s, 0.3 + 0.2 * std::sin(5 * s)}, isotropic(0.01)));
  }
  return testing::with_corners({}, isotropic(0.1), nodes);
}

/// The greatest circumradius over shortest edge.
double worst_shape(const NodeTriangulation& triangulation) {
  double worst = 0;
  for (const FaceHandle fh : triangulation.mesh().faces()) {
    const std::array<Uv, 3> t = corners(triangulation.mesh(), fh, triangulation.uv_handle());
    const Metric euclidean{1, 0, 1};
    const double shortest =
        std::min({squared_length(euclidean, t[1] - t[0]), squared_length(euclidean, t[2] - t[1]),
                  squared_length(euclidean, t[0] - t[2])});
    worst = std::max(worst, circumcircle(t, euclidean).squared_radius / shortest);
  }
  return std::sqrt(worst);
}

TEST(NodeTriangulation, MergesNodesInWhateverOrderTheyCome) {
  const ControlNode small = testing::node({0.5, 0.5}, isotropic(0.01));
  const ControlNode large = testing::node({0.55, 0.5}, isotropic(0.9));
  const ControlNode near = testing::node({0.5005, 0.5}, isotropic(0.01));
  const auto count = [](const std::vector<ControlNode>& nodes) {
    return NodeTriangulation({}, testing::with_corners({}, isotropic(1), nodes))
        .mesh()
        .n_vertices();
  };
  // A tenth of the smaller size counts: 0.05 is far apart, 0.0005 is not.
  EXPECT_EQ(count({small, large}), 6U);
  EXPECT_EQ(count({large, small}), 6U);
  EXPECT_EQ(count({small, near}), 5U);
  EXPECT_EQ(count({near, small}), 5U);
}

/// Regular nodes, which know their spacing.
std::vector<ControlNode> regular_nodes(const Domain& domain, int n, const SizeTensor& size) {
  std::vector<ControlNode> nodes = testing::grid(domain, n, [&](Uv) { return size; });
  const double width = (domain.u1 - domain.u0) / (n - 1),
               height = (domain.v1 - domain.v0) / (n - 1);
  for (ControlNode& node : nodes) node.spacing = {1 / (width * width), 0, 1 / (height * height)};
  return nodes;
}

TEST(RegularNodes, AreAllThereHoweverLargeTheSizesAre) {
  const Domain domain{-6, 6, 0, 2};
  const NodeTriangulation triangulation(domain, regular_nodes(domain, 50, isotropic(100)));
  testing::expect_valid(triangulation.mesh());
  EXPECT_EQ(triangulation.mesh().n_vertices(), 2500U);
  EXPECT_EQ(triangulation.mesh().n_faces(), 2U * 49 * 49);
}

TEST(RegularNodes, AreMergedWithNodesOfTheUser) {
  std::vector<ControlNode> nodes = regular_nodes({}, 11, isotropic(1));
  nodes.push_back(testing::node({0.72, 0.7}, isotropic(0.3)));    // beside a regular one
  nodes.push_back(testing::node({0.5, 0.5}, isotropic(0.01)));    // at it
  nodes.push_back(testing::node({0.31, 0.35}, isotropic(0.02)));  // far from all others
  const NodeTriangulation triangulation({}, nodes);
  ASSERT_EQ(triangulation.mesh().n_vertices(), 122U);
  const Domain square;
  for (std::size_t i = 0; i < 121; ++i) {
    const Uv at = triangulation.nodes()[i].uv;
    const double least = at == square.at(0.5, 0.5) ? 0.01 : at == square.at(0.7, 0.7) ? 0.3 : 1;
    EXPECT_EQ(triangulation.nodes()[i].size, isotropic(least)) << i;
  }
  testing::expect_valid(triangulation.mesh());
}

TEST(RegularNodes, NeedNoInnerNodes) {
  NodeTriangulation triangulation({}, regular_nodes({}, 30, isotropic(0.1)));
  EXPECT_TRUE(triangulation.add_inner_nodes().empty());
}

TEST(RegularRows, AreFoundAtTheFrontOnly) {
  const Domain domain{0, 3, 0, 1};
  std::vector<ControlNode> nodes = regular_nodes(domain, 7, isotropic(1));
  EXPECT_EQ(find_regular_rows(domain, nodes).count(), 49U);
  nodes.push_back(testing::node({0.5, 0.5}, isotropic(1)));
  EXPECT_EQ(find_regular_rows(domain, nodes).width, 7U);
  EXPECT_EQ(find_regular_rows(domain, nodes).height, 7U);
  std::vector<ControlNode> others = nodes;
  std::rotate(others.begin(), others.end() - 1, others.end());
  EXPECT_EQ(find_regular_rows(domain, others).count(), 0U);
  for (ControlNode& node : nodes) node.spacing.m12 = 0.1;  // not along the rows
  EXPECT_EQ(find_regular_rows(domain, nodes).count(), 0U);
  for (ControlNode& node : nodes) node.spacing.m12 = 0;
  nodes.resize(48);  // the last row is not whole
  EXPECT_EQ(find_regular_rows(domain, nodes).count(), 0U);
  EXPECT_EQ(find_regular_rows({0, 4, 0, 1}, regular_nodes(domain, 7, isotropic(1))).count(), 0U);
  EXPECT_EQ(find_regular_rows(domain, {}).count(), 0U);
  EXPECT_EQ(find_regular_rows({}, testing::grid({}, 7, [](Uv) { return isotropic(1); })).count(),
            0U);
}

TEST(InnerNodes, LeaveNoBadlyShapedTriangle) {
  NodeTriangulation triangulation({}, crowded_nodes());
  EXPECT_GT(worst_shape(triangulation), 5);
  const std::vector<Uv> added = triangulation.add_inner_nodes();
  testing::expect_valid(triangulation.mesh());
  EXPECT_LE(worst_shape(triangulation), std::sqrt(2.0) * (1 + 1e-12));
  EXPECT_EQ(triangulation.mesh().n_vertices(), 64 + added.size());
  EXPECT_LE(added.size(), 8 * 64U);
}

TEST(InnerNodes, AreNotAddedWhereShapesAreGood) {
  const auto nodes = testing::grid({}, 6, [](Uv) { return isotropic(0.1); });
  NodeTriangulation triangulation({}, nodes);
  EXPECT_TRUE(triangulation.add_inner_nodes().empty());
}

TEST(InnerNodes, DoNotDivideWhatIsNothingBesideTheDomain) {
  std::vector<ControlNode> nodes;
  for (const Uv uv : {Uv{1, 0.5}, {1, 0.5 + 1e-9}, {0.5, 0.5}, {0.5 + 1e-12, 0.5}}) {
    nodes.push_back(testing::node(uv, isotropic(1e-12)));
  }
  NodeTriangulation triangulation({}, testing::with_corners({}, isotropic(1), nodes));
  EXPECT_EQ(triangulation.mesh().n_vertices(), 8u);
  for (const Uv uv : triangulation.add_inner_nodes()) {
    for (const ControlNode& node : nodes) {
      EXPECT_GT(std::abs(uv.u - node.uv.u) + std::abs(uv.v - node.uv.v), 1e-7);
    }
  }
}

TEST(InnerNodes, LieInTheDomain) {
  const Domain domain{-2, 3, 10, 11};
  std::vector<ControlNode> nodes;
  for (const Uv uv : testing::random_points(domain, 100)) {
    nodes.push_back(testing::node({uv.u, 10 + 0.01 * (uv.v - 10)}, isotropic(1e-4)));
  }
  NodeTriangulation triangulation(domain, testing::with_corners(domain, isotropic(1), nodes));
  for (const Uv uv : triangulation.add_inner_nodes()) {
    EXPECT_TRUE(uv.u >= -2 && uv.u <= 3 && uv.v >= 10 && uv.v <= 11) << uv.u << " " << uv.v;
  }
  testing::expect_valid(triangulation.mesh());
}

}  // namespace
}  // namespace surfmesh
