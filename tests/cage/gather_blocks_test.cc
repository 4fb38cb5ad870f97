// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/gather_blocks.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cage/cages.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

using testing::refined;

/// The blocks of a Catmull-Clark cage of quads; faces of different sets do not join.
std::vector<Block> blocks_of(const Cage& cage, std::vector<int> sets = {}) {
  sets.resize(cage.faces.size(), 0);
  const CageTopology topology = make_topology(cage, Scheme::CatmullClark);
  return gather_blocks(*topology.refiner, sets, cage.points);
}

std::vector<std::string> sizes_of(const std::vector<Block>& blocks) {
  std::vector<std::string> sizes;
  for (const Block& block : blocks) {
    const auto [low, high] = std::minmax(block.columns, block.rows);
    sizes.push_back(std::to_string(high) + "x" + std::to_string(low));
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

using Sizes = std::vector<std::string>;

/// Vertex of the cage at a corner of the place of a face, counter-clockwise from the lower left.
int vertex_at(const Cage& cage, const BlockFace& f, int corner) {
  return cage
      .faces[static_cast<std::size_t>(f.face)][static_cast<std::size_t>((f.rotation + corner) % 4)];
}

const BlockFace& face_at(const Block& block, int column, int row) {
  return block.faces[static_cast<std::size_t>(row * block.columns + column)];
}

/// Laws of all blocks: each face is in one, and faces fit together side by side.
void expect_valid(const Cage& cage, const std::vector<Block>& blocks) {
  std::vector<int> count(cage.faces.size(), 0);
  for (const Block& block : blocks) {
    ASSERT_EQ(static_cast<int>(block.faces.size()), block.columns * block.rows);
    for (const BlockFace& f : block.faces) ++count[static_cast<std::size_t>(f.face)];
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        const BlockFace& f = face_at(block, column, row);
        if (column > 0) {
          const BlockFace& left = face_at(block, column - 1, row);
          EXPECT_EQ(vertex_at(cage, f, 0), vertex_at(cage, left, 1));
          EXPECT_EQ(vertex_at(cage, f, 3), vertex_at(cage, left, 2));
        }
        if (row == 0) continue;
        const BlockFace& below = face_at(block, column, row - 1);
        EXPECT_EQ(vertex_at(cage, f, 0), vertex_at(cage, below, 3));
        EXPECT_EQ(vertex_at(cage, f, 1), vertex_at(cage, below, 2));
      }
    }
  }
  EXPECT_EQ(count, std::vector<int>(cage.faces.size(), 1));
}

/// How many faces have a vertex.
int valence(const Cage& cage, int vertex) {
  return static_cast<int>(
      std::count_if(cage.faces.begin(), cage.faces.end(), [vertex](const auto& face) {
        return std::find(face.begin(), face.end(), vertex) != face.end();
      }));
}

TEST(GatherBlocks, PutsEachFaceInOneBlock) {
  Cage creased = testing::torus(7, 5);
  creased.creases = {{{0, 1}, 10}, {{8, 15}, 2}, {{15, 16}, 2}};
  creased.corners = {{24, 3}};
  for (const Cage& cage :
       {testing::cube(), testing::torus(), testing::sheet(4, 7), testing::pillow(), testing::fan(),
        testing::quad_fan(5), refined(testing::cube(), 3), refined(testing::quad_fan(6), 2),
        refined(testing::pentagon_prism(), 2), refined(testing::fan(), 1), creased}) {
    expect_valid(cage, blocks_of(cage));
  }
}

TEST(GatherBlocks, HasRegularVerticesInside) {
  const Cage cage = refined(testing::pentagon_prism(), 2);
  for (const Block& block : blocks_of(cage)) {
    for (int row = 1; row < block.rows; ++row) {
      for (int column = 1; column < block.columns; ++column) {
        EXPECT_EQ(valence(cage, vertex_at(cage, face_at(block, column, row), 0)), 4);
      }
    }
  }
}

TEST(GatherBlocks, TakesARegularSheetWhole) {
  EXPECT_EQ(sizes_of(blocks_of(testing::sheet(9, 4))), Sizes{"9x4"});
}

TEST(GatherBlocks, TakesWholeRingsAndTori) {
  EXPECT_EQ(sizes_of(blocks_of(testing::torus(9, 4))), Sizes{"9x4"});
  Cage ring = testing::torus(9, 4);
  ring.holes = {0};
  std::vector<int> sets(ring.faces.size(), 0);
  std::fill(sets.begin(), sets.begin() + 9, -1);
  EXPECT_EQ(sizes_of(blocks_of(ring, sets)), Sizes{"9x3"});
}

TEST(GatherBlocks, TakesTheLargestRectangleFirst) {
  Cage cage = testing::sheet(4, 3);
  cage.faces.erase(cage.faces.begin() + 11);
  EXPECT_EQ(sizes_of(blocks_of(cage)), (Sizes{"2x1", "3x3"}));
}

TEST(GatherBlocks, GathersFourSidesOfACube) {
  EXPECT_EQ(sizes_of(blocks_of(refined(testing::cube(), 2))), (Sizes{"16x4", "4x4", "4x4"}));
}

TEST(GatherBlocks, EndsAtCreasesOfAnySharpness) {
  for (const double sharpness : {10.0, 0.5}) {
    Cage cage = testing::sheet(4, 2);
    cage.creases = {{{2, 7}, sharpness}, {{7, 12}, sharpness}};
    EXPECT_EQ(sizes_of(blocks_of(cage)), (Sizes{"2x2", "2x2"})) << sharpness;
  }
}

TEST(GatherBlocks, EndsBesideSemiSharpCreasesByChaikinsRule) {
  Cage cage = testing::sheet(4, 2);
  cage.creases = {{{2, 7}, 2}, {{7, 12}, 2}};
  cage.is_chaikin = true;
  EXPECT_EQ(sizes_of(blocks_of(cage)), (Sizes{"2x1", "2x1", "2x1", "2x1"}));
}

TEST(GatherBlocks, HasNoSharpVertexInside) {
  Cage cage = testing::sheet(2, 2);
  cage.corners = {{4, 2}};
  EXPECT_EQ(sizes_of(blocks_of(cage)), (Sizes{"2x1", "2x1"}));
}

TEST(GatherBlocks, MayHaveAnExtraordinaryVertexInTheMiddleOfASide) {
  const Cage cage = testing::quad_fan(6);
  EXPECT_EQ(sizes_of(blocks_of(cage)), (Sizes{"2x1", "2x1", "2x1"}));
}

TEST(GatherBlocks, HasNoHairpinAtAVertexOfManyFaces) {
  EXPECT_EQ(blocks_of(testing::quad_fan(8)).size(), 4u);
  EXPECT_EQ(blocks_of(testing::quad_fan(9)).size(), 9u);
  Cage half = testing::quad_fan(12);
  half.faces.resize(4);
  EXPECT_EQ(blocks_of(half).size(), 2u);
  half = testing::quad_fan(12);
  half.faces.resize(5);
  EXPECT_EQ(blocks_of(half).size(), 5u);
}

TEST(GatherBlocks, HasNoHairpinAroundAFanOfNarrowFaces) {
  // The sides of the refined faces zigzag around the parts at vertex 0: those beside each other do
  // not join, only half of them with such a part.
  const auto blocks_of_fan = [](int n) {
    Cage cage;
    cage.points = {{0, 0, 1}};
    for (int i = 0; i < n; ++i) {
      cage.points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0);
      cage.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    return blocks_of(refined(cage, 1)).size();
  };
  EXPECT_EQ(blocks_of_fan(12), 13u);
  EXPECT_EQ(blocks_of_fan(100), 200u);
}

TEST(GatherBlocks, LeavesOutFacesOfNoSet) {
  EXPECT_EQ(sizes_of(blocks_of(testing::sheet(3, 1), {0, -1, 0})), (Sizes{"1x1", "1x1"}));
}

TEST(GatherBlocks, EndsWhereSetsDo) {
  EXPECT_EQ(sizes_of(blocks_of(testing::sheet(4, 1), {0, 0, 1, 1})), (Sizes{"2x1", "2x1"}));
}

TEST(GatherBlocks, EndsAtEdgesOfThreeFaces) { EXPECT_EQ(blocks_of(testing::fan()).size(), 3u); }

TEST(GatherBlocks, EndsWhereNeighboursAreTurned) {
  Cage cage = testing::sheet(2, 1);
  std::reverse(cage.faces[1].begin(), cage.faces[1].end());
  EXPECT_EQ(blocks_of(cage).size(), 2u);
}

TEST(GatherBlocks, KeepsFacesWithASideThatIsAPointAlone) {
  Cage cage = testing::sheet(3, 1);
  cage.faces[1] = {1, 2, 2, 5};
  EXPECT_EQ(blocks_of(cage).size(), 3u);
}

TEST(GatherBlocks, DoesNotDependOnHowFacesAreTurned) {
  Cage cage = testing::sheet(6, 5);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    std::rotate(cage.faces[f].begin(), cage.faces[f].begin() + static_cast<std::ptrdiff_t>(f % 4),
                cage.faces[f].end());
  }
  const std::vector<Block> blocks = blocks_of(cage);
  EXPECT_EQ(sizes_of(blocks), Sizes{"6x5"});
  expect_valid(cage, blocks);
}

TEST(GatherBlocks, StopsWhereAHelixWouldMeetItself) {
  // A torus that is closed with a shift of two faces.
  Cage cage = testing::torus(6, 4);
  for (std::size_t f = 18; f < 24; ++f) {
    const int i = static_cast<int>(f) - 18;
    cage.faces[f] = {18 + i, 18 + (i + 1) % 6, (i + 3) % 6, (i + 2) % 6};
  }
  const std::vector<Block> blocks = blocks_of(cage);
  expect_valid(cage, blocks);
  EXPECT_EQ(sizes_of(blocks), Sizes{"6x4"});
}

TEST(GatherBlocks, KeepsTheOrderOfFirstFaces) {
  const std::vector<Block> blocks = blocks_of(refined(testing::pentagon_prism(), 2));
  for (std::size_t b = 1; b < blocks.size(); ++b) {
    EXPECT_LT(first_face(blocks[b - 1]), first_face(blocks[b]));
  }
}

TEST(SingleFaces, AreBlocksOfTheirOwn) {
  const std::vector<Block> blocks = single_faces({0, -1, 3});
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[1].faces[0].face, 2);
  EXPECT_EQ(blocks[1].columns * blocks[1].rows, 1);
}

}  // namespace
}  // namespace surfmesh
