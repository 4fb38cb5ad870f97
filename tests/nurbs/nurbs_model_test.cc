// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "support/expect_valid.hh"
#include "support/notices.hh"
#include "support/nurbs_nets.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/nurbs/nurbs_curve.hh"
#include "surfmesh/nurbs/split_at_creases.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using testing::sphere_net;

/// Sizes from curvature as the example of a sphere has them.
PipelineOptions fine() {
  PipelineOptions options;
  options.sizing.curvature = 0.2;
  return options;
}

MeshResult mesh_of(const Model& model) {
  MeshResult result = mesh_model(model, {}, fine());
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  EXPECT_EQ(texts_of(result.report.notices, Severity::Warning), std::vector<std::string>{});
  EXPECT_GT(result.report.quality.min, 0.1);
  return result;
}

Model model_of_pieces(const NurbsNet& net) {
  std::vector<PatchInput> patches;
  for (const NurbsPiece& piece : split_at_creases(net, knot_domain(net))) {
    patches.push_back({std::string("p").append(std::to_string(patches.size())), piece.surface});
  }
  return model_from_patches(patches);
}

double triangle_count(const MeshResult& result) {
  return static_cast<double>(result.mesh.n_faces());
}

TEST(NurbsModel, HasAsManyTrianglesAsTheSameSphereOfFormulas) {
  const MeshResult nurbs = mesh_of(model_of_pieces(sphere_net()));
  const MeshResult formulas = mesh_of(model_from_patches(
      {{"sphere",
        std::make_shared<FormulaSurface>(
            SurfaceFormulas{"cos(v)*cos(u)", "cos(v)*sin(u)", "sin(v)"},
            Domain{0, 2 * std::numbers::pi, -std::numbers::pi / 2, std::numbers::pi / 2})}}));
  EXPECT_NEAR(triangle_count(nurbs) / triangle_count(formulas), 1, 0.05);
  EXPECT_EQ(nurbs.report.mesh.euler, 2);
}

TEST(NurbsModel, HasItsVerticesOnTheSphere) {
  const MeshResult sphere = mesh_of(model_of_pieces(sphere_net()));
  for (const auto vertex : sphere.mesh.vertices()) {
    EXPECT_NEAR(to_eigen(sphere.mesh.point(vertex)).norm(), 1, 1e-14);
  }
}

/// A roof with its ridge at x = 1, of this degree.
NurbsNet roof(int degree) {
  if (degree == 1) {
    return testing::strip_net(1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {1, 0, 1}, {2, 0, 0}});
  }
  return testing::strip_net(2, {0, 0, 0, 1, 1, 2, 2, 2},
                            {{0, 0, 0}, {0.5, 0, 0.2}, {1, 0, 1}, {1.5, 0, 0.2}, {2, 0, 0}});
}

TEST(NurbsModel, IsNotCutThroughAtACrease) {
  for (const int degree : {1, 2}) {
    const Model model = model_of_pieces(roof(degree));
    EXPECT_EQ(model.patches.size(), 2u);
    const MeshResult mesh = mesh_of(model);
    for (const auto face : mesh.mesh.faces()) {
      double least = 2, most = 0;
      for (const auto vertex : face.vertices()) {
        least = std::min(least, to_eigen(mesh.mesh.point(vertex)).x());
        most = std::max(most, to_eigen(mesh.mesh.point(vertex)).x());
      }
      EXPECT_TRUE(most <= 1 + 1e-12 || least >= 1 - 1e-12);
    }
  }
}

TEST(NurbsModel, IsOnePatchWhereKnotsAreSmooth) {
  const NurbsNet net =
      testing::wavy_net(2, 2, testing::clamped_knots(2, 3), testing::clamped_knots(2, 2));
  const Model model = model_of_pieces(net);
  EXPECT_EQ(model.patches.size(), 1u);
  mesh_of(model);
}

TEST(NurbsModel, HasKnotsAsPartsOfItsContours) {
  const NurbsNet net =
      testing::wavy_net(2, 2, testing::clamped_knots(2, 4, 2), testing::clamped_knots(2, 3));
  const Model model = model_of_pieces(net);
  const int side = find_contour(model, "p0:v0");
  ASSERT_GE(side, 0);
  EXPECT_EQ(model.contour(side).breaks, (std::vector<double>{0.0625, 0.25, 0.5625}));
}

/// A torus of smooth periodic curves, without a seam that shows.
NurbsNet ring() {
  NurbsNet net{{3, 3}, {{{0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 2, 3, 4, 5}}}, {}, {}, {{true, true}}};
  for (int j = 0; j < 5; ++j) {
    const double b = 2 * std::numbers::pi * j / 5;
    std::vector<Vec3>& row = net.points.emplace_back();
    for (int i = 0; i < 8; ++i) {
      const double a = std::numbers::pi * i / 4, r = 3 + std::cos(b);
      row.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  }
  return net;
}

TEST(NurbsModel, ClosesWhereItIsPeriodic) {
  const MeshResult mesh = mesh_of(model_of_pieces(ring()));
  EXPECT_EQ(mesh.report.mesh.euler, 0);
  EXPECT_TRUE(mesh.report.mesh.is_closed);
}

/// The square from (0,0) to (6,6) with a hole; the polygon runs counter-clockwise.
Model plate_with_hole(const NurbsPolygon& polygon) {
  NurbsNet net = testing::strip_net(1, {0, 0, 6, 6}, {{0, 0, 0}, {6, 0, 0}});
  net.knots[1] = {0, 0, 6, 6};
  for (Vec3& point : net.points[1]) point.y() = 6;
  const auto curve = std::make_shared<NurbsCurve>(polygon);
  const PatchInput plate{"plate",
                         std::make_shared<NurbsSurface>(net),
                         {{"plate:v0", "plate:u1", "-plate:v1", "-plate:u0"}, {"-hole"}}};
  return model_from_patches({plate},
                            {{"hole", nullptr, {{"plate", curve}}, {}, {}, curve->breaks()}});
}

TEST(NurbsModel, IsTrimmedByCurvesOfKnots) {
  const double h = std::numbers::sqrt2 / 2;
  const Model model =
      plate_with_hole({2,
                       {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                       {{4, 3}, {4, 4}, {3, 4}, {2, 4}, {2, 3}, {2, 2}, {3, 2}, {4, 2}, {4, 3}},
                       {1, h, 1, h, 1, h, 1, h, 1}});
  EXPECT_EQ(model.contour(find_contour(model, "hole")).breaks.size(), 3u);
  EXPECT_EQ(mesh_of(model).report.mesh.euler, 0);
}

TEST(NurbsModel, HasCornersWhereATrimHasKinks) {
  const int corners = 60;
  NurbsPolygon star{1, {0}, {}};
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i % corners) / corners;
    const double radius = i % 2 == 0 ? 2 : 2.3;
    star.points.push_back({3 + radius * std::cos(angle), 3 + radius * std::sin(angle)});
    star.knots.push_back(i);
  }
  star.knots.push_back(corners);
  const Model model = plate_with_hole(star);
  int parts = 0;
  for (const Contour& contour : model.contours) parts += contour.name.starts_with("hole#") ? 1 : 0;
  EXPECT_EQ(parts, corners);
}

}  // namespace
}  // namespace surfmesh
