// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {

/// Quads of a lower scaled Jacobian are of no use.
inline constexpr double kFlatQuad = 0.1;

/// Shapes of quads. The scaled Jacobian of a quad is the least sine of its corners, each counted
/// negative where the corner is turned over: 1 for a rectangle, 0 for a corner of 0° or 180°.
struct QuadStatistics {
  std::size_t count = 0;           ///< quads; other faces are left out
  double fraction = 0;             ///< of quads among all faces
  double min_jacobian = 0;         ///< least scaled Jacobian in the metric
  double mean_jacobian = 0;        ///< mean
  double min_space_jacobian = 0;   ///< in space, against the normal of the two diagonals
  double mean_space_jacobian = 0;  ///< mean
  std::size_t inverted = 0;        ///< quads with a negative scaled Jacobian in the metric
  std::size_t flat = 0;            ///< quads with one below kFlatQuad
  std::size_t folded = 0;          ///< quads with a negative scaled Jacobian in space
  /// Share of the inner vertices between quads alone that have more or less than four of them.
  double irregular_share = 0;
  int worst_face = -1;  ///< index of the first with the least scaled Jacobian in the metric
  int worst_face_in_space = -1;        ///< likewise in space
  std::vector<double> min_of_patches;  ///< by patch where faces have one; +∞ without quads
  /// Of the scaled Jacobian in the metric, with the bins of QualityStatistics.
  std::vector<HistogramBin> histogram = {};

  friend bool operator==(const QuadStatistics&, const QuadStatistics&) = default;
};

/// The scaled Jacobian in the metric of each quad of a result mesh, by the index of its face, as
/// measure_quads takes it; NaN for other faces.
///
/// Reads    as measure_quads
/// Throws   as measure_quads
std::vector<double> quad_jacobians(const PolyMesh& mesh);

/// The scaled Jacobian in space of a quad, against the normal of its diagonals.
double quad_space_jacobian(const PolyMesh& mesh, FaceHandle quad);

/// Measure the quads of a result mesh, each corner in the metric there. A corner that is straight
/// in (u,v) is measured in space: on a ring around a pole it is not straight there.
///
/// As with triangles, a quad is turned over if it differs from its patch, which may be reversed
/// against its parameters as a whole.
///
/// Reads    surf:uv, surf:metric (halfedge), surf:patch (face; without it, all faces count as one
///          patch)
/// Cost     O(n)
/// Throws   MissingProperty; InvalidInput where a corner is unset (NaN)
QuadStatistics measure_quads(const PolyMesh& mesh);

}  // namespace surfmesh
