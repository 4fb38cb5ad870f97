// SPDX-License-Identifier: BSD-3-Clause
// The circle of adaptation: a mesh, sizes at its vertices, and a mesh that follows them.
#include "cage/cages.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include "surfmesh/pipeline/mesh_model.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/formats/vtu_file.hh"
#include "surfmesh/metric/tensor.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/sizes/background_sizes.hh"

namespace surfmesh {
namespace {

using testing::units;

/// A metric in space at a point.
using MetricAt = std::function<Eigen::Matrix3d(const Vec3&)>;

/// Nothing from the shape.
PipelineOptions no_sizes() {
  PipelineOptions options;
  options.sizing = {.curvature = 0, .hmin = units(1e-3), .hmax = units(1)};
  options.sizing.proximity = 0;
  options.sizing.features = false;
  options.sizing.contour_curvature = false;
  return options;
}

/// How well edges have unit length in a metric that is known exactly.
struct Fit {
  double mean = 0;
  double unit_share = 0;  ///< from 1/√2 to √2
  std::size_t edges = 0;
};

Fit fit_of(const PolyMesh& mesh, const MetricAt& metric) {
  Fit fit;
  for (const auto edge : mesh.edges()) {
    const Vec3 a = to_eigen(mesh.point(edge.v0())), b = to_eigen(mesh.point(edge.v1()));
    const auto length = [&](const Vec3& p) { return std::sqrt((b - a).dot(metric(p) * (b - a))); };
    const double l = edge_length(length(a), length(b));
    fit.mean += l;
    fit.unit_share += l >= std::sqrt(0.5) && l <= std::sqrt(2.0) ? 1 : 0;
    ++fit.edges;
  }
  fit.mean /= static_cast<double>(fit.edges);
  fit.unit_share /= static_cast<double>(fit.edges);
  return fit;
}

MetricAt metric_of(const std::function<double(const Vec3&)>& size) {
  return [size](const Vec3& p) -> Eigen::Matrix3d {
    return Eigen::Matrix3d::Identity() / (size(p) * size(p));
  };
}

BackgroundMesh triangles_of(const PolyMesh& mesh) {
  const MeshArrays arrays = mesh_arrays(mesh, {}, ArrayParts::Faces);
  BackgroundMesh background;
  background.points = arrays.points;
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    const auto face = arrays.faces[f];
    background.triangles.push_back({face[0], face[1], face[2]});
  }
  return background;
}

Sources sources_of(const Model& model, BackgroundMesh mesh) {
  const auto sizes = std::make_shared<const BackgroundSizes>(std::move(mesh), BackgroundIn::Space);
  Sources sources;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    sources.fields.push_back(
        background_field(sizes, static_cast<int>(p), model.patches[p].surface));
  }
  return sources;
}

/// A mesh of the model with sizes 0.1 everywhere.
PolyMesh first_mesh(const Model& model, double size) {
  PipelineOptions options;
  options.sizing.size = units(size);
  return mesh_model(model, {}, options).mesh;
}

/// The mesh after so many circles.
PolyMesh adapted(const Model& model, const std::function<double(const Vec3&)>& size, int circles) {
  PolyMesh mesh = first_mesh(model, 0.1);
  for (int i = 0; i < circles; ++i) {
    BackgroundMesh background = triangles_of(mesh);
    for (const Vec3& p : background.points) background.sizes.push_back(size(p));
    const MeshResult result = mesh_model(model, sources_of(model, background), no_sizes());
    for (const Notice& notice : result.report.notices) {
      EXPECT_NE(notice.kind, NoticeKind::UnusedSource) << notice.text;
      EXPECT_NE(notice.kind, NoticeKind::UnsearchedSizes) << notice.text;
    }
    mesh = result.mesh;
  }
  return mesh;
}

/// A band of small sizes.
double band(const Vec3& p) { return 0.02 + 0.25 * std::abs(p.x() - 0.3); }

TEST(Background, IsFollowedInThePlane) {
  const Model model = testing::unit_square();
  const Fit fit = fit_of(adapted(model, band, 2), metric_of(band));
  EXPECT_NEAR(fit.mean, 1, 0.06);
  EXPECT_GT(fit.unit_share, 0.95);
}

TEST(Background, IsFollowedOnTheSphere) {
  const Model model = testing::model_of({testing::sphere()});
  const auto size = [](const Vec3& p) { return 0.03 + 0.1 * (p - Vec3(0, 0.6, 0.8)).norm(); };
  const Fit fit = fit_of(adapted(model, size, 2), metric_of(size));
  EXPECT_NEAR(fit.mean, 1, 0.06);
  EXPECT_GT(fit.unit_share, 0.95);
}

TEST(Background, IsFollowedOnACage) {
  const Model model = model_from_cage(testing::cube());
  const auto size = [](const Vec3& p) { return 0.04 + 0.15 * std::abs(p.z()); };
  const Fit fit = fit_of(adapted(model, size, 2), metric_of(size));
  EXPECT_NEAR(fit.mean, 1, 0.06);
  EXPECT_GT(fit.unit_share, 0.95);
}

PolyMesh adapted_to(const Model& model, const MetricAt& metric, int circles) {
  PolyMesh mesh = first_mesh(model, 0.05);
  for (int i = 0; i < circles; ++i) {
    BackgroundMesh background = triangles_of(mesh);
    for (const Vec3& p : background.points) {
      const Eigen::Matrix3d m = metric(p);
      background.metrics.push_back({m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)});
    }
    mesh = mesh_model(model, sources_of(model, background), no_sizes()).mesh;
  }
  return mesh;
}

/// Across a circle 0.02 and more, along it 0.1.
Eigen::Matrix3d ring(const Vec3& p) {
  const Vec3 out = Vec3(p.x() + 0.3, p.y() + 0.3, 0);
  const double h = 0.02 + 0.15 * std::abs(out.norm() - 0.9);
  const Vec3 n = out.normalized(), t(-n.y(), n.x(), 0);
  return n * n.transpose() / (h * h) + t * t.transpose() / 0.01 +
         Vec3::UnitZ() * Vec3::UnitZ().transpose();
}

TEST(Background, HasDirectionsInThePlane) {
  const Fit fit = fit_of(adapted_to(testing::unit_square(), ring, 2), ring);
  EXPECT_NEAR(fit.mean, 1, 0.06);
  EXPECT_GT(fit.unit_share, 0.93);
}

/// The same on a cylinder, along whose axis sizes are small in a band.
TEST(Background, HasDirectionsOnACylinder) {
  const auto metric = [](const Vec3& p) -> Eigen::Matrix3d {
    const double h = 0.02 + 0.15 * std::abs(p.z() - 0.5);
    return Eigen::Vector3d(100, 100, 1 / (h * h)).asDiagonal();
  };
  const Model model = testing::model_of({testing::cylinder(0, 2)});
  const Fit fit = fit_of(adapted_to(model, metric, 2), metric);
  EXPECT_NEAR(fit.mean, 1, 0.06);
  EXPECT_GT(fit.unit_share, 0.93);
}

/// A model file with a square, and a .vtu file beside it.
class BackgroundFile : public ::testing::Test {
 protected:
  void write_background(const std::vector<VtkValues>& values, double shift = 0) {
    const PolyMesh mesh = first_mesh(testing::unit_square(), 0.1);
    const MeshArrays arrays = mesh_arrays(mesh, {}, ArrayParts::Faces);
    VtkGrid grid{arrays.points, arrays.faces, values};
    for (Vec3& p : grid.points) p.x() += shift;
    for (VtkValues& all : grid.at_points) {
      std::vector<double> numbers;
      for (const Vec3& p : arrays.points) numbers.push_back(band(p));
      all.values = numbers;
    }
    OutputFile file(folder_ / "sizes.vtu");
    write_vtu(grid, VtuNumbers::Text, file);
    file.commit();
  }

  ModelInput load(const std::string& of_patch, const std::string& of_model = "") {
    write_text(folder_ / "m.json",
               R"({"patches": [{"name": "a", "surface": {"z": "0"}, "domain": {"u": [0, 1],
                "v": [0, 1]}, "sources": [)" +
                   of_patch + R"(]}], "sources": [)" + of_model +
                   R"(], "sizing": {"curvature": 0, "hmin": 0.001, "hmax": 1, "proximity": 0}})");
    return load_model(folder_ / "m.json");
  }

  std::string error(const std::string& of_patch, const std::string& of_model = "") {
    std::string text = error_of([&] { load(of_patch, of_model); });
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = text.find(folder); at != text.npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
    return text;
  }

  TestFolder folder_;
};

TEST_F(BackgroundFile, IsASourceOfTheModelAndOfAPatch) {
  write_background({{"h", 1, {}}});
  const Fit exact = fit_of(adapted(testing::unit_square(), band, 1), metric_of(band));
  for (const auto& [of_patch, of_model] : std::vector<std::pair<std::string, std::string>>{
           {R"({"background": "sizes.vtu"})", ""},
           {R"({"background": "sizes.vtu", "in": "uv", "precision": 0.2})", ""},
           {"", R"({"background": "sizes.vtu", "values": "h"})"},
           {"", R"({"background": "sizes.vtu", "in": "uv", "group": "a", "reach": 2})"}}) {
    const ModelInput input = load(of_patch, of_model);
    ASSERT_EQ(input.sources.fields.size(), 1u);
    EXPECT_EQ(input.files.size(), 2u);
    const MeshResult result = mesh_model(input.model, input.sources, input.options);
    const Fit fit = fit_of(result.mesh, metric_of(band));
    EXPECT_NEAR(fit.mean, exact.mean, 0.05) << of_patch << of_model;
    EXPECT_NEAR(double(fit.edges) / double(exact.edges), 1, 0.1) << of_patch << of_model;
  }
}

TEST_F(BackgroundFile, BesideTheModelIsTold) {
  write_background({{"h", 1, {}}}, 5);
  const auto notices = [&] {
    const ModelInput input = load("", R"({"background": "sizes.vtu"})");
    std::vector<std::string> texts;
    for (const Notice& n : mesh_model(input.model, input.sources, input.options).report.notices) {
      if (n.kind == NoticeKind::UnusedSource) texts.push_back(n.text);
    }
    return texts;
  };
  const std::string place = (folder_ / "m.json").string() + ": /sources/0: ";
  EXPECT_EQ(notices(),
            std::vector{place + "its patches lie beyond the background mesh; it has no effect"});
  write_background({{"h", 1, {}}}, 0.5);
  ASSERT_EQ(notices().size(), 1u);
  EXPECT_NE(notices()[0].find(" % of its patches lie beyond the background mesh"),
            std::string::npos);
}

TEST_F(BackgroundFile, IsRefusedWithItsPlaces) {
  write_background({{"h", 1, {}}, {"k", 1, {}}});
  const std::string patch = "invalid input: m.json: /patches/0/sources/0/";
  EXPECT_EQ(error(R"({"background": "no.vtu"})").substr(0, 74),
            patch + "background: cannot read no.vtu");
  EXPECT_EQ(error(R"({"background": "sizes.vtu"})"),
            patch + "background: sizes.vtu: it has several values, name one of them: it has h, k");
  EXPECT_EQ(
      error(R"({"background": "sizes.vtu", "values": "hh"})"),
      patch +
          "background: sizes.vtu: it has no values hh at its points, did you mean h? it has h, k");
  EXPECT_EQ(error(R"({"background": "sizes.vtu", "in": "xyz"})"),
            patch + "in: must be \"space\" or \"uv\"");
  EXPECT_EQ(error(R"({"background": "sizes.vtu", "values": "h", "reach": 0})"),
            patch + "reach: must be above 0");
  EXPECT_EQ(error(R"({"background": "sizes.vtu", "size": 0.1})"),
            patch + "size: a background mesh has no size");
  EXPECT_EQ(error(R"({"everywhere": true, "size": 0.1, "values": "h"})"),
            patch + "values: what is no background mesh has no values");
  EXPECT_EQ(error("", R"({"background": "sizes.vtu", "values": "h", "in": "uv"})"),
            "invalid input: m.json: /sources/0/in: u and v are those of one patch: name it by "
            "`group`, or put the source among those of the patch");
  write_text(folder_ / "sizes.vtu", "<VTKFile type=\"UnstructuredGrid\">");
  EXPECT_EQ(error(R"({"background": "sizes.vtu"})"),
            patch + "background: sizes.vtu:1: the XML is broken: no element found");
}

}  // namespace
}  // namespace surfmesh
