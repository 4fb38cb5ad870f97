// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/quality/surface_search.hh"
#include "surfmesh/quality/triangle_tree.hh"

namespace surfmesh {

/// How far points of one thing are from another, model units.
struct OneWayDistance {
  double max = 0;
  double mean = 0;
  Vec3 max_at = Vec3::Zero();  ///< on the first one
  int max_face = -1;           ///< of the mesh, at or nearest to that point

  friend bool operator==(const OneWayDistance&, const OneWayDistance&) = default;
};

/// Distances between a mesh and the faces of the cage that it was made of, both ways.
struct FacetDistance {
  OneWayDistance to_facets;    ///< of the mesh from the faces of the cage
  OneWayDistance from_facets;  ///< of the faces of the cage from the mesh

  friend bool operator==(const FacetDistance&, const FacetDistance&) = default;
};

/// Which cages of a model count: all, or those that are meshes through whose points the surface
/// passes (Patch::is_interpolating).
enum class FacetsOf { AllCages, InterpolatedCages };

/// The faces of a mesh that lie on patches with an entry other than 0 (all if there are no
/// entries), as triangles. Other faces are fans around the mean of their corners.
///
/// Reads    surf:patch (face), if there are entries
Facets facets_of(const PolyMesh& mesh, const std::vector<char>& patches = {});

/// The faces of the cages of a model that its patches cover, likewise.
Facets facets_of(const Model& model, FacetsOf which = FacetsOf::AllCages);

/// Measure how far the faces of a mesh and those of the cages of its model are from each other.
/// Parts of the mesh on patches of no cage do not count.
///
/// Reads    surf:patch (face)
/// Error    lower bounds of the greatest distances, from seven samples of each triangle: corners,
///          middles of sides, centre. Means are over the area, exact for cubic polynomials
/// Returns  nothing if no cage counts, or no face of the mesh lies on its patches
/// Cost     3 µs a triangle of both together, shared by the threads
/// Throws   MissingProperty; Cancelled
std::optional<FacetDistance> measure_facet_distance(const PolyMesh& mesh, const Model& model,
                                                    FacetsOf which = FacetsOf::AllCages,
                                                    const RunContext& context = RunContext());

/// Measure how far samples of the surface of a model are from a mesh: what the mesh lacks.
///
/// Error    a lower bound of the greatest distance: the samples are those of the search
/// Returns  nothing for a mesh without faces
/// Cost     2 µs a sample, shared by the threads
/// Throws   Cancelled
std::optional<OneWayDistance> measure_surface_to_mesh(const SurfaceSearch& search,
                                                      const PolyMesh& mesh,
                                                      const RunContext& context = RunContext());

}  // namespace surfmesh
