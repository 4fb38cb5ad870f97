// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/delaunay/delaunay_mesh.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// How inner vertices are smoothed. A positive value is a number of sweeps of Best: see
/// sweeps_of().
enum class Smoothing {
  Off = 0,
  Best = -1,     ///< towards unit lengths of the edges
  Laplace = -2,  ///< to the mean of the neighbours, by the metric at the vertex
  Element = -3   ///< to the apexes of unit triangles, by the metric at the middle of each triangle
};

/// How long a mesh is improved, and towards what.
struct ImproveOptions {
  Smoothing smoothing = Smoothing::Best;
  /// Over all inner vertices; the first of Best brings 75 % of the gain, the second 18 %.
  int sweeps = 2;
  /// Greatest number of passes over the triangles of low quality, after edges outside the unit
  /// range were collapsed or split; 0 turns both off.
  int repairs = 3;
};

/// `count` sweeps of Smoothing::Best, whatever `sweeps` says.
constexpr Smoothing sweeps_of(int count) { return static_cast<Smoothing>(count); }

/// Throws   InvalidOption, naming the option, its value and its range
void check(const ImproveOptions& options);

/// What improve changed.
struct ImproveReport {
  std::size_t moved = 0;      ///< vertex moves accepted
  std::size_t swapped = 0;    ///< edges
  std::size_t collapsed = 0;  ///< edges
  std::size_t split = 0;      ///< edges
  QueryCounts queries;        ///< of the metric field

  friend bool operator==(const ImproveReport&, const ImproveReport&) = default;
};

/// Smooth the inner vertices, swap edges by quality, collapse or split edges that are still far
/// from unit length, and repair the bad triangles that remain.
///
/// A change is accepted only if no triangle is inverted and the worst of those around does not
/// become worse, or stays good. Boundary vertices stay, and keep their numbers.
///
/// Reads    surf:constrained
/// Writes   surf:uv, surf:metric of moved and new vertices
/// Cost     about 0.3 µs and half a metric query per triangle and sweep, for a mesh in spatial
///          order
/// Throws   InvalidOption; Cancelled
/// Source   paper, section 2.1, item 4: Smoothing::Laplace and Smoothing::Element are its two kinds
ImproveReport improve(DelaunayMesh& delaunay, const MetricField& field,
                      const ImproveOptions& options = {}, const RunContext& context = RunContext());

}  // namespace surfmesh
