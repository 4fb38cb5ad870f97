// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"

/// What is told of the meshes of tiles.
namespace surfmesh::detail {

/// A shortfall of the patches whose tiles were given up, by patch 1 for such; see
/// RefineReport::is_stopped.
Notices notices_of_given_up(const Model& model, const std::vector<char>& is_given_up,
                            ElementKind kind);

/// The triangles of a tile that are turned against the surface.
struct TurnedTile {
  int patch = -1;
  TurnedTriangles turned;
};

/// A shortfall of all of them, with one place: where the surface itself turns over, if it does.
Notices notices_of_turned(const Model& model, const std::vector<TurnedTile>& tiles);

}  // namespace surfmesh::detail
