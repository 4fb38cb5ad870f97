// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "compare/comparison.hh"
#include "compare/peers.hh"

namespace surfmesh::compare {

/// The distance between mesh and surface that is asked for, as a share of the diagonal.
inline constexpr double kWantedSag = 0.001;

/// The cages of models/ that are compared, without the ending.
std::vector<std::string> cage_names();

/// Mesh a cage by surfmesh with a bound on its sag, and remesh a dense mesh of it by the peers that
/// can, in turn.
///
/// The option of a peer that decides on its sag is sought in a few runs before, so that the
/// distance comes out just below the wish. All meshes are judged by `surfmesh check`.
/// Throws   Io if inputs cannot be written. What a tool does wrong is told in its result
CaseResult compare_cage(const std::string& name, const std::vector<Peer>& peers,
                        const Settings& settings);

/// What `surfmesh check --json` tells of a mesh, its distance as a share of the diagonal.
///
/// Sets the mesh, distance, failure and remark.
void set_from_check(const std::string& json_text, double diagonal, ToolResult& result);

}  // namespace surfmesh::compare
