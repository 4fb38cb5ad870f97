// SPDX-License-Identifier: BSD-3-Clause
#include "cage/cages.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include "surfmesh/pipeline/mesh_model.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh {
namespace {

using testing::model_of;

Size isotropic_size(double size) { return {Length::units(size), Length::units(size), 0}; }

/// One size everywhere, nothing from curvature.
MeshResult mesh_with_size(const Model& model, double size) {
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmin = Length::units(size), .hmax = Length::units(size)};
  return mesh_model(model, {}, options);
}

Model wave() {
  return model_of({make_callable_surface({-6, 6, -6, 6}, [](auto u, auto v) {
    return std::array{u, v, 1.5 * sin(2 * u) * cos(v / 5) * exp(-(u * u + v * v) / 1000)};
  })});
}

/// The same wave over parameters that are multiplied by u_scale and v_scale.
Model scaled_wave(double u_scale, double v_scale) {
  return model_of({make_callable_surface(
      {-6 * u_scale, 6 * u_scale, -6 * v_scale, 6 * v_scale}, [=](auto s, auto t) {
        const auto u = s / u_scale, v = t / v_scale;
        return std::array{u, v, 1.5 * sin(2 * u) * cos(v / 5) * exp(-(u * u + v * v) / 1000)};
      })});
}

/// Points, faces and corner properties, for comparison bit by bit.
std::vector<double> values_of(const PolyMesh& mesh) {
  std::vector<double> values;
  const auto uv = require(mesh, keys::corner_uv);
  const auto metric = require(mesh, keys::corner_metric);
  for (const VertexHandle vh : mesh.vertices()) {
    for (std::size_t k = 0; k < 3; ++k) values.push_back(mesh.point(vh)[k]);
  }
  for (const FaceHandle fh : mesh.faces()) {
    for (const auto heh : mesh.fh_range(fh)) {
      values.push_back(mesh.to_vertex_handle(heh).idx());
      for (const double x : {mesh.property(uv, heh).u, mesh.property(uv, heh).v,
                             mesh.property(metric, heh).m11, mesh.property(metric, heh).m12}) {
        values.push_back(x);
      }
    }
  }
  return values;
}

TEST(MeshModel, FillsAPlaneSquareWithTrianglesOfOneSize) {
  const MeshResult result = mesh_with_size(testing::unit_square(), 0.03);
  testing::expect_valid(result.mesh);
  const double ideal = 1 / (0.25 * std::numbers::sqrt3 * 0.03 * 0.03);
  EXPECT_NEAR(static_cast<double>(result.mesh.n_faces()) / ideal, 1, 0.05);
  EXPECT_GT(result.report.quality.mean, 0.98);
  EXPECT_GT(result.report.edges.unit_fraction, 0.999);
  EXPECT_LT(result.report.edges.stddev, 0.06);
}

TEST(MeshModel, HasOneLengthEverywhereAndTellsWhatHasNoEffectBeside) {
  PipelineOptions options;
  options.sizing.size = Length::units(0.5);
  const Report report = mesh_model(wave(), {}, options).report;
  EXPECT_TRUE(report.notices.empty());
  EXPECT_GT(report.edges.mean, 0.95);
  EXPECT_LT(report.edges.mean, 1.05);
  options.sizing.hmax = Length::units(0.1);
  options.sizing.curvature = 0.1;
  const Report told = mesh_model(wave(), {}, options).report;
  EXPECT_EQ(texts_of(told.notices), (std::vector<std::string>{"curvature has no effect beside size",
                                                              "hmax has no effect beside size"}));
  EXPECT_EQ(told.mesh.triangles, report.mesh.triangles);
}

TEST(MeshModel, TellsOfWaysToQuadsThatHaveNoEffect) {
  PipelineOptions options;
  options.sizing.size = Length::units(1);
  options.quads = {.is_on = false, .method = QuadMethod::Frontal, .front = QuadFront::LeeLo};
  EXPECT_EQ(texts_of(mesh_model(wave(), {}, options).report.notices),
            std::vector<std::string>{"quad_method has no effect without quads"});
  options.quads = {.is_on = true, .front = QuadFront::LeeLo};
  EXPECT_EQ(texts_of(mesh_model(wave(), {}, options).report.notices),
            std::vector<std::string>{"quad_front has no effect without quad_method = frontal"});
  options.quads.method = QuadMethod::Frontal;
  EXPECT_TRUE(mesh_model(wave(), {}, options).report.notices.empty());
}

TEST(MeshModel, TellsOfSmoothingThatHasNoEffect) {
  PipelineOptions options;
  options.sizing.size = Length::units(1);
  options.improve = {.smoothing = Smoothing::Off, .sweeps = 5};
  options.control.reuse = 0.5;
  options.refine.conformity = 0.3;
  EXPECT_EQ(texts_of(mesh_model(wave(), {}, options).report.notices),
            (std::vector<std::string>{"conformity has no effect without placement = circumcentre",
                                      "sweeps has no effect without smoothing",
                                      "reuse answers no question without smoothing = element"}));
  options.improve.smoothing = sweeps_of(3);
  options.refine.placement = Placement::Circumcentre;
  EXPECT_EQ(texts_of(mesh_model(wave(), {}, options).report.notices),
            (std::vector<std::string>{"sweeps has no effect beside smoothing = 3",
                                      "reuse answers no question without smoothing = element"}));
  options.improve.smoothing = Smoothing::Element;
  EXPECT_TRUE(mesh_model(wave(), {}, options).report.notices.empty());
  options.quads.is_on = true;
  EXPECT_EQ(texts_of(mesh_model(wave(), {}, options).report.notices),
            (std::vector<std::string>{
                "placement has no effect on quads", "conformity has no effect on quads",
                "smoothing has no effect on quads", "sweeps has no effect on quads",
                "reuse answers no question on quads"}));
}

TEST(MeshModel, HasAsManyRegularNodesAsAskedFor) {
  PipelineOptions options;
  options.sizing = {.hmax = Length::units(1)};  // more than ten times their distance
  options.control.regular_nodes = 10'000;
  for (const double grade : {0.0, 1.5}) {
    options.sizing.grade = grade;
    EXPECT_EQ(mesh_model(wave(), {}, options).report.control.nodes, 10'000U);
  }
}

/// In a plane whose sizes grow along it.
TEST(MeshModel, AsksNoMoreWithReuse) {
  const Model plane = model_of({make_callable_surface({0, 10, 0, 10}, [](auto u, auto v) {
    return std::array{u, v, 0 * u};
  })});
  Sources sources;
  sources.fields.push_back(
      {.patch = 0, .size = [](Uv uv, const Vec3&) { return 0.2 + 0.05 * uv.u; }});
  PipelineOptions options;
  options.sizing = {.curvature = 0, .grade = 0};
  options.control.kind = ControlKind::Mesh;
  options.refine.placement = Placement::Circumcentre;
  options.improve = {.smoothing = Smoothing::Element, .repairs = 0};
  const PerStage<QueryCounts> without = mesh_model(plane, sources, options).report.control.queries;
  for (const double reuse : {0.1, 0.2, 0.5, 0.55, 0.6}) {
    options.control.reuse = reuse;
    const PerStage<QueryCounts> with = mesh_model(plane, sources, options).report.control.queries;
    for (const Stage stage : {Stage::Boundary, Stage::Triangulate, Stage::Refine}) {
      EXPECT_EQ(with[stage], without[stage]) << reuse;
    }
    const QueryCounts& improve = with[Stage::Improve];
    EXPECT_LE(improve.total() - improve.reused, without[Stage::Improve].total()) << reuse;
    // Vertices come to rest at other places, in a few more moves or fewer.
    EXPECT_LT(static_cast<double>(improve.total()),
              1.02 * static_cast<double>(without[Stage::Improve].total()));
  }
  const QueryCounts last = mesh_model(plane, sources, options).report.control.queries.sum();
  EXPECT_GT(static_cast<double>(last.reused), 0.2 * static_cast<double>(last.total()));
}

TEST(MeshModel, ConvertsTrianglesToQuads) {
  PipelineOptions options;
  options.sizing.size = Length::units(0.5);
  options.quads = {.is_on = true, .method = QuadMethod::Frontal};
  const MeshResult result = mesh_model(wave(), {}, options);
  EXPECT_EQ(result.report.mesh.triangles, 0U);
  EXPECT_EQ(result.report.mesh.quads, result.mesh.n_faces());
  EXPECT_GT(result.report.edges.unit_fraction, 0.95);
  EXPECT_GT(result.report.seconds[Stage::Improve], 0);
  EXPECT_GT(result.report.seconds[Stage::Quad], 0);
}

TEST(MeshModel, ReachesGoodFiguresOnTheWave) {
  PipelineOptions options;
  options.sizing = {.curvature = 0.15, .hmax = Length::units(1), .stretch = 5};
  const MeshResult result = mesh_model(wave(), {}, options);
  testing::expect_valid(result.mesh);
  EXPECT_NEAR(result.report.edges.mean, 1, 0.05);
  EXPECT_GT(result.report.edges.unit_fraction, 0.97);
  EXPECT_GT(result.report.quality.mean, 0.95);
  EXPECT_GT(result.report.quality.min, 0.3);
}

TEST(MeshModel, ReportsItsMesh) {
  const MeshResult result = mesh_with_size(testing::torus_of(2), 0.3);
  EXPECT_EQ(result.report.mesh.vertices, result.mesh.n_vertices());
  EXPECT_EQ(result.report.mesh.triangles, result.mesh.n_faces());
  EXPECT_EQ(result.report.mesh.patches, 2u);
  EXPECT_TRUE(result.report.mesh.is_closed);
  EXPECT_EQ(result.report.mesh.euler, 0);
  EXPECT_EQ(result.report.edges.count, result.mesh.n_edges());
  EXPECT_GT(result.report.control.queries[Stage::Refine].total(), 0u);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
}

TEST(MeshModel, PutsVerticesOnTheSurface) {
  const MeshResult result = mesh_with_size(testing::torus_of(1), 0.2);
  for (const VertexHandle vh : result.mesh.vertices()) {
    const Vec3 p = to_eigen(result.mesh.point(vh));
    EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()), 0.7, 1e-12);
  }
}

/// Number of triangles with a corner within `radius` of a point of the plane.
std::size_t count_near(const PolyMesh& mesh, const Vec3& centre, double radius) {
  std::size_t count = 0;
  for (const FaceHandle fh : mesh.faces()) {
    for (const VertexHandle vh : mesh.fv_range(fh)) {
      if ((to_eigen(mesh.point(vh)) - centre).norm() > radius) continue;
      ++count;
      break;
    }
  }
  return count;
}

TEST(MeshModel, RefinesAtAPoint) {
  const Model model = testing::unit_square();
  Sources sources;
  sources.everywhere.push_back({0, isotropic_size(0.1)});
  const PolyMesh coarse = mesh_model(model, sources).mesh;
  sources.at.push_back({0, {0.3, 0.4}, isotropic_size(0.01)});
  const PolyMesh fine = mesh_model(model, sources).mesh;
  EXPECT_GT(count_near(fine, {0.3, 0.4, 0}, 0.05), 5 * count_near(coarse, {0.3, 0.4, 0}, 0.05));
  EXPECT_LT(count_near(fine, {1, 1, 0}, 0.1), 2 * count_near(coarse, {1, 1, 0}, 0.1) + 2);
}

TEST(MeshModel, TakesTheSizeOfOnePatchOnly) {
  Sources sources;
  sources.everywhere.push_back({1, isotropic_size(0.05)});
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmax = Length::units(0.3), .grade = 0};
  const PolyMesh mesh = mesh_model(testing::opposite_squares(), sources, options).mesh;
  const auto patch = require(mesh, keys::face_patch);
  std::array<int, 2> count{};
  for (const FaceHandle fh : mesh.faces())
    ++count.at(static_cast<std::size_t>(mesh.property(patch, fh)));
  EXPECT_GT(count[1], 5 * count[0]);
}

TEST(MeshModel, IsAsGoodAtUnequalScalesOfTheParameters) {
  PipelineOptions options;
  options.sizing = {.curvature = 0.15, .hmax = Length::units(1), .stretch = 5};
  const Report equal = mesh_model(wave(), {}, options).report;
  const Report scaled = mesh_model(scaled_wave(1e6, 1e-3), {}, options).report;
  const auto count = static_cast<double>(equal.mesh.triangles);
  EXPECT_NEAR(static_cast<double>(scaled.mesh.triangles), count, 0.03 * count);
  EXPECT_NEAR(scaled.quality.mean, equal.quality.mean, 0.01);
  EXPECT_NEAR(scaled.edges.stddev, equal.edges.stddev, 0.01);
}

TEST(MeshModel, IsAsGoodAtAnyScaleOfSpace) {
  const auto torus = std::make_shared<test::Torus>(2, 0.7, Domain{0, 6.283185307179586, 0, 3});
  const Report unit = mesh_model(model_of({torus})).report;
  for (const double scale : {1e-6, 1e6}) {
    const auto placed = std::make_shared<test::Placed>(torus, scale, Vec3::Zero());
    const Report report = mesh_model(model_of({placed})).report;
    const auto count = static_cast<double>(unit.mesh.triangles);
    EXPECT_NEAR(static_cast<double>(report.mesh.triangles), count, 0.03 * count);
    EXPECT_NEAR(report.quality.mean, unit.quality.mean, 0.01);
  }
}

TEST(MeshModel, IsTheSameTwiceBitByBit) {
  for (const Model& model : {wave(), testing::sphere_of(2), model_from_cage(testing::cube())}) {
    EXPECT_EQ(values_of(mesh_model(model).mesh), values_of(mesh_model(model).mesh));
  }
}

struct NamedModel {
  const char* name;
  Model model;
};

void PrintTo(const NamedModel& named, std::ostream* out) { *out << named.name; }

class HugeSize : public ::testing::TestWithParam<NamedModel> {};

TEST_P(HugeSize, StillMakesAClosedMesh) {
  const Model& model = GetParam().model;
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmax = Length::units(1000)};
  const MeshResult coarse = mesh_model(model, {}, options);
  testing::expect_valid(coarse.mesh);
  EXPECT_TRUE(coarse.report.mesh.is_closed);
  EXPECT_EQ(coarse.report.mesh.euler, mesh_model(model).report.mesh.euler);
}

INSTANTIATE_TEST_SUITE_P(
    Models, HugeSize,
    ::testing::Values(NamedModel{"Torus", testing::torus_of(1)},
                      NamedModel{"HalfTori", testing::torus_of(2)},
                      NamedModel{"Sphere", testing::sphere_of(1)},
                      NamedModel{"HalfSpheres", testing::sphere_of(2)},
                      NamedModel{"CubeCage", model_from_cage(testing::cube())},
                      NamedModel{"TorusCage", model_from_cage(testing::torus())},
                      NamedModel{"SmallTorusCage", model_from_cage(testing::torus(3, 3))},
                      NamedModel{"TetrahedronCage", model_from_cage(testing::tetrahedron())},
                      NamedModel{"PrismCage", model_from_cage(testing::pentagon_prism())}),
    [](const auto& test) { return std::string(test.param.name); });

class Recorder : public Observer {
 public:
  explicit Recorder(int cancel_after = -1) : cancel_after_(cancel_after) {}

  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    EXPECT_LE(done, total);
    stages.insert(std::string(stage));
    if (done == total) finished.insert(std::string(stage));
    ++calls_;
  }
  bool is_cancelled() override { return cancel_after_ >= 0 && calls_ > cancel_after_; }

  std::set<std::string> stages, finished;

 private:
  int cancel_after_;
  int calls_ = 0;
};

TEST(MeshModelObserver, IsToldOfEveryStage) {
  Recorder recorder;
  mesh_model(testing::torus_of(2), {}, {}, &recorder);
  EXPECT_EQ(recorder.stages, (std::set<std::string>{"across", "assemble", "boundary", "control",
                                                    "estimate", "mesh"}));
  EXPECT_EQ(recorder.finished, recorder.stages);
}

TEST(MeshModelObserver, CanCancelAtAnyTime) {
  for (const int calls : {0, 1, 3, 6}) {
    Recorder recorder(calls);
    EXPECT_EQ(error_of([&] { mesh_model(testing::torus_of(2), {}, {}, &recorder); }),
              "cancelled: the run was cancelled");
  }
}

TEST(MeshModelError, TellsOfAnEmptyModel) {
  EXPECT_EQ(error_of([] { mesh_model({}); }).substr(0, 13), "invalid input");
}

TEST(MeshModelError, NamesThePatchAndThePlaceOfASurfaceThatIsNotFinite) {
  Model model = testing::unit_square();
  // Not a number in a disc, so that the sides are good.
  model.patches[0].surface = make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
    const auto x = u - 0.5, y = v - 0.5;
    return std::array{u, v, 0 * sqrt(x * x + y * y - 0.04)};
  });
  const std::string error = error_of([&] { mesh_model(model); });
  EXPECT_EQ(error.substr(0, 19), "geometry: patch p0:") << error;
  EXPECT_NE(error.find("(u,v)"), std::string::npos) << error;
}

TEST(MeshModelError, TellsThatNormalsAreAskedForTooLate) {
  const TestFolder folder;
  MeshResult result = mesh_model(testing::unit_square());
  result.report.options.output.uv = true;  // parameters are always there
  write_mesh(result, folder / "a.obj");
  EXPECT_NE(read_text(folder / "a.obj").find("\nvt "), std::string::npos);
  result.report.options.output.normals = true;
  EXPECT_EQ(error_of([&] { write_mesh(result, folder / "a.obj"); }),
            "missing property: the mesh has no normals of its corners (surf:normal): "
            "output.normals is an option of mesh_model, and is set too late here");
}

TEST(MeshModelError, TellsOfBadOptionsFirst) {
  PipelineOptions options;
  options.max_elements = 0;
  EXPECT_EQ(error_of([&] { mesh_model({}, {}, options); }).substr(0, 14), "invalid option");
}

TEST(MeshModelError, EndsAtTheLimitOfAllPatchesTogether) {
  PipelineOptions options;
  const Model model = testing::torus_of(4);
  options.max_elements = mesh_model(model).mesh.n_faces() / 2;
  EXPECT_EQ(error_of([&] { mesh_model(model, {}, options); }).substr(0, 5), "limit");
}

TEST(MeshModelError, TellsAnHminThatFitsTheLimit) {
  const Model model = testing::model_of({testing::paper_wave()});
  PipelineOptions options;
  options.sizing = testing::paper_sizing();
  options.max_elements = 3000;
  const std::string error = error_of([&] { mesh_model(model, {}, options); });
  EXPECT_NE(error.find("more than max_elements = 3000"), std::string::npos) << error;
  const std::size_t at = error.find("hmin = ");
  ASSERT_NE(at, std::string::npos) << error;
  options.sizing.hmin = Length::units(std::stod(error.substr(at + 7)));
  const MeshResult result = mesh_model(model, {}, options);
  EXPECT_LE(result.report.mesh.triangles, 3000u);
  EXPECT_GT(result.report.mesh.triangles, 1000u);
}

TEST(MeshModelError, RefusesHopelessSizesBeforeTheControlSpace) {
  PipelineOptions options;
  options.sizing = {.hmin = Length::units(1e-6), .hmax = Length::units(1e-5)};
  const Model model = testing::model_of({testing::paper_wave()});
  Recorder recorder;
  const std::string error = error_of([&] { mesh_model(model, {}, options, &recorder); });
  EXPECT_NE(error.find("about 6.1e+12 triangles"), std::string::npos) << error;
  EXPECT_TRUE(recorder.stages.empty());
}

TEST(MeshModel, HasElementsLargerThanFacesOnBlocks) {
  const Cage cage = testing::torus(24, 16);
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmax = Length::units(1)};
  options.across.is_on = false;
  const MeshResult faces =
      mesh_model(model_from_cage(cage, {.patches = PatchKind::Faces}), {}, options);
  const MeshResult blocks = mesh_model(model_from_cage(cage), {}, options);
  testing::expect_valid(blocks.mesh);
  EXPECT_TRUE(blocks.report.mesh.is_closed);
  EXPECT_EQ(blocks.report.mesh.euler, 0);
  EXPECT_GE(faces.report.mesh.triangles, 2 * cage.faces.size());
  EXPECT_LT(blocks.report.mesh.triangles, cage.faces.size());
  EXPECT_GT(blocks.report.quality.min, 0.5);
}

TEST(MeshModel, IsNotFlatOnATubeThinnerThanItsElements) {
  PipelineOptions options;
  options.sizing = {.curvature = 0.25, .hmin = Length::units(0.5), .hmax = Length::units(2)};
  const MeshResult result = mesh_model(model_from_cage(testing::tube(6, 12, 0.1)), {}, options);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(result.report.mesh.euler, 0);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty())
      << texts_of(result.report.notices, Severity::Shortfall).front();
}

struct NamedCage {
  const char* name;
  Cage cage;
};

void PrintTo(const NamedCage& named, std::ostream* out) { *out << named.name; }

/// Cages with extraordinary vertices of valence 3, 4, 5 and 6 (after refinement).
std::vector<NamedCage> extraordinary_cages() {
  return {{"Cube", testing::cube()},
          {"Tetrahedron", testing::tetrahedron()},
          {"Octahedron", testing::octahedron()},
          {"Icosahedron", testing::icosahedron()},
          {"Prism5", testing::prism(5)},
          {"Prism6", testing::prism(6)},
          {"Prism8", testing::prism(8)}};
}

class Extraordinary : public ::testing::TestWithParam<NamedCage> {
 protected:
  static Model model(int level) {
    return model_from_cage(GetParam().cage,
                           {.scheme = Scheme::CatmullClark, .approximation_level = level});
  }
};

TEST_P(Extraordinary, GivesAClosedMesh) {
  const MeshResult result = mesh_model(model(8));
  testing::expect_valid(result.mesh);
  EXPECT_TRUE(result.report.mesh.is_closed);
  EXPECT_EQ(result.report.mesh.euler, 2);
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Warning).empty());
  EXPECT_TRUE(texts_of(result.report.notices, Severity::Shortfall).empty());
}

TEST_P(Extraordinary, HasAsManyTrianglesAtAnyLevelOfApproximation) {
  const auto coarse = static_cast<double>(mesh_model(model(6)).mesh.n_faces());
  const auto fine = static_cast<double>(mesh_model(model(8)).mesh.n_faces());
  EXPECT_NEAR(coarse, fine, 0.1 * fine);
}

TEST_P(Extraordinary, HasAsManyTrianglesWithHalfOfTheLeastSize) {
  PipelineOptions options;
  const auto before = static_cast<double>(mesh_model(model(8), {}, options).mesh.n_faces());
  options.sizing.hmin = Length::share(0.5 * options.sizing.least_size().value);
  const auto after = static_cast<double>(mesh_model(model(8), {}, options).mesh.n_faces());
  EXPECT_NEAR(after, before, 0.1 * before);
}

INSTANTIATE_TEST_SUITE_P(Cages, Extraordinary, ::testing::ValuesIn(extraordinary_cages()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace surfmesh
