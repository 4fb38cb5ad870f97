// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/facet_distance.hh"

#include <gtest/gtest.h>

#include "cage/cages.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// A mesh of the faces of a cage, moved, all on patch 0.
PolyMesh moved_mesh(const Cage& cage, const Vec3& step) {
  PolyMesh mesh;
  std::vector<VertexHandle> vertices;
  for (const Vec3& point : cage.points)
    vertices.push_back(mesh.add_vertex(to_openmesh(point + step)));
  for (const std::vector<int>& face : cage.faces) {
    std::vector<VertexHandle> corners;
    for (const int v : face) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    mesh.add_face(corners);
  }
  attach(mesh, keys::face_patch, 0);
  return mesh;
}

Cage flat_sheet() {
  Cage cage = testing::sheet();
  for (Vec3& point : cage.points) point.z() = 0;
  return cage;
}

TEST(FacetDistance, OfAMeshOfTheFacetsIsZero) {
  for (const Cage& cage : {testing::sheet(), testing::pentagon_prism(), testing::torus()}) {
    const Model model = model_from_cage(cage);
    PolyMesh mesh = moved_mesh(cage, Vec3::Zero());
    const auto distance = measure_facet_distance(mesh, model);
    ASSERT_TRUE(distance);
    EXPECT_LT(distance->to_facets.max, 1e-14);
    EXPECT_LT(distance->from_facets.max, 1e-14);
  }
}

TEST(FacetDistance, OfAMeshBesideIsHowFarItIsMoved) {
  const Cage cage = flat_sheet();
  const Model model = model_from_cage(cage);
  const auto above = measure_facet_distance(moved_mesh(cage, {0, 0, 0.25}), model);
  ASSERT_TRUE(above);
  for (const OneWayDistance& way : {above->to_facets, above->from_facets}) {
    EXPECT_DOUBLE_EQ(way.max, 0.25);
    EXPECT_NEAR(way.mean, 0.25, 1e-15);
  }
  EXPECT_EQ(above->to_facets.max_at.z(), 0.25);
  EXPECT_EQ(above->from_facets.max_at.z(), 0);
}

/// The sheet of 3 × 3 is moved along x by 1: a strip stands out on either side.
TEST(FacetDistance, MeansAreOverTheArea) {
  const Cage cage = flat_sheet();
  const auto aside = measure_facet_distance(moved_mesh(cage, {1, 0, 0}), model_from_cage(cage));
  ASSERT_TRUE(aside);
  EXPECT_DOUBLE_EQ(aside->to_facets.max, 1);
  EXPECT_EQ(aside->to_facets.max_at.x(), 4);
  EXPECT_NEAR(aside->to_facets.mean, 0.5 / 3, 1e-14);
  EXPECT_DOUBLE_EQ(aside->from_facets.max, 1);
  EXPECT_EQ(aside->from_facets.max_at.x(), 0);
  EXPECT_NEAR(aside->from_facets.mean, 0.5 / 3, 1e-14);
  EXPECT_EQ(aside->to_facets.max_face % 3, 2);    // in the last column
  EXPECT_EQ(aside->from_facets.max_face % 3, 0);  // in the first one
}

TEST(FacetDistance, IsOfCagesThatCount) {
  Model model = model_from_cage(flat_sheet());
  const PolyMesh mesh = moved_mesh(flat_sheet(), {0, 0, 1});
  EXPECT_FALSE(measure_facet_distance(mesh, model, FacetsOf::InterpolatedCages));
  for (Patch& patch : model.patches) patch.is_interpolating = true;
  EXPECT_TRUE(measure_facet_distance(mesh, model, FacetsOf::InterpolatedCages));
  for (Patch& patch : model.patches) patch.cage = nullptr;
  EXPECT_FALSE(measure_facet_distance(mesh, model));
}

TEST(FacetDistance, IsInTheReportWhereTheSurfaceInterpolates) {
  Model model = model_from_cage(testing::torus());
  EXPECT_FALSE(mesh_model(model).report.facets);
  for (Patch& patch : model.patches) patch.is_interpolating = true;
  const MeshResult result = mesh_model(model);
  ASSERT_TRUE(result.report.facets);
  EXPECT_EQ(*result.report.facets, *measure_facet_distance(result.mesh, model));
  // The limit surface lies inside of its cage.
  EXPECT_GT(result.report.facets->from_facets.max, result.report.facets->from_facets.mean);
  EXPECT_GT(result.report.facets->to_facets.mean, 0.01);
}

TEST(FacetDistance, DoesNotDependOnThreads) {
  const Model model = model_from_cage(testing::torus(30, 20));
  const PolyMesh mesh = moved_mesh(testing::torus(29, 21), {0.1, 0, 0});
  std::optional<FacetDistance> one, four;
  with_threads(1, [&] { one = measure_facet_distance(mesh, model); });
  with_threads(4, [&] { four = measure_facet_distance(mesh, model); });
  EXPECT_EQ(*one, *four);
}

TEST(SurfaceToMesh, TellsWhatAMeshLacks) {
  const Model model = model_from_cage(flat_sheet(), {.scheme = Scheme::Bilinear});
  const SurfaceSearch search(model);
  Cage part = flat_sheet();
  part.faces.resize(6);  // two rows of three
  const auto whole = measure_surface_to_mesh(search, moved_mesh(flat_sheet(), Vec3::Zero()));
  const auto lacking = measure_surface_to_mesh(search, moved_mesh(part, Vec3::Zero()));
  ASSERT_TRUE(whole && lacking);
  EXPECT_LT(whole->max, 1e-14);
  EXPECT_GT(lacking->max, 0.8);
  EXPECT_LE(lacking->max, 1 + 1e-14);
  EXPECT_NEAR(lacking->mean, 0.5 / 3, 0.02);
  EXPECT_GT(lacking->max_at.y(), 2.8);
  EXPECT_FALSE(measure_surface_to_mesh(search, PolyMesh()));
}

}  // namespace
}  // namespace surfmesh
