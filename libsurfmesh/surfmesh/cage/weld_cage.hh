// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// What was welded in a cage.
struct WeldReport {
  std::vector<int> vertices;   ///< that are used and now are others
  std::vector<int> onto;       ///< those others
  std::vector<int> collapsed;  ///< faces that are no more than an edge or a point now
};

/// As coincident_points, of the vertices that faces use; others stand for themselves.
std::vector<int> coincident_vertices(const Cage& cage, double tolerance);

/// Replace vertices of faces and tags by those that stand for them (see coincident_vertices). Sides
/// that become points are removed from their faces; collapsed faces become empty. Points keep their
/// numbers.
/// Cost     O(face corners)
WeldReport weld(Cage& cage, const std::vector<int>& stand_ins);

}  // namespace surfmesh
