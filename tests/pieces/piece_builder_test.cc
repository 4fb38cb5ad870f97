// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/piece_builder.hh"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "pieces/tiled_cases.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// A square of two triangles over [u, u+1] × [0, 1], whose corners at u and u + 1 are shared, and
/// which has a vertex of its own in the middle.
TilePart square(int u, const std::array<int, 4>& shared) {
  TilePart part;
  part.patch = u;
  part.shared = {shared.begin(), shared.end()};
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}, {1.0, 1.0}, {0.5, 0.5}}) {
    part.points.emplace_back(u + x, y, 0);
  }
  part.faces.add(std::array{0, 2, 4});
  part.faces.add(std::array{2, 3, 4});
  part.faces.add(std::array{3, 1, 4});
  part.faces.add(std::array{1, 0, 4});
  return part;
}

TEST(PieceBuilder, JoinsSharedVertices) {
  PieceBuilder builder;
  builder.add(0, square(0, {10, 11, 20, 21}));
  builder.add(1, square(1, {20, 21, 30, 31}));
  const MeshPiece& piece = builder.piece();
  EXPECT_EQ(piece.points.size(), 6u + 2u);
  EXPECT_EQ(piece.faces.size(), 8u);
  EXPECT_EQ(builder.numbers().shared, (std::vector<int>{10, 11, 20, 21, 30, 31}));
  EXPECT_EQ(piece.patches, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(PieceBuilder, KeepsThePlacesOfCorners) {
  const std::vector<TilePart> parts = {square(0, {10, 11, 20, 21}), square(1, {20, 21, 30, 31}),
                                       square(2, {30, 31, 40, 41})};
  PieceBuilder builder;
  for (std::size_t t = 0; t < parts.size(); ++t) builder.add(t, parts[t]);
  const MeshPiece& piece = builder.piece();
  std::size_t face = 0;
  for (const TilePart& part : parts) {
    for (std::size_t f = 0; f < part.faces.size(); ++f, ++face) {
      ASSERT_EQ(piece.faces[face].size(), part.faces[f].size());
      for (std::size_t k = 0; k < part.faces[f].size(); ++k) {
        EXPECT_EQ(piece.points[static_cast<std::size_t>(piece.faces[face][k])],
                  part.points[static_cast<std::size_t>(part.faces[f][k])]);
      }
    }
  }
}

TEST(PieceBuilder, TellsWhereTheOwnVerticesOfTilesAre) {
  PieceBuilder builder;
  builder.add(7, square(0, {10, 11, 20, 21}));
  builder.add(9, square(1, {20, 21, 30, 31}));
  const PieceNumbers& numbers = builder.numbers();
  ASSERT_EQ(numbers.runs.size(), 2u);
  EXPECT_EQ(numbers.runs[0].tile, 7u);
  EXPECT_EQ(numbers.runs[1].tile, 9u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(numbers.runs[i].count, 1);
    EXPECT_EQ(builder.piece().points[static_cast<std::size_t>(numbers.runs[i].first_vertex)],
              Vec3(0.5 + static_cast<double>(i), 0.5, 0));
  }
}

TEST(PieceBuilder, KeepsPartsThatShareNothingApart) {
  PieceBuilder builder;
  builder.add(0, square(0, {10, 11, 20, 21}));
  builder.add(1, square(5, {50, 51, 60, 61}));
  EXPECT_EQ(builder.piece().points.size(), 10u);
}

TEST(PieceBuilder, HasNothingAtFirst) {
  PieceBuilder builder;
  EXPECT_TRUE(builder.piece().points.empty());
  EXPECT_TRUE(builder.piece().faces.empty());
  EXPECT_TRUE(builder.numbers().runs.empty());
}

TEST(PieceBuilder, RefusesMoreThanArraysCanCount) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  EXPECT_NO_THROW(check_counts_of_piece(most, most));
  for (const auto& [vertices, corners] : {std::pair{most + 1, most}, {std::size_t{3}, most + 1}}) {
    try {
      check_counts_of_piece(vertices, corners);
      FAIL() << vertices << ", " << corners;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Limit);
      EXPECT_NE(std::string(error.what()).find("--piece-count"), std::string::npos);
    }
  }
}

class PieceOfAll : public ::testing::TestWithParam<testing::TiledCase> {};

TEST_P(PieceOfAll, HasTheVerticesAndFacesOfTheResult) {
  const testing::MeshedTiles meshed(GetParam());
  PieceBuilder builder;
  std::size_t tile = 0;
  for (TilePart& part : meshed.parts()) builder.add(tile++, std::move(part));
  const PolyMesh mesh = meshed.assembled();
  EXPECT_EQ(builder.piece().points.size(), SharedVertices(mesh).count());
  EXPECT_EQ(builder.piece().faces.size(), mesh.n_faces());
  EXPECT_EQ(builder.piece().patches.size(), mesh.n_faces());
}

INSTANTIATE_TEST_SUITE_P(Tiles, PieceOfAll, ::testing::ValuesIn(testing::orientable_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(PieceOfAMobiusBand, IsJoinedWhereAHalfEdgeMeshIsCut) {
  for (const double most : {0.0, 100.0}) {
    const testing::MeshedTiles meshed({"Band", testing::mobius_band, 0.1, most});
    PieceBuilder builder;
    std::size_t tile = 0;
    for (TilePart& part : meshed.parts()) builder.add(tile++, std::move(part));
    const int seam = testing::contour_index(meshed.tiled.model, "p0:u1");
    const auto segments = meshed.tiled.nodes[static_cast<std::size_t>(seam)].segment_count();
    EXPECT_EQ(builder.piece().points.size() + static_cast<std::size_t>(segments) + 1,
              meshed.assembled().n_vertices());
  }
}

}  // namespace
}  // namespace surfmesh
