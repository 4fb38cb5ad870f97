// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/fit_cage.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "cage/meshes.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/surface_waves.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

constexpr CageOptions kInterpolate = {.surface = SurfaceKind::Interpolate};

/// The notice of a kind, which there is once.
Notice only(const Notices& notices, NoticeKind kind) {
  const auto is_meant = [&](const Notice& notice) { return notice.kind == kind; };
  EXPECT_EQ(std::count_if(notices.begin(), notices.end(), is_meant), 1) << name(kind);
  const auto found = std::find_if(notices.begin(), notices.end(), is_meant);
  return found == notices.end() ? Notice() : *found;
}

bool mentions(const Notice& notice, const std::string& text) {
  return notice.text.find(text) != std::string::npos;
}

TEST(FitCage, MakesTheModelPassThroughThePoints) {
  const Cage mesh = testing::sphere_mesh(2);
  const Model model = model_from_cage(mesh, kInterpolate);
  ASSERT_EQ(model.fits.size(), 1U);
  EXPECT_EQ(model.fits[0].vertices, mesh.points.size());
  EXPECT_LT(model.fits[0].distance, 1e-12);
  EXPECT_GT(model.fits[0].greatest_move, 0.001);
  for (const ModelVertex& vertex : model.vertices) EXPECT_NEAR(vertex.position.norm(), 1, 1e-5);
  EXPECT_TRUE(model.notices.empty());
  EXPECT_EQ(model.made_with, (std::vector<MadeWith>{{"surface", "interpolate"}}));
}

TEST(FitCage, LeavesTheBoxThatOfTheGivenPoints) {
  const Cage mesh = testing::sphere_mesh(2);
  EXPECT_EQ(model_from_cage(mesh, kInterpolate).diagonal, diagonal(mesh));
}

TEST(FitCage, LeavesCagesAsTheyAre) {
  const Model model = model_from_cage(testing::icosahedron());
  EXPECT_TRUE(model.fits.empty());
  EXPECT_TRUE(model.notices.empty());
  EXPECT_LT(model.vertices[0].position.norm(), 0.9 * testing::icosahedron().points[0].norm());
}

TEST(FitCage, TellsWhyAMeshIsTakenForOne) {
  const Model model = model_from_cage(testing::sphere_mesh(3));
  ASSERT_EQ(model.fits.size(), 1U);
  const Notice notice = only(model.notices, NoticeKind::ChosenSurface);
  EXPECT_EQ(notice.severity, Severity::Information);
  EXPECT_TRUE(mentions(notice, "1280 faces")) << notice.text;
  EXPECT_TRUE(mentions(notice, "surface = limit")) << notice.text;
  const Model limit = model_from_cage(testing::sphere_mesh(3), {.surface = SurfaceKind::Limit});
  EXPECT_TRUE(limit.fits.empty());
  EXPECT_TRUE(limit.notices.empty());
}

/// Where triangles are too few for a mesh, or too steep, what became of them is told, too.
TEST(FitCage, TellsThatTrianglesAreTakenForACage) {
  const Model model = model_from_cage(testing::sphere_mesh(2));
  EXPECT_TRUE(model.fits.empty());
  const Notice notice = only(model.notices, NoticeKind::ChosenSurface);
  EXPECT_EQ(notice.severity, Severity::Information);
  EXPECT_TRUE(mentions(notice, "surface = interpolate")) << notice.text;
  EXPECT_TRUE(
      model_from_cage(testing::sphere_mesh(2), {.surface = SurfaceKind::Limit}).notices.empty());
  // Who names the scheme knows that it is a cage.
  EXPECT_TRUE(model_from_cage(testing::sphere_mesh(2), {.scheme = Scheme::Loop}).notices.empty());
}

TEST(FitCage, MakesCreasesOfSharpEdges) {
  const Model model = model_from_cage(testing::cylinder_mesh(40), kInterpolate);
  EXPECT_EQ(model.fits[0].creases, 80U);
  EXPECT_EQ(model.fits[0].wavy_share, 0);
  EXPECT_TRUE(mentions(only(model.notices, NoticeKind::ChosenSurface), "80 edges"));
  CageOptions options = kInterpolate;
  options.crease_angle = 0;
  const Model round = model_from_cage(testing::cylinder_mesh(40), options);
  EXPECT_EQ(round.fits[0].creases, 0U);
  const Notice notice = only(round.notices, NoticeKind::WavySurface);
  EXPECT_TRUE(mentions(notice, "crease_angle")) << notice.text;
  EXPECT_TRUE(notice.point);
}

TEST(FitCage, TellsAVertexThatStandsOut) {
  Cage mesh = testing::sphere_mesh(3);
  mesh.points[77] *= 1 + testing::kSphereEdge / 2;
  const Model model = model_from_cage(mesh, kInterpolate);
  EXPECT_TRUE(mentions(only(model.notices, NoticeKind::WavySurface), "vertex 77"));
}

TEST(FitCage, TellsNoiseAndAFitThatHelps) {
  const Cage mesh = testing::with_noise(testing::sphere_mesh(3), 0.2 * testing::kSphereEdge);
  const Model model = model_from_cage(mesh, kInterpolate);
  EXPECT_GT(model.fits[0].noisy_share, 0.5);
  const Notice notice = only(model.notices, NoticeKind::NoisyInput);
  EXPECT_TRUE(mentions(notice, "fit = ")) << notice.text;
  EXPECT_TRUE(mentions(notice, "more than 10°")) << notice.text;
  CageOptions options = kInterpolate;
  options.fit = Length::units(0.2 * testing::kSphereEdge);
  const Model smooth = model_from_cage(mesh, options);
  EXPECT_LE(smooth.fits[0].distance, 0.2 * testing::kSphereEdge);
  EXPECT_EQ(smooth.fits[0].fit, 0.2 * testing::kSphereEdge);
  EXPECT_LT(smooth.fits[0].mean_distance, smooth.fits[0].distance);
  for (const Notice& told : smooth.notices) EXPECT_NE(told.kind, NoticeKind::NoisyInput);
}

TEST(FitCage, TellsPointsThatNoSurfaceReaches) {
  Cage mesh = testing::cube();
  mesh.points[7] *= 1.5;
  CageOptions options = kInterpolate;
  options.crease_angle = 0;
  const Model model = model_from_cage(mesh, options);
  EXPECT_GT(model.fits[0].distance, 0.1);
  const Notice notice = only(model.notices, NoticeKind::MissedPoints);
  EXPECT_TRUE(mentions(notice, "triangles in place of quads")) << notice.text;
  EXPECT_TRUE(mentions(notice, "at vertex ")) << notice.text;
  EXPECT_TRUE(notice.point);
}

/// A thin disc, whose rims bulge across each other without creases.
Cage disc_mesh() {
  Cage mesh = testing::cylinder_mesh(24);
  for (Vec3& point : mesh.points) point.z() *= 0.1;
  return mesh;
}

constexpr CageOptions kWithoutCreases = {.crease_angle = 0, .surface = SurfaceKind::Interpolate};

/// The notice that mentions a text.
Notice the_one_with(const Notices& notices, const std::string& text) {
  const auto found = std::find_if(notices.begin(), notices.end(),
                                  [&](const Notice& notice) { return mentions(notice, text); });
  EXPECT_NE(found, notices.end()) << text;
  return found == notices.end() ? Notice() : *found;
}

/// The faces of which all sides are sharp creases.
std::vector<std::vector<int>> flat_faces(const Cage& cage) {
  std::set<std::pair<int, int>> creases;
  for (const Cage::Crease& crease : cage.creases) {
    creases.insert(std::minmax(crease.edge[0], crease.edge[1]));
  }
  std::vector<std::vector<int>> flat;
  for (const std::vector<int>& f : cage.faces) {
    bool is_flat = true;
    for (std::size_t k = 0; k < f.size(); ++k) {
      is_flat &= creases.count(std::minmax(f[k], f[(k + 1) % f.size()])) == 1;
    }
    if (is_flat) flat.push_back(f);
  }
  return flat;
}

TEST(FitCage, DoesNotFoldTheSurface) {
  const Cage mesh = disc_mesh();
  const Cage through = interpolating_cage(mesh).cage;
  EXPECT_FALSE(measure_waves(mesh, through, Scheme::Loop).folded_faces.empty());
  Cage cage = mesh;
  const detail::CageFit fit = detail::fit_cage(kWithoutCreases, Scheme::Loop, cage);
  Cage tagged = cage;
  tagged.points = mesh.points;
  EXPECT_TRUE(measure_waves(tagged, cage, Scheme::Loop).folded_faces.empty());
  EXPECT_GT(fit.fit->distance, 1e-3);
  const Notice missed = the_one_with(fit.notices, "misses");
  EXPECT_EQ(missed.kind, NoticeKind::MissedPoints);
  EXPECT_TRUE(missed.point);
  for (const Notice& notice : fit.notices) EXPECT_FALSE(mentions(notice, "still folds"));
}

TEST(FitCage, KeepsFacesFlatWhereTheSurfaceFoldsAllTheSame) {
  Cage cage = disc_mesh();
  const detail::CageFit fit = detail::fit_cage(kWithoutCreases, Scheme::Loop, cage);
  const std::vector<std::vector<int>> flat = flat_faces(cage);
  EXPECT_EQ(flat.size(), 48U);
  EXPECT_TRUE(mentions(the_one_with(fit.notices, "is flat"), "48 faces"));
  const auto surfaces = make_limit_surfaces(cage, Scheme::Loop);
  for (const std::vector<int>& face : flat) {
    const auto f = static_cast<std::size_t>(std::find(cage.faces.begin(), cage.faces.end(), face) -
                                            cage.faces.begin());
    Vec3 centre = Vec3::Zero();
    for (const int v : face) centre += disc_mesh().points[static_cast<std::size_t>(v)] / 3;
    const Vec3 at = surfaces[f]->evaluate({1.0 / 3, 1.0 / 3}, Order::Position).point;
    EXPECT_LT((at - centre).norm(), 1e-9) << f;
  }
}

TEST(FitCage, TellsHowNearAFitIs) {
  CageOptions options;
  options.fit = Length::units(0.01);
  const Model model = model_from_cage(testing::sphere_mesh(3), options);
  const Notice notice = only(model.notices, NoticeKind::ChosenSurface);
  EXPECT_TRUE(mentions(notice, "within 0.01 of the vertices")) << notice.text;
  EXPECT_FALSE(mentions(notice, "passes through")) << notice.text;
}

TEST(FitCage, NamesTheLimitOfTheTurns) {
  const Model model = model_from_cage(testing::sphere_mesh(3));
  const Notice notice = only(model.notices, NoticeKind::ChosenSurface);
  EXPECT_TRUE(mentions(notice, "less than 20°")) << notice.text;
  EXPECT_TRUE(mentions(notice, "passes through the vertices")) << notice.text;
}

TEST(FitCage, TakesAFitForAWishToInterpolate) {
  const Model model = model_from_cage(testing::icosahedron(), {.fit = Length::units(0.01)});
  ASSERT_EQ(model.fits.size(), 1U);
  EXPECT_LE(model.fits[0].distance, 0.01);
  only(model.notices, NoticeKind::ChosenSurface);
}

TEST(FitCage, TellsAFitOfALimitSurface) {
  const Model model = model_from_cage(testing::icosahedron(),
                                      {.surface = SurfaceKind::Limit, .fit = Length::units(0.01)});
  EXPECT_TRUE(model.fits.empty());
  only(model.notices, NoticeKind::UnusedOption);
}

/// A face that comes back to a vertex is left out, and so it is for the fit.
TEST(FitCage, LeavesOutFacesThatCannotBeUsed) {
  Cage mesh = testing::sphere_mesh(2);
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({2, 3, 2});
  CageOptions options = kInterpolate;
  options.patches = PatchKind::Faces;
  const Model model = model_from_cage(mesh, options);
  EXPECT_EQ(model.patches.size(), mesh.faces.size() - 2);
  EXPECT_LT(model.fits[0].distance, 1e-12);
}

TEST(FitCage, InterpolatesPolygons) {
  CageOptions options = kInterpolate;
  options.crease_angle = 0;
  const Model model = model_from_cage(testing::prism(7), options);
  EXPECT_LT(model.fits[0].distance, 1e-9);
  for (const Vec3& point : testing::prism(7).points) {
    const double distance = std::transform_reduce(
        model.vertices.begin(), model.vertices.end(), 1.0,
        [](double a, double b) { return std::min(a, b); },
        [&](const ModelVertex& v) { return (v.position - point).norm(); });
    EXPECT_LT(distance, 1e-4);
  }
}

TEST(FitCage, RefusesAFitThatIsNone) {
  EXPECT_THROW(model_from_cage(testing::cube(), {.fit = Length::units(-1)}), Error);
}

}  // namespace
}  // namespace surfmesh
