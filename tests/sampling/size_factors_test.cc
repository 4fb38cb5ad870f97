// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/size_factors.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/control_nodes.hh"
#include "surfmesh/control/control_cells.hh"

namespace surfmesh {
namespace {

/// Four cells of the unit square, one of them halved often at its corner.
class Factors : public ::testing::Test {
 protected:
  Factors() : cells_({}, {2, 2}, [](Uv uv) { return testing::node(uv, isotropic(0.1)); }, {}, {}) {
    for (int i = 0; i < 6; ++i) cells_.halve(cells_.tree().find({0.01, 0.01}), i % 2 == 0);
  }

  double at(const SizeFactors& factors, Uv uv) const {
    int near = -1;
    return factors.at(uv, near);
  }

  ControlCells cells_;
};

TEST_F(Factors, AreOneAtFirst) { EXPECT_EQ(at(SizeFactors(cells_), {0.3, 0.6}), 1); }

TEST_F(Factors, SpreadWhatIsWantedInOnePlace) {
  SizeFactors factors(cells_);
  factors.multiply({{{0.9, 0.9}, std::log(2)}});
  for (const Uv uv : {Uv{0.9, 0.9}, Uv{0.01, 0.01}, Uv{0.1, 0.8}}) {
    EXPECT_NEAR(at(factors, uv), 2, 1e-12);
  }
}

TEST_F(Factors, MultiplyEachOther) {
  SizeFactors factors(cells_);
  for (int i = 0; i < 2; ++i) factors.multiply({{{0.9, 0.9}, std::log(0.7)}});
  EXPECT_NEAR(at(factors, {0.5, 0.5}), 0.49, 1e-12);
}

TEST_F(Factors, AreMeansAroundANode) {
  SizeFactors factors(cells_);
  factors.multiply({{{0.5, 0.5}, std::log(4)}, {{0.5, 0.5}, 0.0}});
  EXPECT_NEAR(at(factors, {0.5, 0.5}), 2, 1e-12);
}

TEST_F(Factors, AreLoweredInOnePlaceOnly) {
  SizeFactors factors(cells_);
  factors.lower({{{0.99, 0.99}, std::log(0.5)}, {{0.99, 0.99}, std::log(0.9)}}, 1);
  EXPECT_NEAR(at(factors, {1, 1}), 0.5, 1e-12);
  EXPECT_EQ(at(factors, {0.2, 0.2}), 1);
}

TEST_F(Factors, TellWhetherTheyHaveChanged) {
  SizeFactors factors(cells_);
  factors.multiply({});
  factors.lower({}, 1);
  EXPECT_EQ(factors.changes(), 0);
  factors.multiply({{{0.5, 0.5}, std::log(2)}});
  EXPECT_EQ(factors.changes(), 1);
  factors.lower({{{0.5, 0.5}, std::log(0.5)}}, 1);
  EXPECT_EQ(factors.changes(), 2);
}

TEST_F(Factors, ChangeCopiesOfCellsAndWhatTheyGetLater) {
  const auto copy =
      cells_.changed_copy([](const ControlNode& node) { return scaled(node.size, 1 + node.uv.u); });
  int near = -1;
  EXPECT_NEAR(copy->lattice_size({1, 0.3}, near).h11, 0.2, 1e-12);
  EXPECT_FALSE(copy->divide_cell({0.7, 0.7}, {1e6, 0, 1e6}, 2).empty());
  for (int node = 0; node < copy->node_count(); ++node) {
    EXPECT_NEAR(copy->size(node).h11, 0.1 * (1 + copy->uv(node).u), 1e-12);
  }
  EXPECT_NEAR(cells_.size(0).h11, 0.1, 1e-12);
}

// A flat surface asked for larger sizes than there may be, and could not be made finer.
TEST_F(Factors, AreLoweredFromTheGreatestSize) {
  SizeFactors factors(cells_);
  factors.multiply({{{0.5, 0.5}, std::log(8)}});
  factors.lower({{{0.75, 0.75}, std::log(0.5)}}, 0.2);
  EXPECT_NEAR(at(factors, {0.75, 0.75}), 1, 1e-12);
}

}  // namespace
}  // namespace surfmesh
