// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/thin_nodes.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "support/analytic.hh"
#include "surfmesh/control/node_interpolation.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {
namespace {

constexpr double kRounding = 1e-12;

std::vector<ControlNode> grid(int n, const std::function<SizeTensor(Uv)>& size) {
  std::vector<ControlNode> nodes;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Uv uv{double(i) / (n - 1), double(j) / (n - 1)};
      nodes.push_back({uv, Vec3(uv.u, uv.v, 0), {1, 0, 1}, size(uv), {}});
    }
  }
  return nodes;
}

SizeTensor wave(Uv uv) {
  const double size = 0.02 * std::exp(2 * uv.u);
  return size_tensor(size, 2 * size, uv.v);
}

TEST(ThinNodes, KeepsThePrecisionAtAllNodes) {
  const auto nodes = grid(60, wave);
  for (const double precision : {0.4, 0.2, 0.1}) {
    const NodeInterpolation kept(test::kUnitPlane, thin_nodes(test::kUnitPlane, nodes, precision));
    for (const ControlNode& node : nodes) {
      EXPECT_LE(log_conformity(node.size, kept.at({node.uv, node.point, node.form}).size),
                precision);
    }
  }
}

TEST(ThinNodes, KeepsFewOfASmoothField) {
  const auto nodes = grid(60, wave);
  EXPECT_LT(thin_nodes(test::kUnitPlane, nodes, 0.2).size(), nodes.size() / 10);
  EXPECT_LT(thin_nodes(test::kUnitPlane, nodes, 0.1).size(), nodes.size() / 3);
}

TEST(ThinNodes, KeepsCornersOfAConstantField) {
  const auto kept = thin_nodes(test::kUnitPlane, grid(20, [](Uv) { return isotropic(0.1); }), 0.1);
  EXPECT_EQ(kept.size(), 4u);
}

TEST(ThinNodes, KeepsANodeThatStandsOut) {
  auto nodes = grid(11, [](Uv) { return isotropic(0.2); });
  nodes[60].size = isotropic(0.02);
  std::set<std::pair<double, double>> places;
  for (const ControlNode& node : thin_nodes(test::kUnitPlane, nodes, 0.1)) {
    places.insert({node.uv.u, node.uv.v});
  }
  EXPECT_TRUE(places.contains({0.5, 0.5}));
}

TEST(ThinNodes, EndsWithNodesOnTopOfEachOther) {
  auto nodes = grid(5, [](Uv) { return isotropic(0.2); });
  nodes.push_back(nodes[7]);
  nodes.back().size = isotropic(0.05);
  std::vector<ControlNode> there;
  for (const ControlNode& node : thin_nodes(test::kUnitPlane, nodes, 0.01)) {
    if (node.uv == nodes[7].uv) there.push_back(node);
  }
  ASSERT_EQ(there.size(), 1u);
  EXPECT_LT(log_conformity(there[0].size, isotropic(0.05)), kRounding);
}

TEST(ThinNodes, KeepNothingOfNothing) {
  EXPECT_TRUE(thin_nodes(test::kUnitPlane, {}, 0.1).empty());
}

/// A plane that counts how often it is asked, which is four times a round.
class CountingPlane : public Surface {
 public:
  Domain domain() const override { return test::kUnitPlane.domain(); }
  Jet evaluate(Uv uv, Order order) const override {
    ++evaluations;
    return test::kUnitPlane.evaluate(uv, order);
  }
  mutable int evaluations = 0;
};

double noise(std::size_t i) { return 0.5 + 0.5 * std::sin(12.9898 * double(i) * double(i % 1013)); }

TEST(ThinNodes, TakesFewRoundsForManyNodesAtOnePlace) {
  auto nodes = grid(5, [](Uv) { return isotropic(0.2); });
  const ControlNode inside = {{0.4, 0.3}, Vec3(0.4, 0.3, 0), {1, 0, 1}, isotropic(1), {}};
  for (std::size_t i = 0; i < 20000; ++i) {
    nodes.push_back(inside);
    nodes.back().size = isotropic(0.01 + noise(i));
  }
  nodes.back().size = isotropic(0.01);
  const CountingPlane plane;
  const auto kept = thin_nodes(plane, nodes, 0.1);
  EXPECT_LE(kept.size(), 26u);
  EXPECT_LE(plane.evaluations, 4 * 10);
  const auto size =
      NodeInterpolation(test::kUnitPlane, kept).at({inside.uv, inside.point, inside.form}).size;
  EXPECT_LE(log_conformity(size, isotropic(0.01)), 0.1);
}

TEST(ThinNodes, TakesFewRoundsForNodesThatAreNearlyAtOnePlace) {
  auto nodes = grid(5, [](Uv) { return isotropic(0.2); });
  for (std::size_t i = 0; i < 2000; ++i) {
    const Uv uv{0.4 + 1e-7 * double(i), 0.3};
    nodes.push_back({uv, Vec3(uv.u, uv.v, 0), {1, 0, 1}, isotropic(0.05 + noise(i)), {}});
  }
  const CountingPlane plane;
  EXPECT_LE(thin_nodes(plane, nodes, 0.1).size(), nodes.size());
  EXPECT_LE(plane.evaluations, 4 * 30);
}

TEST(ThinNodes, KeepsThePrecisionOfNoiseInFewRounds) {
  const int n = 100;  // a hundredth apart, so that sizes below a tenth are not merged
  auto nodes = grid(n, wave);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].size = isotropic(0.02 + 0.05 * noise(i));
  const CountingPlane plane;
  const NodeInterpolation kept(test::kUnitPlane, thin_nodes(plane, nodes, 0.1));
  EXPECT_LE(plane.evaluations, 4 * 30);
  for (const ControlNode& node : nodes) {
    EXPECT_LE(log_conformity(node.size, kept.at({node.uv, node.point, node.form}).size), 0.1);
  }
}

}  // namespace
}  // namespace surfmesh
