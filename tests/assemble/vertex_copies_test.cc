// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/vertex_copies.hh"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "support/models.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/shared_vertices.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

TEST(VertexCopies, AreNotThereWhereTwoPatchesMeet) {
  const MeshResult result = mesh_model(testing::model_of({testing::sphere()}));
  EXPECT_FALSE(find(result.mesh, keys::vertex_original).is_valid());
  EXPECT_EQ(SharedVertices(result.mesh).count(), result.mesh.n_vertices());
}

TEST(VertexCopies, NameTheVertexInTheSamePlace) {
  const MeshResult result = mesh_model(testing::three_squares());
  const auto original_of = require(result.mesh, keys::vertex_original);
  std::size_t copies = 0;
  for (const VertexHandle vh : result.mesh.vertices()) {
    const VertexHandle original(result.mesh.property(original_of, vh));
    EXPECT_EQ(result.mesh.point(vh), result.mesh.point(original));
    EXPECT_EQ(result.mesh.property(original_of, original), original.idx());
    copies += original == vh ? 0 : 1;
  }
  EXPECT_GT(copies, 0U);
  EXPECT_EQ(SharedVertices(result.mesh).count(), result.mesh.n_vertices() - copies);
}

TEST(VertexCopies, AreOneVertexInFiles) {
  const MeshResult result = mesh_model(testing::three_squares());
  const MeshArrays arrays = mesh_arrays(result.mesh);
  std::map<std::pair<int, int>, int> faces_at;
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    const auto face = arrays.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      ++faces_at[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
  }
  int shared = 0;
  for (const auto& [edge, count] : faces_at) shared += count == 3 ? 1 : 0;
  EXPECT_GT(shared, 0);
}

}  // namespace
}  // namespace surfmesh
