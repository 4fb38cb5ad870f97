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
