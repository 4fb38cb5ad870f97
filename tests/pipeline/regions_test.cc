// SPDX-License-Identifier: BSD-3-Clause
#include "cage/cages.hh"
#include "cage/meshes.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "surfmesh/assemble/result_places.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/quality/face_corners.hh"

/// Whole runs on meshes of many small faces, whose patches are regions of them.
namespace surfmesh {
namespace {

/// A torus of so many faces around its tube, half of whose vertices are irregular.
Cage torus_mesh(int n = 24) { return testing::triangulated(testing::torus(3 * n, n)); }

constexpr double kFaceSize = 2 * M_PI / 24;

MeshResult mesh_of(const Cage& cage, double size, bool has_quads = false, int threads = 1) {
  PipelineOptions options;
  options.sizing.hmin = options.sizing.hmax = Length::units(size);
  options.quads.is_on = has_quads;
  options.threads = threads;
  return mesh_model(model_from_cage(cage), {}, options);
}

double area_of(const PolyMesh& mesh) {
  double sum = 0;
  for (const FaceHandle face : mesh.faces()) {
    sum += 0.5 * detail::double_area_of(mesh, detail::corners_of(mesh, face)).norm();
  }
  return sum;
}

bool has_shortfall(const Report& report) {
  return std::any_of(report.notices.begin(), report.notices.end(),
                     [](const Notice& notice) { return notice.severity == Severity::Shortfall; });
}

class RegionsAtSizes : public ::testing::TestWithParam<double> {};

/// At five times the size of faces as at half of it: the faces do not show. A quarter of the tube,
/// which a plane sees, is at least three elements wide.
TEST_P(RegionsAtSizes, HaveAsManyElementsAsTheSizesAskFor) {
  const double size = GetParam() * kFaceSize / 2;
  const MeshResult result = mesh_of(torus_mesh(48), size);
  testing::expect_valid(result.mesh);
  EXPECT_TRUE(result.report.mesh.is_closed);
  EXPECT_EQ(result.report.mesh.euler, 0);
  EXPECT_FALSE(has_shortfall(result.report));
  EXPECT_LT(result.report.mesh.patches, 60U);
  EXPECT_GT(result.report.quality.min, 0.5);
  EXPECT_GT(result.report.edges.unit_fraction, 0.97);
  const double ideal = area_of(result.mesh) / (std::sqrt(3) / 4 * size * size);
  const double ratio = static_cast<double>(result.report.mesh.triangles) / ideal;
  EXPECT_GT(ratio, 0.9);
  EXPECT_LT(ratio, 1.15);
}

INSTANTIATE_TEST_SUITE_P(Faces, RegionsAtSizes, ::testing::Values(0.5, 1.0, 2.0, 5.0));

/// Two halves of a sphere. A face with two corners on their border had the patch of the other half
/// where the third one lay on several patches of its own.
TEST(Regions, KeepFacesOnTheirSideOfGroups) {
  Cage cage = testing::sphere_mesh(3);
  cage.groups = {{"top", {}}, {"bottom", {}}};
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    double height = 0;
    for (const int v : cage.faces[f]) height += cage.points[static_cast<std::size_t>(v)].z();
    cage.groups[height > 0 ? 0 : 1].faces.push_back(static_cast<int>(f));
  }
  const Model model = model_from_cage(cage);
  for (const double size : {0.25, 0.3, 0.35, 0.45, 0.6}) {
    PipelineOptions options;
    options.sizing.hmin = options.sizing.hmax = Length::units(size);
    const MeshResult result = mesh_model(model, {}, options);
    const auto patch_of = require(result.mesh, keys::face_patch);
    const std::vector<int> top = find_group(model, "top");
    for (const EdgeHandle edge : result.mesh.edges()) {
      const HalfedgeHandle side = result.mesh.halfedge_handle(edge, 0);
      const FaceHandle a = result.mesh.face_handle(side);
      const FaceHandle b = result.mesh.face_handle(result.mesh.opposite_halfedge_handle(side));
      const auto is_top = [&](FaceHandle face) {
        return std::binary_search(top.begin(), top.end(), result.mesh.property(patch_of, face));
      };
      if (is_top(a) == is_top(b)) continue;
      // The border is a line on the surface that no face has moved.
      EXPECT_GE(result.mesh.property(require(result.mesh, keys::edge_contour), edge), 0) << size;
    }
  }
}

TEST(Regions, AreMeshedWithQuads) {
  const MeshResult result = mesh_of(torus_mesh(), 2 * kFaceSize, true);
  testing::expect_valid(result.mesh);
  EXPECT_TRUE(result.report.mesh.is_closed);
  EXPECT_EQ(result.report.mesh.triangles, 0U);
  EXPECT_EQ(result.report.quads.inverted, 0U);
  EXPECT_FALSE(has_shortfall(result.report));
}

TEST(Regions, GiveTheSameFileForAnyNumberOfThreads) {
  const auto text_of = [](int threads) {
    const TestFolder folder;
    const std::string path = folder / "mesh.om";
    write_mesh(mesh_of(torus_mesh(), kFaceSize, false, threads).mesh, path);
    return read_text(path);
  };
  const std::string alone = text_of(1);
  EXPECT_TRUE(text_of(2) == alone);
  EXPECT_TRUE(text_of(8) == alone);
}

/// The surface passes through the vertices; the distances both ways are those to the facets.
TEST(Regions, TellDistancesToTheFacets) {
  const Cage mesh = torus_mesh();
  const MeshResult result = mesh_of(mesh, kFaceSize);
  ASSERT_EQ(result.report.surfaces.size(), 1U);
  EXPECT_LT(result.report.surfaces[0].distance, 1e-10);
  ASSERT_TRUE(result.report.facets);
  EXPECT_GT(result.report.facets->to_facets.mean, 0);
  EXPECT_LT(result.report.facets->to_facets.max, 0.1 * kFaceSize);
  EXPECT_LT(result.report.facets->from_facets.max, 0.1 * kFaceSize);
}

/// A value that is linear in space is carried as the mesh's facets have it.
TEST(Regions, CarryValuesOfTheMesh) {
  const Cage mesh = torus_mesh();
  const Model model = model_from_cage(mesh);
  PipelineOptions options;
  options.sizing.hmin = options.sizing.hmax = Length::units(kFaceSize);
  const MeshResult result = mesh_model(model, {}, options);
  const ResultPlaces places(result.mesh, model);
  double greatest = 0;
  for (const VertexHandle vertex : result.mesh.vertices()) {
    const CageShares shares = places.of_vertex(vertex);
    Vec3 point = Vec3::Zero();
    const std::vector<int>& face = mesh.faces[static_cast<std::size_t>(shares.face)];
    for (std::size_t i = 0; i < shares.weights.size(); ++i) {
      point += shares.weights[i] * mesh.points[static_cast<std::size_t>(face[i])];
    }
    greatest = std::max(greatest, (point - to_eigen(result.mesh.point(vertex))).norm());
  }
  // The parameters of a face are not those of its facet, but near to them.
  EXPECT_LT(greatest, 0.5 * kFaceSize);
}

}  // namespace
}  // namespace surfmesh
