// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/check_mesh.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/meshes.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using Json = nlohmann::json;

/// A tetrahedron, and one triangle more.
MeshArraysFile tetrahedron(const std::vector<std::vector<int>>& more = {}) {
  MeshArraysFile file;
  file.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<std::vector<int>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  faces.insert(faces.end(), more.begin(), more.end());
  for (const auto& face : faces) file.mesh.faces.add(face);
  return file;
}

TEST(CheckMesh, FindsNothingWrongWithATetrahedron) {
  const MeshCheck check = check_mesh(tetrahedron());
  EXPECT_TRUE(check.faults.empty());
  EXPECT_TRUE(check.faces.is_closed && check.faces.is_manifold && check.faces.is_oriented);
  EXPECT_EQ(check.faces.euler, 2);
  EXPECT_NEAR(check.shape.max_angle, std::numbers::pi / 2, 1e-12);
  EXPECT_FALSE(check.fit.has_value());
}

TEST(CheckMesh, TellsTheFaultsOfTheFaceSet) {
  const MeshArraysFile file = tetrahedron({{0, 1, 2}});
  const MeshCheck check = check_mesh(file);
  EXPECT_EQ(check.faults, check_face_set(file.mesh).faults);
  EXPECT_FALSE(check.faults.empty());
}

TEST(CheckMesh, TellsTrianglesThatTheReaderLeftOut) {
  MeshArraysFile file = tetrahedron();
  file.degenerate_faces = {4, 7};
  const MeshCheck check = check_mesh(file);
  ASSERT_EQ(check.faults.size(), 1u);
  EXPECT_EQ(check.faults[0].kind, "degenerate_face");
  EXPECT_EQ(check.faults[0].count, 2u);
  EXPECT_EQ(check.faults[0].places[1],
            "face 7 of the file does not have three different corners, or no inside");
}

TEST(CheckMesh, HasOneFaultOfAKind) {
  MeshArraysFile file;
  file.mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  file.mesh.faces.add(std::vector{0, 1, 2});
  file.degenerate_faces = {1};
  const MeshCheck check = check_mesh(file);
  ASSERT_EQ(check.faults.size(), 1u);
  EXPECT_EQ(check.faults[0].count, 2u);
  EXPECT_EQ(check.faults[0].places.size(), 2u);
}

TEST(CheckMesh, TellsFacesThatPassThroughEachOtherButNotAsAFault) {
  MeshArraysFile file = tetrahedron();
  for (const double x : {0.1, 0.1, 0.6}) file.mesh.points.emplace_back(x, 0.2, x < 0.5 ? -1 : 1);
  file.mesh.points[5].z() = 1;
  file.mesh.faces.add(std::vector{4, 5, 6});
  const MeshCheck check = check_mesh(file);
  EXPECT_GT(check.self_intersections.count, 0u);
  EXPECT_TRUE(check.faults.empty());
  EXPECT_EQ(Json::parse(to_json(check))["self_intersections"]["count"],
            check.self_intersections.count);
}

TEST(CheckMesh, TellsTheVolumeOfClosedMeshesOnly) {
  EXPECT_DOUBLE_EQ(Json::parse(to_json(check_mesh(tetrahedron())))["volume"], 1.0 / 6);
  EXPECT_TRUE(Json::parse(to_json(check_mesh(tetrahedron({{0, 1, 2}}))))["volume"].is_null());
}

TEST(CheckMesh, PassesWarningsOn) {
  MeshArraysFile file = tetrahedron();
  file.notices = {warning(NoticeKind::IgnoredInput, "a.obj:1: odd")};
  EXPECT_EQ(check_mesh(file).notices, file.notices);
}

/// The rectangle [0,2] × [0,2] as two patches side by side, with the size `hmax` everywhere.
ModelInput two_rectangles(double hmax) {
  ModelInput input;
  input.model = testing::model_of({testing::rectangle(0, 0, 1, 2), testing::rectangle(1, 0, 2, 2)});
  input.options.sizing.curvature = 0;
  input.options.sizing.grade = 0;
  input.options.sizing.hmin = Length::units(1e-6);
  input.options.sizing.hmax = Length::units(hmax);
  return input;
}

/// Unit squares cut in two, each on its patch of two_rectangles.
MeshFile grid_on_patches() {
  MeshFile file;
  file.mesh = testing::plane_grid(2, 2);
  const auto patch_of = require(file.mesh, keys::face_patch);
  for (const auto face : file.mesh.faces()) {
    file.mesh.property(patch_of, face) = file.mesh.calc_centroid(face)[0] < 1 ? 0 : 1;
  }
  return file;
}

/// Mean length of the edges of that grid.
const double kMean = (12 + 4 * std::numbers::sqrt2) / 16;

TEST(MeasureFit, MeasuresInTheSizesOfTheModel) {
  for (const double hmax : {1.0, 0.25}) {
    MeshFile mesh = grid_on_patches();
    const ModelFit fit = measure_fit(mesh, two_rectangles(hmax), JudgedBy::ExactSizes);
    EXPECT_FALSE(fit.is_projected);
    EXPECT_EQ(fit.sizes.edges.count, 16u);
    EXPECT_NEAR(fit.sizes.edges.mean, kMean / hmax, 1e-12);
    EXPECT_NEAR(fit.sizes.quality.mean, std::numbers::sqrt3 / 2, 1e-12);
    EXPECT_EQ(fit.distance.max, 0);
    EXPECT_TRUE(fit.distance.faults.empty());
  }
}

TEST(MeasureFit, EndsOnceItIsCancelled) {
  MeshFile mesh = grid_on_patches();
  testing::Cancelling observer;
  EXPECT_EQ(
      error_of([&] { measure_fit(mesh, two_rectangles(1), JudgedBy::ExactSizes, &observer); }),
      testing::kCancelled);
}

/// The metric with edges a tenth as long as wanted.
MeshFile grid_with_metric() {
  MeshFile mesh = grid_on_patches();
  const auto metric_of = require(mesh.mesh, keys::corner_metric);
  for (const auto heh : mesh.mesh.halfedges()) mesh.mesh.property(metric_of, heh) = {100, 0, 100};
  return mesh;
}

TEST(MeasureFit, JudgesByTheMetricOfTheMesh) {
  MeshFile mesh = grid_with_metric();
  const ModelFit fit = measure_fit(mesh, two_rectangles(1));
  EXPECT_TRUE(fit.is_by_stored_metric);
  EXPECT_NEAR(fit.sizes.edges.mean, 10 * kMean, 1e-12);
  EXPECT_EQ(fit.sizes.edges, measure_stored_metric(mesh.mesh)->edges);
}

TEST(MeasureFit, ReplacesTheMetricOfTheMeshWhereExactSizesJudge) {
  MeshFile mesh = grid_with_metric();
  const ModelFit fit = measure_fit(mesh, two_rectangles(1), JudgedBy::ExactSizes);
  EXPECT_FALSE(fit.is_by_stored_metric);
  EXPECT_NEAR(fit.sizes.edges.mean, kMean, 1e-12);
  EXPECT_NEAR(measure_edges(mesh.mesh).mean, kMean, 1e-12);
}

TEST(MeasureFit, HasNoStoredMetricWithoutParametersOrWhereOneIsUnset) {
  MeshFile bare = grid_with_metric();
  detach(bare.mesh, keys::corner_uv);
  EXPECT_FALSE(measure_stored_metric(bare.mesh));
  EXPECT_FALSE(measure_fit(bare, two_rectangles(1)).is_by_stored_metric);
  MeshFile torn = grid_with_metric();
  const auto metric_of = require(torn.mesh, keys::corner_metric);
  torn.mesh.property(metric_of, torn.mesh.halfedge_handle(FaceHandle(3))) = Metric();
  EXPECT_FALSE(measure_stored_metric(torn.mesh));
  EXPECT_NEAR(measure_fit(torn, two_rectangles(1)).sizes.edges.mean, kMean, 1e-12);
}

/// One code measures the sag of a run and that of a check; no edges are judged otherwise.
TEST(MeasureFit, AgreesWithTheReportOfTheRun) {
  ModelInput input;
  input.model = testing::model_of({testing::whole_torus()});
  input.options.sizing.sag = Length::share(0.005);
  const MeshResult result = mesh_model(input.model, {}, input.options);
  MeshFile mesh{result.mesh, result.names, {}};
  const ModelInput only_model{input.model, {}, {}, {}};
  const ModelFit fit = measure_fit(mesh, only_model);
  EXPECT_EQ(fit.sizes.edges, result.report.edges);
  EXPECT_EQ(fit.sizes.quality, result.report.quality);
  EXPECT_EQ(fit.distance.max, *result.report.sag.reached);
  EXPECT_TRUE(fit.distance.faults.empty());
}

TEST(MeasureFit, TakesASizeInItsPatchOnly) {
  ModelInput input = two_rectangles(1);
  input.sources.everywhere.push_back({1, {Length::units(0.5), Length::units(0.5), 0}});
  MeshFile mesh = grid_on_patches();
  measure_fit(mesh, input, JudgedBy::ExactSizes);
  const auto metric_of = require(mesh.mesh, keys::corner_metric);
  const auto patch_of = require(mesh.mesh, keys::face_patch);
  for (const auto heh : mesh.mesh.halfedges()) {
    if (heh.is_boundary()) continue;
    const double wanted = mesh.mesh.property(patch_of, heh.face()) == 1 ? 4 : 1;
    EXPECT_NEAR(mesh.mesh.property(metric_of, heh).m11, wanted, 1e-12);
  }
}

TEST(MeasureFit, TellsWhatItDoesNotKnow) {
  ModelInput input = two_rectangles(1);
  MeshFile mesh = grid_on_patches();
  EXPECT_FALSE(measure_fit(mesh, input, JudgedBy::ExactSizes).has_other_sizes);
  input.options.sizing.grade = 1.5;
  EXPECT_TRUE(measure_fit(mesh, input, JudgedBy::ExactSizes).has_other_sizes);
  input.options.sizing.grade = 0;
  input.sources.at.push_back({0, {0.5, 0.5}, {Length::units(0.5), Length::units(0.5), 0}});
  EXPECT_TRUE(measure_fit(mesh, input, JudgedBy::ExactSizes).has_other_sizes);
}

TEST(MeasureFit, ProjectsAMeshWithoutParameters) {
  MeshFile bare;
  bare.mesh = grid_on_patches().mesh;
  detach(bare.mesh, keys::corner_uv);
  detach(bare.mesh, keys::face_patch);
  MeshFile torn = grid_on_patches();
  torn.mesh.property(require(torn.mesh, keys::corner_uv),
                     torn.mesh.halfedge_handle(FaceHandle(3))) = Uv();
  for (MeshFile* mesh : {&bare, &torn}) {
    const ModelFit fit = measure_fit(*mesh, two_rectangles(1));
    EXPECT_TRUE(fit.is_projected);
    EXPECT_NEAR(fit.sizes.edges.mean, kMean, 1e-9);
    EXPECT_NEAR(fit.distance.max, 0, 1e-9);
    ASSERT_TRUE(fit.from_surface);
    EXPECT_NEAR(fit.from_surface->max, 0, 1e-9);
    const auto patch_of = require(mesh->mesh, keys::face_patch);
    EXPECT_EQ(mesh->mesh.property(patch_of, FaceHandle(0)), 0);
    EXPECT_EQ(mesh->mesh.property(patch_of, FaceHandle(3)), 1);
  }
}

/// Two rectangles as a cage of quads, of which the mesh has one only.
TEST(MeasureFit, TellsWhatAProjectedMeshLacksAndHowFarItIsFromTheFacets) {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  cage.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  ModelInput input;
  input.model = model_from_cage(cage, {.scheme = Scheme::Bilinear});
  MeshFile mesh;
  std::vector<VertexHandle> v;
  for (const int i : {0, 1, 4, 3}) {
    v.push_back(mesh.mesh.add_vertex(to_openmesh(cage.points[static_cast<std::size_t>(i)])));
  }
  mesh.mesh.add_face(v[0], v[1], v[2]);
  mesh.mesh.add_face(v[0], v[2], v[3]);
  MeshCheck check = check_mesh({mesh_arrays(mesh.mesh), {}, {}});
  add_fit(check, measure_fit(mesh, input));
  const ModelFit& fit = *check.fit;
  ASSERT_TRUE(fit.from_surface && fit.facets);
  EXPECT_GT(fit.from_surface->max, 0.9);
  EXPECT_EQ(fit.distance.max, fit.from_surface->max);
  EXPECT_NEAR(fit.facets->to_facets.max, 0, 1e-15);
  EXPECT_DOUBLE_EQ(fit.facets->from_facets.max, 1);
  EXPECT_NEAR(fit.facets->from_facets.mean, 0.25, 1e-12);
  const Json json = Json::parse(to_json(check))["fit"];
  EXPECT_EQ(json["from_surface"]["max"], fit.from_surface->max);
  EXPECT_EQ(json["facets"]["from_facets"]["max_at"][0], 2);
  EXPECT_EQ(json["facets"]["to_facets"]["mean"], fit.facets->to_facets.mean);
  const std::string text = to_text(check);
  EXPECT_NE(text.find("of the surface from the mesh: greatest"), std::string::npos) << text;
  EXPECT_NE(text.find("), back 1 (0.25)"), std::string::npos) << text;
  EXPECT_NE(to_text(check, {.is_long = true}).find("from the faces of the input: greatest"),
            std::string::npos);
}

TEST(MeasureFit, FindsVerticesOffTheSurface) {
  MeshFile mesh = grid_on_patches();
  mesh.mesh.set_point(VertexHandle(4), {1, 1, 0.25});
  MeshCheck check = check_mesh({mesh_arrays(mesh.mesh), {}, {}});
  EXPECT_TRUE(check.faults.empty());
  add_fit(check, measure_fit(mesh, two_rectangles(1)));
  EXPECT_NEAR(check.fit->distance.max_corner, 0.25, 1e-12);
  ASSERT_EQ(check.faults.size(), 1u);
  EXPECT_EQ(check.faults[0].kind, "corner_off_surface");
}

TEST(MeasureFit, RefusesPatchesThatTheModelDoesNotHave) {
  MeshFile mesh = grid_on_patches();
  mesh.mesh.property(require(mesh.mesh, keys::face_patch), FaceHandle(5)) = 2;
  const std::string error = error_of([&] { measure_fit(mesh, two_rectangles(1)); });
  EXPECT_TRUE(error.starts_with("invalid input: ")) << error;
  EXPECT_NE(error.find("face 5 lies on patch 2, but the model has 2 patches, counted"),
            std::string::npos)
      << error;
}

TEST(CheckMeshJson, HoldsTheFit) {
  MeshFile mesh = grid_on_patches();
  MeshCheck check = check_mesh({mesh_arrays(mesh.mesh), {}, {}});
  EXPECT_TRUE(Json::parse(to_json(check))["fit"].is_null());
  add_fit(check, measure_fit(mesh, two_rectangles(1)));
  const Json json = Json::parse(to_json(check));
  EXPECT_TRUE(json["clean"]);
  EXPECT_EQ(json["fit"]["edges"]["count"], 16);
  EXPECT_EQ(json["fit"]["edges"]["mean"], check.fit->sizes.edges.mean);
  EXPECT_EQ(json["fit"]["distance"]["max"], 0);
  EXPECT_EQ(json["angles"]["max"], 90);
}

MeshCheck checked_grid() {
  MeshFile mesh = grid_on_patches();
  MeshCheck check = check_mesh({mesh_arrays(mesh.mesh), {}, {}});
  add_fit(check, measure_fit(mesh, two_rectangles(1)));
  return check;
}

TEST(CheckMeshText, TellsFaultsAndTheFit) {
  const std::string text = to_text(checked_grid());
  for (const char* part :
       {"9 vertices, 16 edges, 8 triangles", "open: 8 boundary edges in 1 loops",
        "by the (u,v) of the mesh", "faults    none\n          no faces pass through each other"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(CheckMeshText, HasTheHistogramsOfAReport) {
  const MeshCheck check = checked_grid();
  const std::string text = to_text(check);
  const std::string heading =
      "\nquality of triangles                     metric length of edges (1 is wanted)\n";
  EXPECT_NE(text.find(heading), std::string::npos) << text;
  EXPECT_EQ(text.find("angles of corners"), std::string::npos);
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 25);
  const std::string all = to_text(check, {.is_long = true});
  EXPECT_NE(all.find(heading), std::string::npos);
  EXPECT_NE(all.find("\n80 to 90 "), all.find("90 to 100 ")) << all;
  EXPECT_NE(all.find("\nshape of triangles in space              angles of corners (degrees)\n"),
            std::string::npos)
      << all;
}

TEST(CheckMeshText, ShowsShapesAndAnglesWithoutAMetric) {
  const MeshCheck check = check_mesh({mesh_arrays(grid_on_patches().mesh), {}, {}});
  const std::string text = to_text(check);
  EXPECT_NE(text.find("least 0.866, mean 0.866                  least 45.00, greatest 90.00\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("30 to 60            16  66.7 % ########\n"), std::string::npos) << text;
  for (const char c : text) EXPECT_GT(c, 0);
}

TEST(CheckMeshText, ShowsThatASagIsNotReached) {
  MeshCheck check = checked_grid();
  check.fit->sag = 0.5;
  EXPECT_NE(to_text(check).find("sag       0.5 asked for, kept\n"), std::string::npos);
  check.fit->distance.max = 0.75;
  EXPECT_NE(to_text(check).find("sag       0.5 asked for, NOT REACHED\n"), std::string::npos);
}

TEST(CheckMeshText, TellsMorePlacesInTheLongStyle) {
  MeshCheck check = checked_grid();
  check.faults = {{"duplicate_face", 12, {"a", "b", "c", "d", "e"}}};
  const std::string few = to_text(check), all = to_text(check, {.is_long = true});
  EXPECT_NE(few.find("            c\n            and 9 more\n"), std::string::npos) << few;
  EXPECT_NE(all.find("            e\n            and 7 more\n"), std::string::npos) << all;
}

// A border that is cut off has no face that is far from the surface.
TEST(CheckMesh, MeasuresBordersWithAndWithoutParameters) {
  ModelInput input;
  input.model = testing::square_with_hole(0.5);
  input.options.sizing.hmin = input.options.sizing.hmax = Length::units(0.8);
  const MeshResult result = mesh_model(input.model, {}, input.options);
  MeshFile with{result.mesh, mesh_names(input.model), {}, {}}, without = with;
  detach(without.mesh, keys::corner_uv);
  const ModelFit own = measure_fit(with, input, JudgedBy::StoredMetric, nullptr);
  const ModelFit projected = measure_fit(without, input, JudgedBy::ExactSizes, nullptr);
  EXPECT_TRUE(projected.is_projected);
  EXPECT_GT(own.distance.max, 0.01);
  EXPECT_NEAR(projected.distance.max, own.distance.max, 1e-4);
  EXPECT_EQ(own.max_contour, "hole");
  EXPECT_EQ(projected.max_contour, "hole");
}

}  // namespace
}  // namespace surfmesh
