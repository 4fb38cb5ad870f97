// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/storable.hh"

#include <gtest/gtest.h>

#include <sstream>

#include "support/meshes.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

template <class T>
T stored_and_restored(const T& value, bool swap) {
  std::stringstream stream;
  EXPECT_EQ(OpenMesh::IO::store(stream, value, swap), sizeof(T));
  T result;
  EXPECT_EQ(OpenMesh::IO::restore(stream, result, swap), sizeof(T));
  return result;
}

TEST(Storable, ValuesReadBackBitByBit) {
  for (const bool swap : {false, true}) {
    EXPECT_EQ(stored_and_restored(Uv{0.1, -1e300}, swap), (Uv{0.1, -1e300}));
    EXPECT_EQ(stored_and_restored(Metric{0.1, 0.2, 0.3}, swap), (Metric{0.1, 0.2, 0.3}));
    EXPECT_EQ(stored_and_restored(SizeTensor{1, 2, 3}, swap), (SizeTensor{1, 2, 3}));
  }
}

TEST(Storable, BytesDoNotDependOnTheOrderInMemory) {
  std::ostringstream plain, swapped;
  OpenMesh::IO::store(plain, Uv{0.1, 0.2}, false);
  OpenMesh::IO::store(swapped, Uv{0.1, 0.2}, true);
  const std::string bytes = plain.str();
  EXPECT_EQ(swapped.str(), std::string(bytes.rend() - 8, bytes.rend()) +
                               std::string(bytes.rbegin(), bytes.rbegin() + 8));
}

TEST(Storable, PropertiesArePersistent) {
  // OpenMesh refuses, with a warning, where it cannot store the type.
  PolyMesh mesh = testing::octahedron();
  EXPECT_TRUE(mesh.property(attach(mesh, keys::corner_uv)).persistent());
  EXPECT_TRUE(mesh.property(attach(mesh, keys::corner_metric)).persistent());
  EXPECT_TRUE(mesh.property(attach(mesh, keys::vertex_size)).persistent());
}

TEST(Storable, PropertiesReadBackWhole) {
  PolyMesh mesh = testing::octahedron();
  const auto handle = attach(mesh, keys::corner_uv, Uv{0.25, 0.75});
  std::stringstream stream;
  mesh.property(handle).store(stream, false);
  auto& values = mesh.property(handle).data_vector();
  values.assign(values.size(), Uv());
  mesh.property(handle).restore(stream, false);
  for (const Uv& value : values) EXPECT_EQ(value, (Uv{0.25, 0.75}));
}

}  // namespace
}  // namespace surfmesh
