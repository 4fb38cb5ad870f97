// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/patch_measures.hh"

#include <gtest/gtest.h>

#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

/// A 2 × 1 rectangle of a quad, patch 0, and two triangles, one of patch 2 and one of none.
PolyMesh example() {
  PolyMesh mesh;
  std::vector<VertexHandle> v;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0, 2.0}) v.push_back(mesh.add_vertex({x, y, 5}));
  }
  mesh.add_face(std::vector{v[0], v[1], v[4], v[3]});
  mesh.add_face(std::vector{v[1], v[2], v[5]});
  mesh.add_face(std::vector{v[1], v[5], v[4]});
  const auto patch = attach(mesh, keys::face_patch, 0);
  mesh.property(patch, FaceHandle(1)) = 2;
  mesh.property(patch, FaceHandle(2)) = -1;
  return mesh;
}

TEST(MeasurePatches, TellsNameGroupsFacesAndArea) {
  const auto patches = measure_patches(example(), {{"left", "none"}, {{"a", {0, 2}}, {"b", {2}}}});
  const std::vector<PatchMeasure> wanted = {
      {.name = "left", .groups = {"a"}, .quads = 1, .area = 1.0},
      {.name = "none"},
      {.groups = {"a", "b"}, .triangles = 1, .area = 0.5}};
  EXPECT_EQ(patches, wanted);
}

TEST(MeasurePatches, FindsNoneWithoutTheProperty) {
  EXPECT_TRUE(measure_patches(PolyMesh(), {{"left"}, {}}).empty());
}

}  // namespace
}  // namespace surfmesh
