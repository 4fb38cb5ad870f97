// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates and materials of OBJ files: read into cages, and written again.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "formats/five_points.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using Lists = std::vector<std::vector<int>>;

const std::string kTextured = std::string(SURFMESH_SOURCE_DIR) + "/tests/pipeline/textured.obj";

Cage textured_cage(const std::string& rest) { return parse_obj(kFive + rest, "a.obj"); }

TEST(ObjTexture, IsReadByCorners) {
  const Cage cage = textured_cage("vt 0 0.5\nvt 1 0.25 7\nvt -2\nf 1/1 2/2/1 3/-1\nf 1//1 3/1 4\n");
  EXPECT_EQ(cage.texture.points, (std::vector<Uv>{{0, 0.5}, {1, 0.25}, {-2, 0}}));
  EXPECT_EQ(cage.texture.faces, (Lists{{0, 1, 2}, {-1, 0, -1}}));
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(ObjTexture, MayComeAfterFacesAndFacesWithoutIt) {
  const Cage cage = textured_cage("f 1 2 3 4\nf 1/2 2/1 3/1\nvt 0 0\nvt 1 0\n");
  EXPECT_EQ(cage.texture.faces, (Lists{{-1, -1, -1, -1}, {1, 0, 0}}));
}

TEST(ObjTexture, IsNoneWhereNoFaceHasIt) {
  const Cage cage = textured_cage("vt 0 0\nf 1 2 3\n");
  EXPECT_TRUE(cage.texture.points.empty());
  EXPECT_TRUE(cage.texture.faces.empty());
}

TEST(ObjTexture, OfFacesThatAreLeftOutIsLeftOut) {
  const Cage cage = textured_cage("vt 0 0\nvt 1 0\nf 1/1 2/1 1/1\nf 1/2 2/2 3/2\n");
  EXPECT_EQ(cage.texture.faces, (Lists{{1, 1, 1}}));
}

TEST(ObjTexture, WarnsOfWhatMakesNoSense) {
  const Cage cage = textured_cage("vt 0 0\nvt x 1\nf 1/9 2/0 3/-5\nf 1/1 3/2 4/1\n");
  EXPECT_EQ(cage.texture.faces, (Lists{{-1, -1, -1}, {0, 1, 0}}));
  EXPECT_TRUE(std::isnan(cage.texture.points[1].u));
  EXPECT_EQ(texts_of(cage.notices),
            (std::vector<std::string>{
                "a.obj:7: texture coordinates that are no numbers are ignored",
                "a.obj:8: texture index 0, but 2 texture coordinates before it; it is ignored "
                "(and 2 more)"}));
}

TEST(ObjTexture, IsNotOfMeshes) {
  const MeshFile file = read_mesh(kTextured);
  EXPECT_EQ(file.unread, std::vector<std::string>{"texture coordinates (vt)"});
}

MeshResult textured_result() {
  PipelineOptions options;
  options.output.texture = true;
  options.sizing.size = Length::units(0.7);
  return mesh_model(load_model(kTextured, {.cages = {.scheme = Scheme::Bilinear}}).model, {},
                    options);
}

/// Points with their texture coordinates, to eight digits.
using Places = std::set<std::tuple<long, long, long, long, long>>;

Places places_of(const Cage& cage) {
  const auto rounded = [](double x) { return std::lround(1e8 * x); };
  Places places;
  for (std::size_t f = 0; f < cage.texture.faces.size(); ++f) {
    for (std::size_t i = 0; i < cage.texture.faces[f].size(); ++i) {
      const int number = cage.texture.faces[f][i];
      if (number < 0) continue;
      const Vec3& p = cage.points[static_cast<std::size_t>(cage.faces[f][i])];
      const Uv uv = cage.texture.points[static_cast<std::size_t>(number)];
      places.emplace(rounded(p.x()), rounded(p.y()), rounded(p.z()), rounded(uv.u), rounded(uv.v));
    }
  }
  return places;
}

TEST(ObjTexture, IsWrittenInPlaceOfTheParameters) {
  const TestFolder folder;
  const MeshResult result = textured_result();
  write_mesh(result, folder / "a.obj");
  const Cage cage = read_cage(folder / "a.obj");
  EXPECT_TRUE(texts_of(cage.notices).empty());
  ASSERT_EQ(cage.texture.faces.size(), result.mesh.n_faces());
  const auto texture_of = require(result.mesh, keys::corner_texture);
  std::size_t without = 0;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const auto face = result.mesh.face_handle(static_cast<unsigned>(f));
    std::size_t i = 0;
    for (const auto heh : result.mesh.fh_range(face)) {
      const Uv texture = result.mesh.property(texture_of, heh);
      const auto& corners = cage.faces[f];
      // Corners of the file may begin with another one of the face.
      const auto at =
          std::find(corners.begin(), corners.end(), result.mesh.to_vertex_handle(heh).idx());
      ASSERT_NE(at, corners.end());
      const int number = cage.texture.faces[f][static_cast<std::size_t>(at - corners.begin())];
      EXPECT_EQ(number < 0, std::isnan(texture.u));
      without += number < 0;
      if (number >= 0) {
        EXPECT_EQ(cage.texture.points[static_cast<std::size_t>(number)], texture);
      }
      ++i;
    }
    EXPECT_EQ(i, cage.faces[f].size());
  }
  EXPECT_GT(without, 0u);
  // The corners of the cube are still there, with all that they had.
  const Places had = places_of(read_cage(kTextured)), have = places_of(cage);
  EXPECT_TRUE(std::includes(have.begin(), have.end(), had.begin(), had.end()));
}

TEST(ObjTexture, StandsInGlbFilesToo) {
  const TestFolder folder;
  MeshResult result = textured_result();
  write_mesh(result, folder / "a.glb");
  const std::string with = read_text(folder / "a.glb");
  EXPECT_NE(with.find("TEXCOORD_0"), std::string::npos);
  result.report.options.output.texture = false;
  write_mesh(result, folder / "a.glb");
  EXPECT_EQ(read_text(folder / "a.glb").find("TEXCOORD_0"), std::string::npos);
}

TEST(ObjTexture, IsKeptByOmFiles) {
  const TestFolder folder;
  const MeshResult result = textured_result();
  write_mesh(result, folder / "a.om");
  const MeshFile file = read_mesh(folder / "a.om");
  const auto before = require(result.mesh, keys::corner_texture);
  const auto after = require(file.mesh, keys::corner_texture);
  for (const auto heh : file.mesh.halfedges()) {
    const Uv a = result.mesh.property(before, heh), b = file.mesh.property(after, heh);
    EXPECT_TRUE(a == b || (std::isnan(a.u) && std::isnan(b.u)));
  }
}

TEST(ObjTexture, TellsWhatIsNotWritten) {
  const MeshResult result = textured_result();
  OutputOptions options{.texture = true};
  EXPECT_TRUE(unused_options(result.mesh, "a.obj", options).empty());
  EXPECT_EQ(texts_of(unused_options(result.mesh, "a.ply", options)),
            std::vector<std::string>{
                "texture has no effect on a.ply: texture coordinates of the corners are written "
                "to .obj, .glb or .om"});
  const auto lost = what_is_lost(result.mesh, "a.ply", result.names, options);
  EXPECT_TRUE(std::count(lost.begin(), lost.end(), "the texture coordinates of the corners"));
  options.uv = true;
  EXPECT_EQ(texts_of(unused_options(result.mesh, "a.obj", options)),
            std::vector<std::string>{"uv has no effect on a.obj: the texture coordinates of the "
                                     "cage stand in the place of (u,v)"});
  const auto lost_uv = what_is_lost(result.mesh, "a.obj", result.names, options);
  EXPECT_TRUE(std::count(lost_uv.begin(), lost_uv.end(), "the parameters (u,v) of the corners"));
  EXPECT_FALSE(
      std::count(lost_uv.begin(), lost_uv.end(), "the texture coordinates of the corners"));
  PolyMesh without = result.mesh;
  detach(without, keys::corner_texture);
  EXPECT_EQ(texts_of(unused_options(without, "a.obj", {.texture = true})),
            std::vector<std::string>{
                "texture has no effect: the mesh has no texture coordinates of the corners"});
}

TEST(ObjMaterials, AreGroupsAndAreWrittenAgain) {
  const TestFolder folder;
  const MeshResult result = textured_result();
  const auto is_material = [](const auto& group) { return group.is_material; };
  ASSERT_EQ(result.names.groups.size(), 2u);
  EXPECT_TRUE(std::all_of(result.names.groups.begin(), result.names.groups.end(), is_material));
  write_mesh(result, folder / "a.obj");
  const std::string text = read_text(folder / "a.obj");
  EXPECT_NE(text.find("\nusemtl wood\n"), std::string::npos);
  EXPECT_NE(text.find("\nusemtl steel\n"), std::string::npos);
  const MeshFile again = read_mesh(folder / "a.obj");
  EXPECT_EQ(again.names.patches, result.names.patches);
  EXPECT_EQ(again.names.groups, result.names.groups);
}

/// A patch without a material would have that of the one before it.
TEST(ObjMaterials, AreWrittenAsGroupsWhereNotAllPatchesHaveOne) {
  const TestFolder folder;
  MeshResult result = textured_result();
  result.names.groups.resize(1);
  write_mesh(result, folder / "a.obj");
  EXPECT_EQ(read_text(folder / "a.obj").find("usemtl"), std::string::npos);
  const MeshFile again = read_mesh(folder / "a.obj");
  ASSERT_EQ(again.names.groups.size(), 1u);
  EXPECT_EQ(again.names.groups[0].patches, result.names.groups[0].patches);
}

}  // namespace
}  // namespace surfmesh
