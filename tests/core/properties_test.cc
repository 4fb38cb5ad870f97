// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/properties.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/meshes.hh"

namespace surfmesh {
namespace {

ErrorCode code_of(const auto& call, std::string& text) {
  try {
    call();
  } catch (const Error& error) {
    text = error.what();
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::Io;
}

TEST(Attach, SetsEveryElement) {
  PolyMesh mesh = testing::octahedron();
  const auto patch = attach(mesh, keys::face_patch, 7);
  for (const FaceHandle fh : mesh.faces()) EXPECT_EQ(mesh.property(patch, fh), 7);
}

TEST(Attach, LeavesValuesVisiblyUnset) {
  PolyMesh mesh = testing::octahedron();
  const auto uv = attach(mesh, keys::corner_uv);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    EXPECT_TRUE(std::isnan(mesh.property(uv, heh).u));
  }
}

TEST(Attach, GivesNewElementsAnUnsetValue) {
  PolyMesh mesh;
  const auto uv = attach(mesh, keys::vertex_uv, Uv{1, 2});
  const VertexHandle vh = mesh.add_vertex({0, 0, 0});
  EXPECT_TRUE(std::isnan(mesh.property(uv, vh).u));
}

TEST(Attach, RefusesASecondOneOfTheSameName) {
  PolyMesh mesh = testing::octahedron();
  attach(mesh, keys::face_patch);
  std::string text;
  EXPECT_EQ(code_of([&] { attach(mesh, keys::face_patch); }, text), ErrorCode::InvalidInput);
  EXPECT_NE(text.find(keys::face_patch.name), std::string::npos);
}

TEST(Require, NamesThePropertyAndTheStageThatMakesIt) {
  const PolyMesh mesh = testing::octahedron();
  std::string text;
  EXPECT_EQ(code_of([&] { require(mesh, keys::corner_metric); }, text), ErrorCode::MissingProperty);
  EXPECT_NE(text.find(keys::corner_metric.name), std::string::npos);
  EXPECT_NE(text.find(keys::corner_metric.writer), std::string::npos);
}

TEST(Find, TellsElementsWithTheSameNameApart) {
  PolyMesh mesh = testing::octahedron();
  attach(mesh, keys::corner_uv);
  EXPECT_TRUE(find(mesh, keys::corner_uv).is_valid());
  EXPECT_FALSE(find(mesh, keys::vertex_uv).is_valid());
}

TEST(Detach, RemovesTheProperty) {
  PolyMesh mesh = testing::octahedron();
  attach(mesh, keys::face_patch);
  detach(mesh, keys::face_patch);
  EXPECT_FALSE(find(mesh, keys::face_patch).is_valid());
  detach(mesh, keys::face_patch);
}

TEST(Properties, SurviveACopyOfTheMesh) {
  PolyMesh mesh = testing::octahedron();
  attach(mesh, keys::face_patch, 7);
  const PolyMesh copy = mesh;
  EXPECT_EQ(copy.property(require(copy, keys::face_patch), FaceHandle(3)), 7);
}

}  // namespace
}  // namespace surfmesh
