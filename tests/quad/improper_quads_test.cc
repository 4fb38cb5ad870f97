// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/improper_quads.hh"

#include <gtest/gtest.h>

#include "support/assembled.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh {
namespace {

/// Two surfaces between the same four sides, one above the other.
Model lens() {
  const auto side = [](double height) {
    return make_callable_surface({0, 2, 0, 1}, [height](auto u, auto v) {
      return std::array{u, v, height * u * (2 - u) * v * (1 - v)};
    });
  };
  return testing::model_of({side(1), side(-1)});
}

/// The quads of all patches before they are assembled.
struct QuadPatches {
  Model model;
  testing::UniformSizes fields;
  std::vector<ContourNodes> nodes;
  NodeNumbers numbers;
  std::vector<PatchMesh> patches;

  QuadPatches(Model given, double size)
      : model(std::move(given)),
        fields(model, size),
        nodes(place_contour_nodes(model, fields, {.parity = SegmentParity::EvenPatches}).contours),
        numbers(model, nodes) {
    for (int p = 0; p < static_cast<int>(model.patches.size()); ++p) {
      patches.push_back(
          mesh_patch({.surface = model.surface(p),
                      .field = fields[p],
                      .boundary = collect_boundary(model, p, nodes, numbers, fields[p], 2),
                      .quads = {.is_on = true}})
              .mesh);
    }
  }

  std::size_t mend() { return mend_improper_quads(patches, model, fields); }
};

/// Each surface is two quads, whose edge between joins the same two nodes above and below.
TEST(MendImproperQuads, PutsRingsAroundEdgesThatTwoPatchesWouldHaveTwice) {
  QuadPatches lens_of_four(lens(), 1);
  ASSERT_EQ(lens_of_four.patches[0].mesh->n_faces(), 2u);
  ASSERT_EQ(lens_of_four.patches[1].mesh->n_faces(), 2u);
  EXPECT_GE(lens_of_four.mend(), 1u);
  PolyMesh mesh;
  assemble(mesh, lens_of_four.model, lens_of_four.nodes, lens_of_four.numbers,
           std::move(lens_of_four.patches));
  testing::expect_valid(mesh);
  EXPECT_EQ(measure_topology(mesh).euler, 2);
  EXPECT_TRUE(measure_topology(mesh).is_closed);
  for (const FaceHandle fh : mesh.faces()) EXPECT_EQ(mesh.valence(fh), 4u);
}

TEST(MendImproperQuads, LeavesProperPatchesAsTheyAre) {
  QuadPatches fine(lens(), 0.2);
  const std::size_t faces = fine.patches[0].mesh->n_faces();
  EXPECT_EQ(fine.mend(), 0u);
  EXPECT_EQ(fine.patches[0].mesh->n_faces(), faces);
}

TEST(MendImproperQuads, FindsNothingTheSecondTime) {
  QuadPatches coarse(lens(), 1);
  coarse.mend();
  EXPECT_EQ(coarse.mend(), 0u);
}

}  // namespace
}  // namespace surfmesh
