// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "surfmesh/improve/star.hh"

namespace surfmesh {

/// The star of vertex 0.
inline Star star_of(const DelaunayMesh& delaunay) {
  Star star;
  EXPECT_TRUE(star.collect(delaunay, VertexHandle(0)));
  return star;
}

}  // namespace surfmesh
