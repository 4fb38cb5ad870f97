// SPDX-License-Identifier: BSD-3-Clause
// Options that act where a model is made are told where they come too late, and a report has those
// that took effect.
#include "surfmesh/pipeline/options_of_model.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cage/cages.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// The texts of notices of options without effect.
std::vector<std::string> unused(const Notices& notices) {
  std::vector<std::string> texts;
  for (const Notice& notice : notices) {
    if (notice.kind == NoticeKind::UnusedOption) texts.push_back(notice.text);
  }
  return texts;
}

std::filesystem::path own(const std::string& path) {
  return std::filesystem::path(SURFMESH_SOURCE_DIR) / path;
}

TEST(OptionsOfModels, AreToldWhereTheyComeTooLate) {
  const Model model = testing::unit_square();
  for (const auto& [name, value, place] :
       {std::tuple("joining", "1e-05", "JoinOptions of model_from_patches"),
        std::tuple("weld", "0.1%", "CageOptions of model_from_cage"),
        std::tuple("orient", "on", "CageOptions of model_from_cage"),
        std::tuple("crease_angle", "30", "CageOptions of model_from_cage"),
        std::tuple("surface", "interpolate", "CageOptions of model_from_cage"),
        std::tuple("fit", "0.1%", "CageOptions of model_from_cage"),
        std::tuple("patches", "faces", "CageOptions of model_from_cage")}) {
    PipelineOptions options;
    set_option(options, name, value);
    const Report report = mesh_model(model, {}, options).report;
    EXPECT_EQ(unused(report.notices),
              (std::vector<std::string>{std::string(name) + " = " + value +
                                        " has no effect: the model is made already, and without "
                                        "it; it belongs in the " +
                                        place + ", or in the LoadOptions of load_model"}));
    EXPECT_EQ(unused(estimate_mesh(model, {}, options).notices), unused(report.notices));
  }
}

TEST(OptionsOfModels, AreNotToldWhereTheModelWasMadeWithThem) {
  const CageOptions made = {.patches = PatchKind::Faces,
                            .weld = Length::share(1e-6),
                            .orient = true,
                            .crease_angle = 30,
                            .surface = SurfaceKind::Interpolate,
                            .fit = Length::share(1e-4)};
  const Model model = model_from_cage(testing::cube(), made);
  PipelineOptions options;
  options.patches = made.patches;
  options.weld = made.weld;
  options.orient = made.orient;
  options.crease_angle = made.crease_angle;
  options.surface = made.surface;
  options.fit = made.fit;
  EXPECT_TRUE(unused(mesh_model(model, {}, options).report.notices).empty());
  options.crease_angle = 31;
  EXPECT_EQ(unused(mesh_model(model, {}, options).report.notices).size(), 1u);
}

TEST(OptionsOfModels, AreNotToldForWhatLoadingTook) {
  ModelInput sides = load_model(own("tests/pipeline/near_sides.json"),
                                {.cages = {}, .joining = Length::units(1e-5)});
  EXPECT_EQ(sides.options.joining, Length::units(1e-5));
  EXPECT_TRUE(unused(mesh_model(sides.model, {}, sides.options).report.notices).empty());
  sides.options.joining = Length::units(1e-4);
  EXPECT_EQ(unused(mesh_model(sides.model, {}, sides.options).report.notices).size(), 1u);
}

TEST(OptionsOfModels, AreNotToldWhereAFileHasThemForAllOrForACage) {
  const TestFolder folder;
  write_text(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  write_text(folder / "a.json",
             R"({"cages": [{"name": "a", "file": "a.obj", "crease_angle": 20}],
                 "options": {"patches": "faces", "weld": true, "crease_angle": 50}})");
  const ModelInput input = load_model(folder / "a.json");
  const Report report = mesh_model(input.model, {}, input.options).report;
  EXPECT_TRUE(unused(report.notices).empty());
  EXPECT_EQ(report.options.crease_angle, 50);
  EXPECT_EQ(report.options.patches, PatchKind::Faces);
  EXPECT_TRUE(detail::was_made_with(input.model, "crease_angle", "20"));
}

TEST(OptionsInEffect, AreThoseThatTheModelWasMadeWith) {
  const Model model = testing::unit_square();
  PipelineOptions options;
  options.joining = Length::units(1e-3);
  options.crease_angle = 30;
  const PipelineOptions effect = mesh_model(model, {}, options).report.options;
  EXPECT_EQ(effect.joining, Length::units(model.joining));
  EXPECT_GT(model.joining, 0);
  EXPECT_FALSE(effect.crease_angle);
  // They can be given again.
  EXPECT_TRUE(unused(mesh_model(model, {}, effect).report.notices).empty());
}

TEST(OptionsInEffect, AreThoseOfACage) {
  const Model model = model_from_cage(testing::cube(), {.crease_angle = 30});
  EXPECT_EQ(mesh_model(model).report.options.crease_angle, 30);
}

}  // namespace
}  // namespace surfmesh
