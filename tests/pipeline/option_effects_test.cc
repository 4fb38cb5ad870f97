// SPDX-License-Identifier: BSD-3-Clause
// The law of options: each of them changes a result, or is refused. One that is silently ignored
// fails here, and so does one that is new in the table and has no case.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

/// A value other than the default, and the model and other settings with which it has an effect.
struct EffectCase {
  std::string value;
  std::string model = "torus.json";
  Settings others = {};
  std::string ending = ".obj";  ///< of the file
};

const std::map<std::string_view, EffectCase> kCases = {
    {"curvature", {"0.5"}},
    {"sag", {"1%"}},
    {"size", {"5%"}},
    {"isotropic", {"on", "window.json"}},
    {"hmin", {"10%"}},
    {"hmax", {"3%"}},
    {"stretch", {"1"}},
    {"grade", {"1.05", "plate.json"}},
    {"contour_curvature", {"off", "window.json"}},
    {"proximity", {"3", "window.json"}},
    {"features",
     {"off",
      "window.json",
      {{"proximity", "off"},
       {"contour_curvature", "off"},
       {"curvature", "off"},
       {"hmax", "100%"}}}},
    {"across", {"off", "knob.obj"}},
    {"curvature_from", {"differences"}},
    {"segments_per_circle", {"30"}},
    {"shares_of", {"part", "knob_on_plate.json", {{"hmax", "3%"}}}},
    {"sew", {"1e-5", "wave.json"}},
    {"nodes", {"100"}},
    {"precision", {"0.5", "wave.json"}},
    {"control", {"grid", "wave.json"}},
    {"interpolation", {"t"}},
    {"epsilon", {"0.9", "wave.json", {{"interpolation", "auto"}}}},
    {"blend", {"log"}},
    {"lookup", {"vertices", "sizes.json"}},
    {"inner_nodes", {"on", "wave.json"}},
    {"reuse", {"0.6", "wave.json", {{"control", "mesh"}, {"smoothing", "element"}}}},
    {"conformity", {"0.05", "wave.json", {{"placement", "circumcentre"}}}},
    {"sweeps", {"5"}},
    {"placement", {"circumcentre"}},
    {"kernel", {"swap"}},
    {"smoothing", {"off"}},
    {"repairs", {"off"}},
    {"patches", {"faces", "torus.obj"}},
    {"weld", {"15%", "torus.obj"}},
    {"joining", {"1e-5", "../tests/pipeline/near_sides.json"}},
    {"orient", {"on", "../tests/pipeline/turned_face.obj"}},
    {"crease_angle", {"30", "cube.obj"}},
    {"surface", {"interpolate", "torus.obj"}},
    {"fit", {"2%", "torus.obj"}},
    {"normals", {"on"}},
    {"uv", {"on"}},
    {"texture", {"on", "../tests/pipeline/textured.obj"}},
    {"msh", {"2.2", "torus.json", {}, ".msh"}},
    {"quads", {"on"}},
    {"quad_method", {"frontal", "torus.json", {{"quads", "on"}}}},
    {"quad_front", {"lee-lo", "torus.json", {{"quads", "on"}, {"quad_method", "frontal"}}}},
    {"tile", {"100"}},
    {"threads", {"1"}},
    {"max_elements", {"10"}},
};

/// The file of the mesh, or the error.
std::string outcome(const EffectCase& example, const Settings& settings) {
  const TestFolder folder;
  const std::filesystem::path path = folder / ("a" + example.ending);
  const std::string error = error_of([&] {
    PipelineOptions asked;
    for (const auto& [name, value] : settings) set_option(asked, name, value);
    const auto model = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models" / example.model;
    ModelInput input = load_model(model, {.cages = {.patches = asked.patches,
                                                    .weld = asked.weld,
                                                    .orient = asked.orient,
                                                    .crease_angle = asked.crease_angle,
                                                    .surface = asked.surface,
                                                    .fit = asked.fit},
                                          .joining = asked.joining,
                                          .cad = {.sew = asked.sew}});
    for (const auto& [name, value] : settings) set_option(input.options, name, value);
    write_mesh(mesh_model(input.model, input.sources, input.options), path);
  });
  return error + read_text(path);
}

class OptionEffect : public ::testing::TestWithParam<std::string> {};

TEST_P(OptionEffect, IsThere) {
  const auto found = kCases.find(GetParam());
  ASSERT_NE(found, kCases.end()) << "a new option needs a case here";
  const EffectCase& example = found->second;
  Settings settings = example.others;
  const std::string before = outcome(example, settings);
  settings.emplace_back(GetParam(), example.value);
  const bool is_same = outcome(example, settings) == before;
  // The mesh must not depend on the number of threads.
  EXPECT_EQ(is_same, GetParam() == "threads");
}

std::vector<std::string> names() { return {option_names().begin(), option_names().end()}; }

INSTANTIATE_TEST_SUITE_P(OfEachOption, OptionEffect, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace surfmesh
