// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/quality/face_set_check.hh"

namespace surfmesh {

/// What the mesh of a model must be like, whatever its elements.
struct PromisedTopology {
  /// By contour: 1 where the mesh is open, at true boundaries and where it is cut (three or more
  /// patches, a Möbius band).
  std::vector<char> is_open;
  /// By vertex of the model: 1 where it becomes several vertices, of patches that are not glued.
  std::vector<char> is_split;
  std::vector<std::size_t> component_of;  ///< by patch, one number for all that are glued
  std::size_t components = 0;
  long euler = 0;

  friend bool operator==(const PromisedTopology&, const PromisedTopology&) = default;
};

/// Find what the contours of a model promise: patches are glued along those of two uses that can be
/// oriented alike.
///
/// Pre      check(model) finds nothing wrong
/// Cost     O(contour uses)
PromisedTopology promised_topology(const Model& model);

/// Find where the mesh of a model is not as the model promises.
///
/// Kinds of faults: open_edge (a side without a neighbour where the model has one), closed_edge (a
/// side with a neighbour where the model ends), duplicate_vertex (the same coordinates as another
/// vertex of what hangs together, unless both lie where the mesh may be open, or the model's vertex
/// is split), components and euler (one entry, which gives both numbers). Locations name the patch.
///
/// Reads    surf:patch (face), surf:contour (edge; optional: without it open edges pass on every
///          patch that is open anywhere, and between two points of an open contour; closed_edge is
///          not found)
/// Cost     O(n), about 30 ns per triangle, shared among threads; without contours some 100
///          evaluations for each other open edge and open contour
std::vector<MeshFault> compare_with_promise(const PolyMesh& mesh, const Model& model);

/// The same where measure_topology(mesh) is known.
std::vector<MeshFault> compare_with_promise(const PolyMesh& mesh, const MeshTopology& topology,
                                            const Model& model);

}  // namespace surfmesh
