// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_from_mesh.hh"
#include "surfmesh/core/length.hh"

namespace surfmesh {

namespace ranges {

inline constexpr LengthRange kFit = {"fit", true};

}  // namespace ranges

/// How a surface is made to pass through the points of a mesh.
struct InterpolationOptions {
  Scheme scheme = Scheme::Auto;  ///< subdivision scheme
  /// How far the surface may stay from the points, or a share of the cage's diagonal; 0 is through
  /// all of them.
  Length fit = {};
  /// Vertices that the surface need not pass through: their points of the cage are those given, so
  /// that it bulges less there. With a fit they have an effect only if no smoother surface reaches
  /// it, as the one through the points is taken then.
  std::vector<int> passed_by = {};
};

/// A cage whose limit surface passes through the points that were given, or near to them.
struct InterpolatingCage {
  Cage cage;                 ///< with the points of the other cage
  std::size_t vertices = 0;  ///< that have faces
  double distance = 0;       ///< greatest one of a point from that of the surface, model units
                             ///< (also of those passed by)
  int farthest_vertex = -1;  ///< that of this distance; -1 if all are 0
  double mean_distance = 0;  ///< root of the mean square of these distances
  double greatest_move = 0;  ///< of a point of the cage, model units
  int moved_vertex = -1;     ///< that of the greatest move; -1 if none has moved
  int iterations = 0;        ///< of the solver, in all
  /// True if no cage was found whose surface passes through the points: it is the nearest to them.
  bool is_least_squares = false;
  /// True if the search for the nearest one ended before it was found; there may be nearer ones.
  bool has_stopped = false;
  double fairness = 0;  ///< weight of smoothness against nearness that reaches the fit; 0 without
};

/// Find the cage of the same connectivity and tags whose limit surface has the vertices at the
/// points that are given.
///
/// Its points c solve L c = p, where the rows of L are limit_stencils. Where that has no solution,
/// as for Catmull-Clark on most hexahedra, the nearest surface is taken, with the least moves of
/// the points. With a `fit`, |L c - p|² + m |U c|² is minimal, where U takes from each point the
/// mean of its neighbours, along a crease or border of those on it only; at corners it is 0. The
/// weight m is the greatest one for which no vertex is farther than the fit from its point.
///
/// Tags are taken as they are: edges that are not creases become round, with waves beside them; see
/// tag_features.
/// Units    model units
/// Error    without fit, and where no least squares are needed, distances are up to 1e-11 of the
///          diagonal (test InterpolatingCage.PassesThroughTrianglesAndQuads)
/// Cost     O(face corners): 0.04 s for 100,000 triangles, 1.2 s with a fit; least squares have
///          up to 2,000 iterations, in which the time grows with the root of the number of vertices
/// Throws   InvalidInput for a cage that cannot be subdivided, or a vertex that it does not have;
///          InvalidOption; Geometry if no cage is found
/// Source   Halstead, Efficient, fair interpolation using Catmull-Clark surfaces (1993)
InterpolatingCage interpolating_cage(const Cage& cage, const InterpolationOptions& options = {});

/// The same for an OpenMesh mesh with any traits; see cage_from_mesh for the tags and the order of
/// vertices and faces.
///
/// Throws   as cage_from_mesh, too
template <class Mesh>
InterpolatingCage interpolating_cage(const Mesh& mesh, const InterpolationOptions& options = {},
                                     const CageFromMeshOptions& tags = {}) {
  return interpolating_cage(cage_from_mesh(mesh, tags), options);
}

}  // namespace surfmesh
