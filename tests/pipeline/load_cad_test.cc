// SPDX-License-Identifier: BSD-3-Clause
// CAD files in load_model, with a reader that makes squares in place of reading.
#include <gtest/gtest.h>

#include <string>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// A square and what the reader was asked for.
LoadOptions with_reader(std::optional<Length>* sew = nullptr) {
  LoadOptions options;
  options.read_cad = [sew](const std::filesystem::path&, const CadOptions& asked) {
    if (sew) *sew = asked.sew;
    Model model = testing::model_of({testing::rectangle(0, 0, 1, 1)});
    model.patches[0].name = "face1";
    for (std::size_t c = 0; c < 4; ++c) {
      model.contours[c].name = std::string("edge").append(std::to_string(c + 1));
    }
    return model;
  };
  return options;
}

std::string fault(const TestFolder& folder, const std::string& text) {
  write_text(folder / "a.json", text);
  return error_of([&] { load_model(folder / "a.json", with_reader()); });
}

TEST(LoadCad, NeedsAReader) {
  EXPECT_NE(error_of([] {
              load_model("part.step");
            }).find("part.step: STEP, IGES and BREP files are read by the module surfmesh_cad"),
            std::string::npos);
}

TEST(LoadCad, TakesAllEndingsInAnyCase) {
  for (const char* name : {"a.step", "a.STP", "a.iges", "a.Igs", "a.brep"}) {
    EXPECT_EQ(load_model(name, with_reader()).model.patches.size(), 1U) << name;
  }
  EXPECT_FALSE(has_cad_ending("a.stepx"));
}

TEST(LoadCad, HandsOnTheSewing) {
  std::optional<Length> sew;
  LoadOptions options = with_reader(&sew);
  load_model("a.step", options);
  EXPECT_FALSE(sew);
  options.cad.sew = Length::units(0.1);
  load_model("a.step", options);
  EXPECT_EQ(sew, Length::units(0.1));
}

TEST(LoadCad, TakesTheSewingOfTheFileUnlessAskedFromOutside) {
  const TestFolder folder;
  write_text(folder / "a.json", R"({"cad": [{"file": "a.step", "sew": 0.2}]})");
  std::optional<Length> sew;
  LoadOptions options = with_reader(&sew);
  load_model(folder / "a.json", options);
  EXPECT_EQ(sew, Length::units(0.2));
  options.cad.sew = Length();
  load_model(folder / "a.json", options);
  EXPECT_EQ(sew, Length());
}

TEST(LoadCad, PutsFilesBesideEachOtherUnderTheirNames) {
  const TestFolder folder;
  write_text(folder / "a.json", R"({"cad": [{"name": "bolt", "file": "a.step"},
                                            {"name": "nut", "file": "b.igs"}],
                                    "sources": [{"group": "nut", "size": 0.1}]})");
  const ModelInput input = load_model(folder / "a.json", with_reader());
  ASSERT_EQ(input.model.patches.size(), 2U);
  EXPECT_EQ(input.model.patches[1].name, "nut:face1");
  EXPECT_EQ(input.model.contours[4].name, "nut:edge1");
  EXPECT_EQ(find_group(input.model, "nut"), std::vector<int>{1});
  ASSERT_EQ(input.sources.everywhere.size(), 1U);
  EXPECT_EQ(input.sources.everywhere[0].patch, 1);
  EXPECT_EQ(input.files.size(), 3U);
}

TEST(LoadCad, TakesSizesAlongContoursByName) {
  const TestFolder folder;
  write_text(folder / "a.json", R"({"cad": [{"file": "a.step"}], "sizing": {"hmax": "50%"},
                                    "sources": [{"along": ["edge1", "edge3"], "size": 0.05}]})");
  const ModelInput input = load_model(folder / "a.json", with_reader());
  ASSERT_EQ(input.sources.along.size(), 2U);
  EXPECT_TRUE(input.model.contour(find_contour(input.model, "edge1")).is_named);
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  EXPECT_LT(result.report.lengths.min, 0.07);
  EXPECT_GT(result.report.lengths.max, 0.15);
}

TEST(LoadCad, RefusesWhatDoesNotFit) {
  const TestFolder folder;
  EXPECT_NE(fault(folder, R"({"cad": [{"file": "a.obj"}]})").find("/cad/0/file: must end in .step"),
            std::string::npos);
  EXPECT_NE(fault(folder, R"({"cad": [{"file": "a.step"}, {"file": "b.step"}]})")
                .find("/cad/0: several CAD files need names"),
            std::string::npos);
  EXPECT_NE(fault(folder, R"({"cad": [{"file": "a.step"}], "patches": [{"name": "face1",
                              "surface": {"z": "1"}, "domain": {"u": [0, 1], "v": [0, 1]}}]})")
                .find("/cad/0: a CAD file beside patches or cages needs a name"),
            std::string::npos);
  EXPECT_NE(fault(folder, R"({"cad": [{"file": "a.step"}],
                              "sources": [{"along": "edge9", "size": 1}]})")
                .find("edge9 is no contour or side of the model, did you mean edge"),
            std::string::npos);
  EXPECT_NE(fault(folder, R"({"cad": [{"file": "a.step"}], "options": {"joining": 0.1}})")
                .find("only patches of formulas have sides to join"),
            std::string::npos);
}

TEST(LoadCad, HasNoCagesNorCagesCadFiles) {
  LoadOptions options = with_reader();
  options.cages.orient = true;
  EXPECT_NE(
      error_of([&] { load_model("a.step", options); }).find("only cages have faces to orient"),
      std::string::npos);
  const auto cube = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / "cube.obj";
  EXPECT_NE(error_of([&] {
              load_model(cube, {.cad = {.sew = Length::units(1)}});
            }).find("only CAD files have edges to sew"),
            std::string::npos);
}

}  // namespace
}  // namespace surfmesh
