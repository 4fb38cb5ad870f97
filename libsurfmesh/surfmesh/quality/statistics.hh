// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Number of values in [from, to).
struct HistogramBin {
  double from = 0;
  double to = 0;
  std::size_t count = 0;

  friend bool operator==(const HistogramBin&, const HistogramBin&) = default;
};

/// Metric lengths of edges: no dimension, 1 is wanted.
struct EdgeStatistics {
  std::size_t count = 0;
  double mean = 0;           ///< μ
  double stddev = 0;         ///< σ, of the whole population
  double min = 0;            ///< shortest
  double max = 0;            ///< longest
  double unit_fraction = 0;  ///< share of the lengths in [1/√2, √2]
  /// Four bins to a factor of 2 from ¼ to 4, so that the middle four are the unit interval; the
  /// first begins at 0, the last ends at 4 or the longest edge.
  std::vector<HistogramBin> histogram;

  friend bool operator==(const EdgeStatistics&, const EdgeStatistics&) = default;
};

/// Metric quality Q of triangles: 1 for the unit triangle, 0 for no area, negative if turned over.
struct QualityStatistics {
  std::size_t count = 0;  ///< triangles; other faces are left out
  double min = 0;
  double mean = 0;
  double below_0_3 = 0;                ///< share of the triangles with Q < 0.3
  int worst_face = -1;                 ///< index of the first with the least Q
  std::vector<double> min_of_patches;  ///< by patch where faces have one; +∞ without triangles
  /// Eleven bins: those turned over, from −1 to 0, then ten from 0 to 1. Empty without triangles.
  std::vector<HistogramBin> histogram = {};

  friend bool operator==(const QualityStatistics&, const QualityStatistics&) = default;
};

/// True if each corner has its (u,v), and each face its patch.
///
/// Reads    surf:uv (halfedge), surf:patch (face), both optional
bool has_parameters(const PolyMesh& mesh);

/// True if each corner has a metric.
///
/// Reads    surf:metric (halfedge; optional)
bool has_metric(const PolyMesh& mesh);

/// The metric length of each edge of a result mesh, by its index, as measure_edges takes it.
///
/// Reads    surf:uv, surf:metric (halfedge)
/// Throws   as measure_edges
std::vector<double> metric_lengths(const PolyMesh& mesh);

/// The metric quality of each triangle of a result mesh, by the index of its face, as
/// measure_quality takes it; NaN for other faces.
///
/// Reads    as measure_quality
/// Throws   as measure_quality
std::vector<double> triangle_qualities(const PolyMesh& mesh);

/// Measure every edge of a result mesh once.
///
/// The length is edge_length of the lengths in the metrics of the two corners in one face, in the
/// patch of that face. That is the face of the edge's first halfedge, or of its second if the first
/// is on the boundary. On a contour, the other patch may see a slightly different length.
///
/// Reads    surf:uv, surf:metric (halfedge)
/// Error    exact for sizes that change geometrically along the edge
/// Pre      every edge has a face
/// Throws   MissingProperty; InvalidInput where a corner is unset (NaN)
EdgeStatistics measure_edges(const PolyMesh& mesh);

/// Measure the triangles of a result mesh, each in the mean of the metrics of its corners.
///
/// A whole patch may be reversed against its parameters, to be oriented like its neighbours. A
/// triangle therefore counts as turned over if its sign in (u,v) differs from that of its patch's
/// area.
///
/// Reads    surf:uv, surf:metric (halfedge), surf:patch (face; without it, all faces count as one
///          patch)
/// Throws   MissingProperty; InvalidInput where a corner is unset (NaN)
QualityStatistics measure_quality(const PolyMesh& mesh);

}  // namespace surfmesh
