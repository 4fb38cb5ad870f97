// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>

#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/model_folders.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/option_schema.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/face_set_check.hh"

namespace surfmesh {
namespace {

using testing::kModels;

/// The mesh of a model file, which must be proper and without complaints.
MeshResult mesh_cleanly(const std::filesystem::path& path) {
  const ModelInput input = load_model(path);
  MeshResult result = mesh_model(input.model, input.sources, input.options);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Warning), std::vector<std::string>{}) << path;
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{})
      << path;
  EXPECT_GT(result.report.quality.min, 0.1) << path;
  return result;
}

std::string vertex_line(double x, double y, double z) {
  return "v " + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
}

/// Greatest distance of a corner on its patch from its surface at its parameters, in units of the
/// diagonal.
double greatest_gap(const Model& model, const PolyMesh& mesh) {
  const detail::CornersBeyond is_beyond(mesh);
  const auto patch_of = require(mesh, keys::face_patch);
  const auto uv_of = require(mesh, keys::corner_uv);
  double gap = 0;
  for (const auto face : mesh.faces()) {
    const auto patch = static_cast<std::size_t>(mesh.property(patch_of, face));
    for (const auto corner : face.halfedges()) {
      if (is_beyond(corner)) continue;
      const Uv uv = mesh.property(uv_of, corner);
      const Vec3 there = model.patches[patch].surface->evaluate(uv, Order::Position).point;
      gap = std::max(gap, (to_eigen(mesh.point(corner.to())) - there).norm());
    }
  }
  return gap / model.diagonal;
}

struct Example {
  std::string name;
  long euler;
  std::size_t components;
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

class ExampleModels : public ::testing::TestWithParam<Example> {};

TEST_P(ExampleModels, MeshCleanly) {
  const auto path = kModels / GetParam().name;
  const MeshResult result = mesh_cleanly(path);
  EXPECT_EQ(result.report.mesh.euler, GetParam().euler);
  EXPECT_EQ(measure_topology(result.mesh).components, GetParam().components);
  EXPECT_LT(greatest_gap(load_model(path).model, result.mesh), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    All, ExampleModels,
    ::testing::Values(Example{"bracket.json", -6, 1}, Example{"sphere.json", 2, 1},
                      Example{"blade.json", 0, 1}, Example{"torus.json", 0, 1},
                      Example{"wave.json", 1, 1}, Example{"perforated.json", -1, 1},
                      Example{"window.json", -1, 1}, Example{"pipes.json", -1, 1},
                      Example{"pipe_on_plate.json", 0, 1}, Example{"knob_on_plate.json", 3, 2},
                      Example{"sizes.json", 5, 5}, Example{"nurbs_sphere.json", 2, 1},
                      Example{"wing.json", 1, 1}, Example{"teapot.json", -1, 1},
                      Example{"ring.json", 1, 1}),
    [](const auto& test) { return test.param.name.substr(0, test.param.name.find('.')); });

/// Half the thickness of the blade's profile at u^2 along the chord, for u above 0.
double half_thickness(double u) {
  return 5 * 0.12 *
         (0.2969 * u - 0.126 * std::pow(u, 2) - 0.3516 * std::pow(u, 4) + 0.2843 * std::pow(u, 6) -
          0.1036 * std::pow(u, 8));
}

TEST(BladeModel, HasTheProfileOnBothSidesOfItsBluntEdge) {
  const Model model = load_model(kModels / "blade.json").model;
  for (const double u : {-0.9, -0.5, -0.01, 0.0, 0.01, 0.5, 0.9}) {
    const Jet jet = model.patches.at(0).surface->evaluate({u, 0}, Order::Second);
    EXPECT_NEAR(jet.point.x(), u * u - 0.3, 1e-15);
    EXPECT_NEAR(jet.point.y(), std::copysign(half_thickness(std::abs(u)), u), 1e-15);
    EXPECT_NEAR(jet.du.y(),
                (half_thickness(std::abs(u) + 1e-6) - half_thickness(std::abs(u) - 1e-6)) / 2e-6,
                1e-8);
  }
}

/// Least 3D quality of the triangles of a mesh.
constexpr double kLeastShape = 0.2;

TEST(EveryModel, IsMeshedAsItPromisesAndWithoutSlivers) {
  for (const auto& entry : std::filesystem::directory_iterator(kModels)) {
    const std::string name = entry.path().filename().string();
    const std::string ending = entry.path().extension().string();
    if (name == "surfmesh.schema.json") continue;
    if (ending != ".json" && ending != ".obj" && ending != ".off") continue;
    SCOPED_TRACE(name);
    const ModelInput input = load_model(entry.path());
    const MeshResult result = mesh_model(input.model, input.sources, input.options);
    testing::expect_valid(result.mesh);
    EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
    EXPECT_GT(measure_shape(mesh_arrays(result.mesh)).quality.min, kLeastShape);
  }
}

/// Expect a mesh that is cut along a seam, with a warning: every vertex of the cut has another one
/// in its place.
void expect_cut(const MeshResult& result, long euler, std::size_t pairs) {
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  ASSERT_EQ(texts_of(result.report.notices, Severity::Warning).size(), 1u);
  EXPECT_NE(texts_of(result.report.notices, Severity::Warning)[0].find("cannot be oriented"),
            std::string::npos);
  EXPECT_EQ(result.report.mesh.euler, euler);
  const FaceSetCheck check = check_face_set(mesh_arrays(result.mesh));
  EXPECT_TRUE(check.is_manifold && check.is_oriented && !check.is_closed);
  ASSERT_EQ(check.faults.size(), 1u);
  EXPECT_EQ(check.faults[0].kind, "duplicate_vertex");
  EXPECT_EQ(check.faults[0].count, pairs);
}

/// The number of edges along which the warning says that the mesh is cut.
std::size_t cut_edges(const MeshResult& result) {
  return std::stoul(texts_of(result.report.notices, Severity::Warning).at(0)) / 2;
}

TEST(OneSidedModels, AreCutAtASeam) {
  const ModelInput band = load_model(kModels / "moebius.json");
  const MeshResult cut_band = mesh_model(band.model, band.sources, band.options);
  expect_cut(cut_band, 1, cut_edges(cut_band) + 1);
  // The seam of a bottle is closed, and crosses itself once, in the middle of the figure eight.
  const ModelInput bottle = load_model(kModels / "klein.json");
  const MeshResult cut_bottle = mesh_model(bottle.model, bottle.sources, bottle.options);
  expect_cut(cut_bottle, 0, cut_edges(cut_bottle) + 1);
}

/// A strip of faces around a circle, turned over `turns` times on its way; of two half turns the
/// cage is no Möbius band.
std::string strip_cage(int turns) {
  std::string text;
  constexpr int kFaces = 24;
  for (int i = 0; i < kFaces; ++i) {
    const double angle = 2 * std::numbers::pi * i / kFaces;
    for (const double v : {-0.4, 0.4}) {
      const double radius = 1.5 + v * std::cos(turns * angle / 2);
      text += vertex_line(radius * std::cos(angle), radius * std::sin(angle),
                          v * std::sin(turns * angle / 2));
    }
  }
  for (int i = 0; i < kFaces; ++i) {
    const bool is_last = i + 1 == kFaces, is_crossed = is_last && turns % 2 == 1;
    const int a = 2 * i + 1, b = is_last ? 1 : a + 2;
    text += "f " + std::to_string(a) + ' ' + std::to_string(is_crossed ? b + 1 : b) + ' ' +
            std::to_string(is_crossed ? b : b + 1) + ' ' + std::to_string(a + 1) + '\n';
  }
  return text;
}

TEST(OneSidedModels, MayBeCages) {
  const TestFolder folder;
  write_text(folder / "one.obj", strip_cage(1));
  const ModelInput one = load_model(folder / "one.obj");
  const MeshResult cut = mesh_model(one.model, one.sources, one.options);
  expect_cut(cut, 1, cut_edges(cut) + 1);
  write_text(folder / "two.obj", strip_cage(2));
  const ModelInput two = load_model(folder / "two.obj");
  const MeshResult whole = mesh_model(two.model, two.sources, two.options);
  EXPECT_EQ(texts_of(whole.report.notices, Severity::Warning), std::vector<std::string>{});
  EXPECT_EQ(whole.report.mesh.euler, 0);
}

/// The half plane of this angle (radians) about the z axis, which ends at the contour `rim`.
nlohmann::json wing(const std::string& angle) {
  const std::string name = "w" + angle;
  return {{"name", name},
          {"surface", {{"x", "u*cos(" + angle + ")"}, {"y", "u*sin(" + angle + ")"}, {"z", "v"}}},
          {"domain", {{"u", {0, 1}}, {"v", {0, 1}}}},
          {"loops", {{name + ":v0", name + ":u1", "-" + name + ":v1", "-rim"}}}};
}

/// Three half planes at a contour given in space.
std::string three_wings() {
  const nlohmann::json rim = {{"name", "rim"}, {"xyz", {{"x", "0"}, {"y", "0"}, {"z", "t"}}}};
  return nlohmann::json{{"patches", {wing("0"), wing("2"), wing("4")}},
                        {"contours", nlohmann::json::array({rim})},
                        {"sizing", {{"hmax", 0.2}}}}
      .dump();
}

TEST(ContoursOfThreePatches, HaveTheSameNodesOnAll) {
  const TestFolder folder;
  write_text(folder / "a.json", three_wings());
  const ModelInput input = load_model(folder / "a.json");
  const MeshResult result = mesh_model(input.model, input.sources, input.options);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall).size(), 0u);
  std::set<double> heights;
  std::size_t count = 0;
  for (const auto vertex : result.mesh.vertices()) {
    const Vec3 point = to_eigen(result.mesh.point(vertex));
    if (std::hypot(point.x(), point.y()) > 1e-9) continue;
    heights.insert(point.z());
    ++count;
  }
  EXPECT_GT(heights.size(), 4u);
  // A half-edge mesh has each node as often as there are sheets.
  EXPECT_EQ(count % heights.size(), 0u);
}

TEST(ModelSources, ReachTheGroupsOfCages) {
  const ModelInput input = load_model(kModels / "knob_on_plate.json");
  std::set<std::string> names;
  for (const EverywhereSource& source : input.sources.everywhere) {
    names.insert(input.model.patches.at(static_cast<std::size_t>(source.patch)).name);
  }
  EXPECT_GT(names.size(), 4u);
  EXPECT_TRUE(names.contains("plate"));
  for (const std::string& name : names) {
    EXPECT_TRUE(name.starts_with("knob:f") || name == "plate") << name;
  }
}

nlohmann::json schema() {
  return nlohmann::json::parse(read_text(kModels / "surfmesh.schema.json"));
}

/// Keys of an object that the schema does not know. `rule` is the schema of the object.
void expect_known(const nlohmann::json& value, nlohmann::json rule, const nlohmann::json& root,
                  const std::string& place) {
  while (rule.contains("$ref")) {
    const std::string pointer = rule["$ref"].get<std::string>().substr(1);
    rule = root.at(nlohmann::json::json_pointer(pointer));
  }
  if (value.is_array() && rule.contains("items")) {
    for (const auto& item : value) expect_known(item, rule["items"], root, place + "/*");
  }
  if (!value.is_object() || !rule.contains("properties")) return;
  for (const auto& [key, item] : value.items()) {
    const bool is_known = rule["properties"].contains(key);
    EXPECT_TRUE(is_known || rule.contains("additionalProperties")) << place << '/' << key;
    if (is_known) {
      expect_known(item, rule["properties"][key], root, place + '/' + key);
    } else {
      EXPECT_NE(rule["additionalProperties"], false) << place << '/' << key;
    }
  }
}

TEST(Schema, KnowsTheKeysOfAllModels) {
  const nlohmann::json root = schema();
  for (const auto& entry : std::filesystem::directory_iterator(kModels)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json" || name == "surfmesh.schema.json") continue;
    expect_known(nlohmann::json::parse(read_text(entry.path())), root, root, name);
  }
}

TEST(Schema, TellsTheOptionsAsTheirTableDoes) {
  const std::string text = read_text(kModels / "surfmesh.schema.json");
  EXPECT_TRUE(schema_with_options(text) == text)
      << "run build/release/tools/make_schema models/surfmesh.schema.json";
}

TEST(Schema, HasTheKeysThatTheReaderKnows) {
  const nlohmann::json properties = schema()["properties"];
  for (const char* key : {"constants", "patches", "cages", "cad", "contours", "sources", "sizing",
                          "options", "$schema"}) {
    EXPECT_TRUE(properties.contains(key)) << key;
  }
  for (const std::string_view name : option_names()) {
    const char* place = find_option(name).group == OptionGroup::Sizes ? "sizing" : "options";
    EXPECT_TRUE(properties[place]["properties"].contains(name)) << name;
  }
}

}  // namespace
}  // namespace surfmesh
