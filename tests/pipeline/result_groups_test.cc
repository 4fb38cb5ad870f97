// SPDX-License-Identifier: BSD-3-Clause
//
// That the names of a model's patches and groups reach result, report and files.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/folders.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// A cube of three objects, in which two of the sides have a material, twice in a model file.
ModelInput two_cubes(const TestFolder& folder) {
  write_text(folder / "cube.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
             "o lower\nf 4 3 2 1\no side\nf 1 2 6 5\nf 2 3 7 6\nusemtl steel\nf 3 4 8 7\n"
             "f 4 1 5 8\nusemtl\no upper\nf 5 6 7 8\n");
  write_text(folder / "a.json", R"({"cages": [
      {"name": "one", "file": "cube.obj", "scheme": "bilinear"},
      {"name": "two", "file": "cube.obj", "scheme": "bilinear"}]})");
  return load_model(folder / "a.json", {.cages = {.patches = PatchKind::Faces}});
}

const std::vector<Group> kGroups = {{"lower", {0, 6}},
                                    {"one", {0, 1, 2, 3, 4, 5}},
                                    {"side", {1, 2, 3, 4, 7, 8, 9, 10}},
                                    {"steel", {3, 4, 9, 10}, true},
                                    {"upper", {5, 11}},
                                    {"two", {6, 7, 8, 9, 10, 11}}};

TEST(ResultGroups, AreTheObjectsMaterialsAndCagesOfTheModel) {
  const TestFolder folder;
  const ModelInput input = two_cubes(folder);
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  EXPECT_EQ(result.names.groups, kGroups);
  ASSERT_EQ(result.names.patches.size(), 12u);
  EXPECT_EQ(result.names.patches[6], "two:f0");
}

TEST(ResultGroups, StandInTheReportWithTrianglesAndArea) {
  const TestFolder folder;
  const ModelInput input = two_cubes(folder);
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  const auto patches = nlohmann::json::parse(to_json(result.report))["patches"];
  ASSERT_EQ(patches.size(), 12u);
  std::size_t triangles = 0;
  for (const auto& patch : patches) {
    EXPECT_NEAR(patch["area"].get<double>(), 1, 1e-12);
    triangles += patch["triangles"].get<std::size_t>();
  }
  EXPECT_EQ(triangles, result.mesh.n_faces());
  EXPECT_EQ(patches[3]["name"], "one:f3");
  EXPECT_EQ(patches[3]["groups"], (nlohmann::json{"one", "side", "steel"}));
}

/// In files, materials are groups like any others, but where all patches of an .obj file have one.
MeshNames with_groups_alike(MeshNames names) {
  for (Group& group : names.groups) group.is_material = false;
  return names;
}

TEST(ResultGroups, ComeBackFromFiles) {
  const TestFolder folder;
  const ModelInput input = two_cubes(folder);
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  const MeshNames names = with_groups_alike(result.names);
  for (const char* name : {"a.obj", "a.ply", "a.om"}) {
    write_mesh(result, folder / name);
    const MeshFile read = read_mesh(folder / name);
    EXPECT_EQ(read.names.patches, names.patches) << name;
    EXPECT_EQ(read.names.groups, names.groups) << name;
    EXPECT_EQ(mesh_arrays(read.mesh).patches, mesh_arrays(result.mesh).patches) << name;
  }
  EXPECT_EQ(read_mesh(folder / "a.om").names, names);
}

}  // namespace
}  // namespace surfmesh
