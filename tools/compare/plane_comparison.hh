// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hh"
#include "compare/peers.hh"

namespace surfmesh::compare {

/// A model of one rectangular patch whose (u,v) are its x and y.
struct PlaneCase {
  std::string name;  ///< of its file in tools/compare/cases, too
  std::string about;
  int cells = 400;  ///< of the background grid, in each direction
  bool is_isotropic = true;
  bool is_long = false;
};

/// The cases to run; a quick comparison leaves out the long ones.
std::vector<PlaneCase> plane_cases(bool is_quick);

/// Mesh a case by surfmesh and by all peers that were found, in turn, and judge the meshes.
///
/// Throws   Io if inputs cannot be written. What a tool does wrong is told in its result
CaseResult compare_plane(const PlaneCase& plane, const std::vector<Peer>& peers,
                         const Settings& settings);

}  // namespace surfmesh::compare
