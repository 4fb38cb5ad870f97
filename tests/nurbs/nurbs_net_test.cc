// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_net.hh"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/errors.hh"
#include "support/nurbs_nets.hh"

namespace surfmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A net of 4 x 3 points of degree 2 x 1.
NurbsNet good_net() {
  return testing::wavy_net(2, 1, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 1, 2, 2}, true);
}

/// The place of the fault of a net after a change.
template <class Change>
std::string place_of_fault(Change change) {
  NurbsNet net = good_net();
  change(net);
  const auto fault = find_fault(net);
  return fault ? fault->path : "none";
}

TEST(NurbsNet, HasNoFaultIfCountsFit) {
  EXPECT_FALSE(find_fault(good_net()));
  EXPECT_FALSE(find_fault(testing::sphere_net()));
}

TEST(NurbsNet, NeedsADegreeFromOneToTheMost) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.degree[0] = 0; }), "degree/0");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.degree[1] = kMostDegree + 1; }), "degree/1");
}

TEST(NurbsNet, NeedsKnotsForItsPoints) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[0].pop_back(); }), "knots/0");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[1].push_back(3); }), "knots/1");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.points.pop_back(); }), "knots/1");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.points.resize(1); }), "points");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.points.clear(); }), "points");
}

TEST(NurbsNet, NeedsKnotsThatAscend) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[0][3] = -1; }), "knots/0/3");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[1][2] = kInfinity; }), "knots/1/2");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[1] = {1, 1, 1, 1, 1}; }), "knots/1");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.knots[0] = {0, 1, 2, 2, 2, 3, 4}; }), "knots/0");
}

TEST(NurbsNet, RefusesJumpsInside) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) {
              net = testing::wavy_net(1, 1, {0, 0, 1, 1, 2, 2}, {0, 0, 1, 1});
            }),
            "knots/0/3");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) {
              net = testing::wavy_net(1, 1, {0, 0, 0, 1, 1}, {0, 0, 1, 1});
            }),
            "knots/0/2");
}

TEST(NurbsNet, NeedsRowsOfOneLength) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.points[1].pop_back(); }), "points/1");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.points[2][1].y() = kUnset; }), "points/2/1");
}

TEST(NurbsNet, NeedsAWeightAboveZeroForEachPoint) {
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.weights[1][2] = 0; }), "weights/1/2");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.weights[2][0] = kInfinity; }), "weights/2/0");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.weights[2].pop_back(); }), "weights/2");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.weights.pop_back(); }), "weights");
  EXPECT_EQ(place_of_fault([](NurbsNet& net) { net.weights.clear(); }), "none");
}

TEST(NurbsNet, NeedsOneKnotMoreThanPointsWhereItIsPeriodic) {
  const auto periodic = [](std::vector<double> knots) {
    return [=](NurbsNet& net) {
      net.periodic[0] = true;
      net.knots[0] = knots;
    };
  };
  EXPECT_EQ(place_of_fault(periodic({0, 1, 2, 3, 4})), "none");
  EXPECT_EQ(place_of_fault(periodic({0, 0, 2, 3, 4})), "none");
  EXPECT_EQ(place_of_fault(periodic({0, 1, 2, 3})), "knots/0");
  EXPECT_EQ(place_of_fault(periodic({0, 1, 1, 1, 4})), "knots/0/3");
}

TEST(NurbsNet, IsCheckedWithThePlaceAndTheReason) {
  NurbsNet net = good_net();
  net.knots[0].pop_back();
  EXPECT_EQ(error_of([&] { check(net); }),
            "invalid input: knots/0: 4 points of degree 2 along u need 7 knots (points + degree + "
            "1), here are 6");
}

TEST(NurbsPolygon, HasTheSameRules) {
  const NurbsPolygon good{2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 0}, {1, 1}}, {1, 2, 1}};
  EXPECT_FALSE(find_fault(good));
  NurbsPolygon bad = good;
  bad.weights[1] = -1;
  EXPECT_EQ(find_fault(bad).value().path, "weights/1");
  bad = good;
  bad.knots[4] = 0.5;
  EXPECT_EQ(find_fault(bad).value().path, "knots/4");
  bad = good;
  bad.points[2].v = kUnset;
  EXPECT_EQ(find_fault(bad).value().path, "points/2");
  bad.points.clear();
  EXPECT_EQ(find_fault(bad).value().path, "points");
}

}  // namespace
}  // namespace surfmesh
