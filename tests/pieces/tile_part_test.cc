// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/tile_part.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "pieces/tiled_cases.hh"
#include "support/pole_in_mesh.hh"

namespace surfmesh {
namespace {

using testing::MeshedTiles;
using testing::point_of;
using testing::TiledCase;

/// A face by the positions of its corners, from its first one on.
using PlacedFace = std::vector<Vec3>;

std::vector<PlacedFace> placed_faces_of(const PolyMesh& mesh) {
  std::vector<PlacedFace> faces;
  for (const FaceHandle fh : mesh.faces()) {
    PlacedFace& face = faces.emplace_back();
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      face.push_back(to_eigen(mesh.point(mesh.to_vertex_handle(heh))));
    }
  }
  return faces;
}

std::vector<PlacedFace> placed_faces_of(const std::vector<TilePart>& parts,
                                        const SharedNumbers& shared) {
  std::vector<PlacedFace> faces;
  for (const TilePart& part : parts) {
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      PlacedFace& face = faces.emplace_back();
      for (const int v : part.faces[f]) face.push_back(point_of(part, v, shared));
    }
  }
  return faces;
}

class PartOf : public ::testing::TestWithParam<TiledCase> {
 protected:
  MeshedTiles meshed_{GetParam()};
};

TEST_P(PartOf, ATileHasTheFacesOfTheResult) {
  const auto expected = placed_faces_of(meshed_.assembled());
  ASSERT_GT(expected.size(), 100u);
  EXPECT_TRUE(placed_faces_of(meshed_.parts(), meshed_.shared()) == expected);
}

TEST_P(PartOf, ATileKnowsItsPatch) {
  const PolyMesh mesh = meshed_.assembled();
  std::vector<int> patches;
  for (const TilePart& part : meshed_.parts()) {
    patches.insert(patches.end(), part.faces.size(), part.patch);
  }
  EXPECT_EQ(patches, mesh.property(require(mesh, keys::face_patch)).data_vector());
}

TEST_P(PartOf, ATileHasItsSharedVerticesFirst) {
  const std::vector<TilePart> parts = meshed_.parts();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    std::set<int> expected;
    for (const BoundaryLoop& loop : meshed_.tiles[t].boundary.loops) {
      for (const BoundaryNode& node : loop) {
        if (node.vertex >= 0) expected.insert(node.vertex);
      }
    }
    for (const PoleFan& fan : meshed_.tiles[t].boundary.fans) expected.insert(fan.pole);
    EXPECT_EQ(parts[t].shared, std::vector<int>(expected.begin(), expected.end()));
    EXPECT_EQ(parts[t].own_count(), parts[t].points.size() - expected.size());
  }
}

TEST_P(PartOf, ATileUsesAllOfItsVertices) {
  for (const TilePart& part : meshed_.parts()) {
    std::vector<char> is_used(part.points.size(), 0);
    for (const int v : part.faces.vertices()) is_used.at(static_cast<std::size_t>(v)) = 1;
    EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 0), 0);
  }
}

TEST_P(PartOf, ATileHasPointsButAtPoles) {
  const std::vector<TilePart> parts = meshed_.parts();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    std::set<int> poles;
    for (const PoleFan& fan : meshed_.tiles[t].boundary.fans) poles.insert(fan.pole);
    for (std::size_t v = 0; v < parts[t].points.size(); ++v) {
      const bool is_pole = v < parts[t].shared.size() && poles.contains(parts[t].shared[v]);
      EXPECT_EQ(parts[t].points[v].allFinite(), !is_pole);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tiles, PartOf, ::testing::ValuesIn(testing::tiled_cases()),
                         [](const auto& test) { return test.param.name; });

// --- faces of which corners are one vertex of the result ---

struct Faces {
  bool has_quads = false;
  bool is_turned = false;
};

void PrintTo(const Faces& a, std::ostream* out) {
  *out << (a.has_quads ? "quads" : "triangles") << (a.is_turned ? ", turned" : "");
}

class PartOfACone : public ::testing::TestWithParam<Faces> {
 protected:
  testing::PoleInMesh cone_{GetParam().has_quads, GetParam().is_turned};
};

TEST_P(PartOfACone, HasTheCollapsedFacesOfTheResult) {
  testing::PoleInMesh again(GetParam().has_quads, GetParam().is_turned);
  PolyMesh mesh;
  assemble(mesh, again.model, again.nodes, again.numbers, std::move(again.patches));
  const PatchBoundary boundary = cone_.patches[0].boundary;
  const SharedNumbers shared(cone_.model, cone_.nodes, cone_.numbers, {&boundary}, {0}, {0});
  const bool turned = orient_patches(cone_.model).is_turned[0] != 0;
  EXPECT_EQ(turned, GetParam().is_turned);
  std::vector<TilePart> parts;
  parts.push_back(
      part_of(surveyed(std::move(cone_.patches[0]), cone_.numbers, turned), cone_.numbers.count()));
  EXPECT_TRUE(placed_faces_of(parts, shared) == placed_faces_of(mesh));
}

INSTANTIATE_TEST_SUITE_P(Faces, PartOfACone,
                         ::testing::Values(Faces{false, false}, Faces{false, true},
                                           Faces{true, false}, Faces{true, true}));

}  // namespace
}  // namespace surfmesh
