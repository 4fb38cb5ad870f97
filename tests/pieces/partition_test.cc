// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/partition.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace surfmesh {
namespace {

std::vector<double> random_weights(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(1, 1000);
  std::vector<double> weights;
  for (int i = 0; i < count; ++i) weights.push_back(uniform(random));
  return weights;
}

TEST(DealInRuns, GivesPiecesThatFollowEachOther) {
  for (const int pieces : {1, 2, 7, 40, 200}) {
    const std::vector<int> piece_of = deal_in_runs(random_weights(100, 1), pieces);
    ASSERT_EQ(piece_of.size(), 100u);
    EXPECT_TRUE(std::is_sorted(piece_of.begin(), piece_of.end()));
    EXPECT_GE(piece_of.front(), 0);
    EXPECT_LT(piece_of.back(), pieces);
  }
}

TEST(DealInRuns, GivesPiecesOfAboutEqualWeight) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::vector<double> weights = random_weights(300, seed);
    const double greatest = *std::max_element(weights.begin(), weights.end());
    for (const int pieces : {2, 7, 30}) {
      const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / pieces;
      const std::vector<int> piece_of = deal_in_runs(weights, pieces);
      std::vector<double> of_pieces(static_cast<std::size_t>(pieces), 0);
      for (std::size_t t = 0; t < weights.size(); ++t) {
        of_pieces[static_cast<std::size_t>(piece_of[t])] += weights[t];
      }
      // Each end of a run is at most half a tile away from where it should be.
      for (const double weight : of_pieces) EXPECT_NEAR(weight, mean, greatest);
    }
  }
}

TEST(DealInRuns, DealsEqualTilesEvenly) {
  EXPECT_EQ(deal_in_runs({5, 5, 5, 5, 5, 5}, 3), (std::vector<int>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(deal_in_runs({5, 5, 5}, 3), (std::vector<int>{0, 1, 2}));
}

TEST(DealInRuns, GivesOnePieceAll) {
  EXPECT_EQ(deal_in_runs({1, 2, 3}, 1), (std::vector<int>{0, 0, 0}));
}

TEST(DealInRuns, LeavesTheLastPiecesEmptyIfThereAreMoreThanTiles) {
  EXPECT_EQ(deal_in_runs({3, 3, 3}, 9), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(deal_in_runs({1, 98, 1}, 4), (std::vector<int>{0, 1, 2}));
}

TEST(DealInRuns, GivesAsManyTilesAsPiecesOneEach) {
  EXPECT_EQ(deal_in_runs({1, 1, 98}, 3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(deal_in_runs({90, 1, 1, 1, 7}, 5), (std::vector<int>{0, 1, 2, 3, 4}));
}

double heaviest(const std::vector<double>& weights, const std::vector<int>& piece_of, int pieces) {
  std::vector<double> of_pieces(static_cast<std::size_t>(pieces), 0);
  for (std::size_t t = 0; t < weights.size(); ++t) {
    of_pieces[static_cast<std::size_t>(piece_of[t])] += weights[t];
  }
  return *std::max_element(of_pieces.begin(), of_pieces.end());
}

/// The least weight of the heaviest run, of all ways to deal.
double least_heaviest(const std::vector<double>& weights, std::size_t first, int pieces) {
  double load = 0;
  if (pieces == 1)
    return std::accumulate(weights.begin() + static_cast<int>(first), weights.end(), 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t end = first; end < weights.size(); ++end) {
    load += weights[end];
    least = std::min(least, std::max(load, least_heaviest(weights, end + 1, pieces - 1)));
  }
  return least;
}

TEST(DealInRuns, MakesTheHeaviestPieceAsLightAsItCanBe) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    const std::vector<double> weights = random_weights(12, seed);
    for (const int pieces : {2, 3, 5, 9}) {
      EXPECT_NEAR(heaviest(weights, deal_in_runs(weights, pieces), pieces),
                  least_heaviest(weights, 0, pieces), 1e-9)
          << seed << ", " << pieces;
    }
  }
}

TEST(DealInRuns, LeavesNoPieceEmptyWhereAnotherHasTwo) {
  for (const auto& weights : {std::vector<double>{1, 98, 1, 1}, {98, 1, 1, 1, 1}, {0, 0, 5, 0}}) {
    for (int pieces = 1; pieces <= static_cast<int>(weights.size()); ++pieces) {
      const std::vector<int> piece_of = deal_in_runs(weights, pieces);
      EXPECT_EQ(std::set<int>(piece_of.begin(), piece_of.end()).size(),
                static_cast<std::size_t>(pieces));
    }
  }
}

TEST(DealInRuns, TakesTilesWithoutWeight) {
  EXPECT_EQ(deal_in_runs({0, 0, 0}, 2), (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(deal_in_runs({0, 4, 0, 4, 0}, 2), (std::vector<int>{0, 0, 0, 1, 1}));
}

TEST(DealInRuns, TakesNoTiles) { EXPECT_TRUE(deal_in_runs({}, 3).empty()); }

}  // namespace
}  // namespace surfmesh
