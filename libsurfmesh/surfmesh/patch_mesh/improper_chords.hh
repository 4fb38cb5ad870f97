// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "surfmesh/model/model.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"

namespace surfmesh {

/// What was split, and what it turned over.
struct ChordReport {
  std::size_t nodes = 0;  ///< that chords were given
  /// By patch: what is turned against the surface in those that got nodes.
  std::map<std::size_t, TurnedTriangles> turned;
};

/// Split chords that would make the result improper: edges from a vertex to itself, and edges
/// between two vertices that another edge joins, also across patches.
///
/// Chords between boundary nodes, and from them to inner nodes (which see both sides of a seam in a
/// coarse mesh), are split in their middle until none offends. `fields` holds the metric of each
/// patch.
///
/// Writes   the vertices of new nodes, as finish_patch does
/// Cost     O(boundary nodes) per round, rarely more than two rounds; a surface evaluation per
///          vertex of the patches that get nodes
/// Pre      patches are those of the model, those with offending chords of triangles
/// Throws   Geometry if rounds do not end
ChordReport split_improper_chords(std::vector<PatchMesh>& patches, const Model& model,
                                  const std::vector<const MetricField*>& fields);

/// Throws   Geometry: chords cannot be split so that the result is proper
[[noreturn]] void throw_too_coarse_boundary();

/// The two vertices that an edge joins, by their numbers in the result: the smaller one in the
/// upper half.
using EdgeEnds = std::uint64_t;

/// In either order.
EdgeEnds edge_ends(int from, int to);

/// The edges between vertices that other tiles may have, too.
struct SharedEdges {
  std::vector<EdgeEnds> chords;    ///< inner edges of the tile
  std::vector<EdgeEnds> segments;  ///< of its boundary
};

/// Find the edges of a tile that those of another tile may make improper: where none of all tiles
/// joins what another one joins, but for a segment that two have, there is nothing to split.
/// Cost     O(boundary nodes)
SharedEdges shared_edges(const PatchMesh& tile);

}  // namespace surfmesh
