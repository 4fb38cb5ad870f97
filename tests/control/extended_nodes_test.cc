// SPDX-License-Identifier: BSD-3-Clause
// Nodes (P,M,r) and (P,M,r,M',r'), section 3.1 of the paper.
#include <gtest/gtest.h>

#include <cmath>

#include "support/control_nodes.hh"
#include "surfmesh/control/control_grid.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/interpolate.hh"
#include "surfmesh/metric/minimum.hh"

namespace surfmesh {
namespace {

using testing::expect_near;
using testing::query;

constexpr double kRadius = 0.2;
constexpr double kOuterRadius = 0.1;
const SizeTensor kInner = size_tensor(0.05, 0.02, 0.3);
const SizeTensor kOuter = isotropic(0.3);

ControlNode with_disc(Uv uv, const SizeTensor& inner, double radius) {
  ControlNode node = testing::node(uv, inner);
  node.inner = inner;
  node.radius = radius;
  return node;
}

ControlNode with_ring(Uv uv) {
  ControlNode node = with_disc(uv, kInner, kRadius);
  node.size = node.outer = kOuter;
  node.outer_radius = kOuterRadius;
  return node;
}

ControlMesh mesh_around(const std::vector<ControlNode>& nodes,
                        const ControlSpaceOptions& options = {}) {
  return ControlMesh({}, testing::with_corners({}, isotropic(1), nodes), options);
}

TEST(ExtendedNode, HoldsInItsWholeDisc) {
  const ControlMesh control = mesh_around({with_disc({0.5, 0.5}, kInner, kRadius)});
  for (const Uv step : testing::directions(8)) {
    for (const double r : {0.0, 0.1, 0.199}) {
      EXPECT_EQ(query(control, Uv{0.5, 0.5} + r * step), kInner);
      EXPECT_EQ(query(control, Uv{0.5, 0.5} - r * step), kInner);
    }
  }
}

TEST(ExtendedNode, IsInterpolatedOutsideOfItsDisc) {
  const ControlMesh control = mesh_around({with_disc({0.5, 0.5}, kInner, kRadius)});
  const ControlMesh plain = mesh_around({testing::node({0.5, 0.5}, kInner)});
  for (const Uv step : testing::directions(8)) {
    EXPECT_EQ(query(control, Uv{0.5, 0.5} + 0.21 * step), query(plain, Uv{0.5, 0.5} + 0.21 * step));
  }
}

TEST(ExtendedNode, ChangesFromMToMPrimeOverItsRing) {
  const ControlMesh control = mesh_around({with_ring({0.5, 0.5})});
  EXPECT_EQ(query(control, {0.5, 0.6}), kInner);
  expect_near(query(control, {0.5, 0.5 + kRadius + 0.25 * kOuterRadius}),
              lerp(kInner, kOuter, 0.25), 1e-9);
  expect_near(query(control, {0.5, 0.5 + kRadius + kOuterRadius * (1 - 1e-9)}), kOuter, 1e-6);
}

TEST(ExtendedNode, ActsAsMPrimeOutsideOfItsRing) {
  const ControlMesh control = mesh_around({with_ring({0.5, 0.5})});
  const ControlMesh plain = mesh_around({testing::node({0.5, 0.5}, kOuter)});
  EXPECT_EQ(query(control, {0.1, 0.5}), query(plain, {0.1, 0.5}));
}

TEST(ExtendedNode, GivesTheMinimumWhereDiscsOverlap) {
  const SizeTensor along_u = size_tensor(0.2, 0.05, 0), along_v = size_tensor(0.05, 0.2, 0);
  const ControlMesh control = mesh_around(
      {with_disc({0.4, 0.5}, along_u, kRadius), with_disc({0.6, 0.5}, along_v, kRadius)});
  EXPECT_EQ(query(control, {0.5, 0.5}), minimum(along_u, along_v));
  EXPECT_EQ(query(control, {0.3, 0.5}), along_u);
}

TEST(ExtendedNode, IsSeenOnlyFromItsOwnTrianglesInThePaper) {
  // Nodes between the disc's middle and its rim hide it there.
  std::vector<ControlNode> nodes = testing::grid({}, 11, [](Uv) { return isotropic(1); });
  nodes.push_back(with_disc({0.52, 0.53}, kInner, kRadius));
  const ControlMesh discs({}, nodes, {});
  const ControlMesh vertices({}, nodes, {.lookup = DiscLookup::Vertices});
  EXPECT_EQ(query(discs, {0.52, 0.7}), kInner);
  EXPECT_EQ(query(vertices, {0.52, 0.7}), isotropic(1));
  EXPECT_EQ(query(vertices, {0.53, 0.54}), kInner);
}

TEST(ExtendedNode, SeenFromItsTrianglesMeetsSmallerSizesToo) {
  std::vector<ControlNode> nodes = testing::grid({}, 11, [](Uv) { return isotropic(0.03); });
  nodes.push_back(with_disc({0.52, 0.53}, isotropic(0.2), kRadius));
  const ControlMesh control({}, nodes,
                            {.lookup = DiscLookup::Vertices, .discs_meet_area_sources = true});
  EXPECT_LT(query(control, {0.53, 0.54}).h11, 0.2);
  const ControlMesh alone({}, nodes, {.lookup = DiscLookup::Vertices});
  EXPECT_EQ(query(alone, {0.53, 0.54}), isotropic(0.2));
}

TEST(ExtendedNode, CountsAsAnAnswerOfItsOwn) {
  const ControlMesh control = mesh_around({with_disc({0.5, 0.5}, kInner, kRadius)});
  QueryHint hint;
  control.size(testing::place({0.5, 0.55}), hint);
  control.size(testing::place({0.1, 0.05}), hint);
  EXPECT_EQ(hint.answers.extended, 1U);
  EXPECT_EQ(hint.answers.linear, 1U);
}

TEST(ExtendedNode, MeetsSmallerSizesOfAreaSources) {
  const auto nodes = [] {
    auto list = testing::grid({}, 21, [](Uv uv) { return isotropic(uv.u < 0.5 ? 0.01 : 1); });
    list.push_back(with_disc({0.5, 0.5}, isotropic(0.1), kRadius));
    return list;
  }();
  const ControlMesh control({}, nodes, {.discs_meet_area_sources = true});
  EXPECT_EQ(query(control, {0.4, 0.5}), isotropic(0.01));
  EXPECT_EQ(query(control, {0.6, 0.5}), isotropic(0.1));
}

TEST(ExtendedNode, HoldsOnAGridToo) {
  const auto regular = testing::grid({}, 11, [](Uv) { return isotropic(1); });
  const ControlGrid control({}, regular, {}, {with_disc({0.52, 0.53}, kInner, kRadius)});
  EXPECT_EQ(query(control, {0.52, 0.7}), kInner);
  EXPECT_EQ(query(control, {0.05, 0.05}), isotropic(1));
}

TEST(ExtendedNode, KeepsItsDiscWhereItMeetsAnother) {
  const ControlMesh control = mesh_around(
      {with_disc({0.5, 0.5}, isotropic(0.05), 0.1), with_disc({0.5, 0.5}, isotropic(0.1), 0.2)});
  EXPECT_EQ(query(control, {0.5, 0.55}), isotropic(0.05));
  EXPECT_EQ(query(control, {0.5, 0.65}), isotropic(0.1));
}

}  // namespace
}  // namespace surfmesh
