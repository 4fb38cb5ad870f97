// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

std::filesystem::path own_model(const std::string& name) {
  return std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / name;
}

/// A model file of one patch with other keys at its root.
std::string model(const std::string& in_root) {
  return R"({"patches": [{"name": "p", "surface": {"z": "u*v"},
             "domain": {"u": [0, 2], "v": [-1, 1]}}], )" +
         in_root + "}";
}

std::string fault(const std::filesystem::path& path, const CageOptions& options = {}) {
  return error_of([&] { load_model(path, options); });
}

TEST(LoadModel, ReadsCages) {
  const ModelInput input = load_model(own_model("torus.obj"));
  EXPECT_EQ(input.model.patches.size(), 48u);
  EXPECT_EQ(input.options.sizing.curvature, Sizing{}.curvature);
}

TEST(LoadModel, ReadsModelFiles) {
  const ModelInput input = load_model(own_model("plate.json"));
  EXPECT_EQ(input.model.patches.size(), 1u);
  EXPECT_EQ(input.sources.at.size(), 2u);
  EXPECT_EQ(input.options.sizing.hmin.value, 0.005);
}

TEST(LoadModel, TakesTheOptionsOfAModelFile) {
  const TestFolder folder;
  write_text(folder / "a.json", model(R"("options": {"nodes": 400, "placement": "circumcentre",
                                         "quads": false, "precision": null})"));
  const ModelInput input = load_model(folder / "a.json");
  EXPECT_EQ(input.options.control.regular, 400);
  EXPECT_EQ(input.options.refine.placement, Placement::Circumcentre);
  EXPECT_EQ(input.options.control.precision, ControlNodeOptions{}.precision);
}

TEST(LoadModel, NamesThePlaceOfAWrongOption) {
  const TestFolder folder;
  const std::string front = "invalid input: " + (folder / "a.json").string() + ": /options/";
  write_text(folder / "a.json", model(R"("options": {"node": 400})"));
  EXPECT_EQ(fault(folder / "a.json"),
            front + "node: there is no option 'node'; did you mean nodes?");
  write_text(folder / "a.json", model(R"("options": {"nodes": 1})"));
  EXPECT_EQ(fault(folder / "a.json"),
            front + "nodes: nodes = 1 is outside its range: auto, or 4 and above");
  write_text(folder / "a.json", model(R"("options": {"hmin": 1})"));
  EXPECT_EQ(fault(folder / "a.json"), front + "hmin: its place is in sizing");
}

TEST(LoadModel, HasNoSchemeForModelFiles) {
  const std::string error = fault(own_model("wave.json"), {.scheme = Scheme::Loop});
  EXPECT_NE(error.find("only cages have a subdivision scheme"), std::string::npos) << error;
}

TEST(LoadModel, NamesTheFileOfACageThatCannotBeSubdivided) {
  const std::string error = fault(own_model("cube.obj"), {.scheme = Scheme::Loop});
  EXPECT_NE(error.find("cube.obj: "), std::string::npos) << error;
}

TEST(LoadModel, RefusesUnknownEndings) {
  EXPECT_EQ(fault("a.step"),
            "invalid input: a.step: the ending of a cage is .obj or .off, that of a model file "
            ".json");
}

}  // namespace
}  // namespace surfmesh
