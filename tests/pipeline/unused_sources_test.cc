// SPDX-License-Identifier: BSD-3-Clause
// Sources whose place nothing of their patches comes to are told.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::size_of;
using testing::units;

std::vector<std::string> unused(const Model& model, const Sources& sources,
                                PipelineOptions options = {}) {
  std::vector<std::string> texts;
  for (const Notice& notice : mesh_model(model, sources, options).report.notices) {
    if (notice.kind == NoticeKind::UnusedSource) texts.push_back(notice.text);
  }
  return texts;
}

constexpr const char* kEffect =
    "; it has no effect, or only where its size grows from there by the grade";

Eigen::AlignedBox3d box(const Vec3& low, const Vec3& high) { return {low, high}; }

TEST(UnusedSources, AreBoxesBesideTheSurface) {
  const Vec3 low(0.2, 0.2, -1), high(0.4, 0.4, 1), up(0, 0, 3);
  Sources sources;
  sources.boxes.push_back({.box = box(low, high), .wish = {size_of(0.1)}});
  EXPECT_TRUE(unused(testing::unit_square(), sources).empty());
  sources.boxes.push_back({.box = box(low + up, high + up), .wish = {size_of(0.1)}});
  EXPECT_EQ(
      unused(testing::unit_square(), sources),
      std::vector{std::string("sources.boxes[1]: no patch has a point in this box") + kEffect});
}

TEST(UnusedSources, AreThoseThatReachOnlyOtherPatches) {
  const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  const auto in_first = box(Vec3(0.2, 0.2, -1), Vec3(0.4, 0.4, 1));
  Sources sources;
  sources.boxes.push_back({.box = in_first, .wish = {size_of(0.1)}, .patches = {0}});
  EXPECT_TRUE(unused(model, sources).empty());
  sources.boxes[0].patches = {1};
  EXPECT_EQ(unused(model, sources).size(), 1u);
}

TEST(UnusedSources, ArePlacesFromWhichSizesGrowToTheBound) {
  PipelineOptions options;
  options.sizing.hmax = units(0.2);
  Sources sources;
  sources.near.push_back({.line = {Vec3(0.5, 0.5, 0.3)}, .wish = {size_of(0.05)}});
  EXPECT_TRUE(unused(testing::unit_square(), sources, options).empty());
  sources.near[0].line[0].z() = 0.5;  // grows by ln 1.5 = 0.41 a unit
  EXPECT_EQ(unused(testing::unit_square(), sources, options).size(), 1u);
  options.sizing.grade = 1.2;
  EXPECT_TRUE(unused(testing::unit_square(), sources, options).empty());
}

TEST(UnusedSources, AreBallsThatTheSurfaceDoesNotComeTo) {
  Sources sources;
  sources.near.push_back({.line = {Vec3(0.5, 0.5, 0.4)}, .wish = {size_of(0.05), units(0.5)}});
  EXPECT_TRUE(unused(testing::unit_square(), sources).empty());
  sources.near[0].wish.radius = units(0.3);
  EXPECT_EQ(unused(testing::unit_square(), sources),
            std::vector{std::string("sources.near[0]: no patch comes near enough to this place for "
                                    "its size") +
                        kEffect});
}

TEST(UnusedSources, AreThoseInAHole) {
  const Model model = testing::square_with_hole(0.6);
  const auto segment = std::make_shared<SegmentCurve>(Uv{-0.1, 0}, Uv{0.1, 0});
  Sources sources;
  sources.at.push_back({.patch = 0, .at = {0, 0}, .size = size_of(0.1)});
  sources.along.push_back({.patch = 0, .curves = {segment}, .wish = {size_of(0.1)}});
  sources.inside.push_back(
      {.patch = 0, .polygon = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}}, .wish = {size_of(0.1)}});
  const auto text = [](const char* list, const char* what) {
    return std::string("sources.") + list + "[0]: this " + what +
           " lies outside of the loops of patch p0" + kEffect;
  };
  EXPECT_EQ(unused(model, sources),
            (std::vector<std::string>{text("at", "point"), text("along", "curve"),
                                      text("inside", "polygon")}));
  sources.at[0].at = {0.8, 0.8};
  sources.along[0].curves = {std::make_shared<SegmentCurve>(Uv{0.7, 0.7}, Uv{0.9, 0.9})};
  sources.inside[0].polygon = {{-0.9, -0.9}, {-0.7, -0.9}, {-0.7, -0.7}};
  EXPECT_TRUE(unused(model, sources).empty());
}

TEST(UnusedSources, HaveTheirJsonPointer) {
  const TestFolder folder;
  write_text(folder / "a.json", R"({"patches": [
      {"name": "p", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}}],
      "sources": [{"near": [0, 0, 0], "size": 0.1},
                  {"inside": {"box": [[0, 0, 2], [1, 1, 3]]}, "size": 0.1}]})");
  const ModelInput input = load_model(folder / "a.json");
  const auto texts = unused(input.model, input.sources);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(texts[0].starts_with((folder / "a.json").string() + ": /sources/1: no patch has"))
      << texts[0];
}

/// The error of meshing the unit square with these sources.
std::string fault(const Sources& sources) {
  return error_of([&] { mesh_model(testing::unit_square(), sources); });
}

TEST(Sources, AreNamedInErrorsByKindAndIndex) {
  Sources sources;
  sources.at.push_back({.patch = 0, .at = {0.5, 0.5}, .size = size_of(0.1)});
  sources.at.push_back({.patch = 7, .at = {0.5, 0.5}, .size = size_of(0.1)});
  EXPECT_EQ(fault(sources),
            "invalid input: sources.at[1]: it names patch 7, but the model has 1 patch, counted "
            "from 0");
  sources.at[1].patch = 0;
  sources.at[1].at = {2, 0};
  EXPECT_EQ(fault(sources),
            "invalid input: patch p0: sources.at[1]: a source at (u,v) = (2, 0) lies outside the "
            "domain");
  sources.at[1].at = {0, 0};
  sources.at[0].size = size_of(-1);
  EXPECT_TRUE(fault(sources).starts_with("invalid input: sources.at[0]: a size of [-1, -1]"))
      << fault(sources);
}

TEST(Sources, InSpaceAreNamedInErrorsByKindAndIndex) {
  Sources sources;
  sources.boxes.push_back({.box = {}, .wish = {size_of(0.1)}});
  EXPECT_EQ(
      fault(sources),
      "invalid input: sources.boxes[0]: a source is inside a box that is empty or not finite");
  sources = {};
  sources.near.push_back({.line = {}, .wish = {size_of(0.1)}, .origin = "a.json: /sources/4"});
  EXPECT_EQ(fault(sources),
            "invalid input: a.json: /sources/4: a source near a line needs a point");
}

}  // namespace
}  // namespace surfmesh
