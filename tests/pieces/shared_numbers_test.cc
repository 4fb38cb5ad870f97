// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/shared_numbers.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "pieces/tiled_cases.hh"
#include "surfmesh/pieces/partition.hh"

namespace surfmesh {
namespace {

using testing::MeshedTiles;
using testing::TiledCase;

using Face = std::vector<std::int64_t>;

/// The faces of a mesh, without copies of vertices.
std::vector<Face> faces_of(const PolyMesh& mesh) {
  const SharedVertices vertices(mesh);
  std::vector<Face> faces;
  for (const FaceHandle fh : mesh.faces()) {
    Face& face = faces.emplace_back();
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      face.push_back(vertices.number(mesh.to_vertex_handle(heh).idx()));
    }
  }
  return faces;
}

/// The faces of parts by the ids of their vertices: own ones follow the shared ones, by tile.
std::vector<Face> faces_of(const std::vector<TilePart>& parts, const SharedNumbers& shared) {
  std::vector<Face> faces;
  std::int64_t first_own = shared.count();
  for (const TilePart& part : parts) {
    const auto count = static_cast<int>(part.shared.size());
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      Face& face = faces.emplace_back();
      for (const int v : part.faces[f]) {
        face.push_back(v < count ? shared.id(part.shared[static_cast<std::size_t>(v)])
                                 : first_own + v - count);
      }
    }
    first_own += static_cast<std::int64_t>(part.own_count());
  }
  return faces;
}

/// Pieces of two tiles and more.
std::vector<int> dealt(const MeshedTiles& meshed, int pieces) {
  return deal_in_runs(std::vector<double>(meshed.tiles.size(), 1), pieces);
}

/// The ranks of pieces that one makes.
std::vector<int> one_rank(int pieces) {
  return std::vector<int>(static_cast<std::size_t>(pieces), 0);
}

/// By piece, the numbers of the vertices that it shares with another piece.
using Common = std::map<int, std::vector<int>>;

std::vector<Common> common_of(const std::vector<std::set<int>>& numbers) {
  std::vector<Common> result(numbers.size());
  for (std::size_t a = 0; a < numbers.size(); ++a) {
    for (std::size_t b = 0; b < numbers.size(); ++b) {
      std::vector<int> both;
      std::set_intersection(numbers[a].begin(), numbers[a].end(), numbers[b].begin(),
                            numbers[b].end(), std::back_inserter(both));
      if (a != b && !both.empty()) result[a][static_cast<int>(b)] = both;
    }
  }
  return result;
}

class SharedNumbersOf : public ::testing::TestWithParam<TiledCase> {
 protected:
  MeshedTiles meshed_{GetParam()};
};

TEST_P(SharedNumbersOf, TilesCountTheIds) {
  const SharedNumbers shared = meshed_.shared();
  std::set<std::int64_t> ids;
  for (int number = 0; number < meshed_.number_count(); ++number) {
    if (shared.id(number) >= 0) ids.insert(shared.id(number));
  }
  ASSERT_FALSE(ids.empty());
  EXPECT_EQ(static_cast<std::int64_t>(ids.size()), shared.count());
  EXPECT_EQ(*ids.begin(), 0);
  EXPECT_EQ(*ids.rbegin(), shared.count() - 1);
}

TEST_P(SharedNumbersOf, TilesHaveThePointsOfContoursThatTheResultHas) {
  const SharedNumbers shared = meshed_.shared();
  const PolyMesh mesh = meshed_.assembled();
  const SharedVertices vertices(mesh);
  std::map<std::int64_t, Vec3> points;
  for (const VertexHandle vh : mesh.vertices()) {
    points[vertices.number(vh.idx())] = to_eigen(mesh.point(vh));
  }
  for (int number = 0; number < meshed_.number_count(); ++number) {
    EXPECT_EQ(shared.is_on_contour(number), number < meshed_.tiled.numbers.contour_count());
    if (shared.id(number) < 0 || !shared.is_on_contour(number)) continue;
    EXPECT_EQ(shared.point(number), points.at(shared.id(number)));
  }
}

TEST_P(SharedNumbersOf, PiecesListTheirNeighboursAlike) {
  const int pieces = std::min(4, static_cast<int>(meshed_.tiles.size()));
  const std::vector<int> piece_of = dealt(meshed_, pieces);
  const SharedNumbers shared = meshed_.shared(piece_of, one_rank(pieces));
  std::vector<std::set<int>> numbers(static_cast<std::size_t>(pieces));
  const std::vector<TilePart> parts = meshed_.parts();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    numbers[static_cast<std::size_t>(piece_of[t])].insert(parts[t].shared.begin(),
                                                          parts[t].shared.end());
  }
  const std::vector<Common> expected = common_of(numbers);
  for (int piece = 0; piece < pieces; ++piece) {
    Common found;
    for (const SharedWithPiece& neighbour : shared.neighbours(piece)) {
      EXPECT_TRUE(found.empty() || found.rbegin()->first < neighbour.piece);
      found[neighbour.piece] = neighbour.vertices;
    }
    EXPECT_EQ(found, expected[static_cast<std::size_t>(piece)]);
  }
}

TEST_P(SharedNumbersOf, PiecesListSharedVerticesByTheirIds) {
  const int pieces = std::min(3, static_cast<int>(meshed_.tiles.size()));
  const SharedNumbers shared = meshed_.shared(dealt(meshed_, pieces), one_rank(pieces));
  for (int piece = 0; piece < pieces; ++piece) {
    for (const SharedWithPiece& neighbour : shared.neighbours(piece)) {
      std::vector<std::int64_t> ids;
      for (const int number : neighbour.vertices) ids.push_back(shared.id(number));
      EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
      EXPECT_GE(ids.front(), 0);
    }
  }
}

TEST_P(SharedNumbersOf, PiecesTellHowManySeveralHave) {
  const int pieces = std::min(4, static_cast<int>(meshed_.tiles.size()));
  const std::vector<int> ranks(static_cast<std::size_t>(pieces), 0);
  for (int last = 1; last <= pieces; ++last) {
    std::vector<int> rank_of_piece = ranks;
    std::fill(rank_of_piece.begin() + last, rank_of_piece.end(), 1);
    const SharedNumbers shared = meshed_.shared(dealt(meshed_, pieces), rank_of_piece);
    std::set<int> of_pieces, of_ranks;
    for (int piece = 0; piece < pieces; ++piece) {
      for (const SharedWithPiece& neighbour : shared.neighbours(piece)) {
        of_pieces.insert(neighbour.vertices.begin(), neighbour.vertices.end());
        if ((piece < last) == (neighbour.piece < last)) continue;
        of_ranks.insert(neighbour.vertices.begin(), neighbour.vertices.end());
      }
    }
    EXPECT_EQ(shared.of_several_pieces(), of_pieces.size());
    EXPECT_EQ(shared.of_several_ranks(), of_ranks.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Tiles, SharedNumbersOf, ::testing::ValuesIn(testing::tiled_cases()),
                         [](const auto& test) { return test.param.name; });

class IdsOf : public ::testing::TestWithParam<TiledCase> {};

TEST_P(IdsOf, TilesAreThoseOfTheResult) {
  const MeshedTiles meshed(GetParam());
  EXPECT_TRUE(faces_of(meshed.parts(), meshed.shared()) == faces_of(meshed.assembled()));
}

INSTANTIATE_TEST_SUITE_P(Tiles, IdsOf, ::testing::ValuesIn(testing::orientable_cases()),
                         [](const auto& test) { return test.param.name; });

/// With a vertex that is on no contour.
Model square_with_a_point() {
  Model model = testing::unit_square();
  model.vertices.push_back({Vec3(7, 7, 7)});
  return model;
}

TEST(SharedNumbers, LeaveOutWhatNoTileHas) {
  const MeshedTiles meshed({"Square", square_with_a_point, 0.2});
  const SharedNumbers shared = meshed.shared();
  EXPECT_EQ(shared.id(4), -1);
  EXPECT_EQ(shared.id(5), 4);
  EXPECT_EQ(shared.count(), meshed.number_count() - 1);
}

TEST(SharedNumbers, KnowPiecesWithoutTiles) {
  const MeshedTiles meshed({"Squares", testing::opposite_squares, 0.3});
  ASSERT_EQ(meshed.tiles.size(), 2u);
  const SharedNumbers shared = meshed.shared({1, 3}, one_rank(6));
  for (const int piece : {0, 2, 4, 5}) EXPECT_TRUE(shared.neighbours(piece).empty());
  ASSERT_EQ(shared.neighbours(1).size(), 1u);
  ASSERT_EQ(shared.neighbours(3).size(), 1u);
  EXPECT_EQ(shared.neighbours(1)[0].piece, 3);
  EXPECT_EQ(shared.neighbours(3)[0].piece, 1);
  EXPECT_EQ(shared.neighbours(1)[0].vertices, shared.neighbours(3)[0].vertices);
}

}  // namespace
}  // namespace surfmesh
