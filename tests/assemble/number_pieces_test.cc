// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/number_pieces.hh"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kMostVertices = (std::size_t{1} << 31) - 1;
constexpr std::size_t kMostEdges = (std::size_t{1} << 30) - 1;

TEST(CountsOfAMesh, MayBeAllThatHandlesCount) {
  EXPECT_NO_THROW(detail::check_counts_of_mesh(kMostVertices, kMostEdges));
}

TEST(CountsOfAMesh, TellOfPiecesIfThereAreMore) {
  for (const auto& [vertices, edges] :
       {std::pair{kMostVertices + 1, kMostEdges}, {kMostVertices, kMostEdges + 1}}) {
    try {
      detail::check_counts_of_mesh(vertices, edges);
      FAIL() << vertices << ", " << edges;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Limit);
      EXPECT_NE(std::string(error.what()).find("--pieces"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace surfmesh
