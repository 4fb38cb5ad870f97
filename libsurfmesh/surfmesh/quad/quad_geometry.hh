// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/quad/corner_terms.hh"

namespace surfmesh {

/// How good a face is.
struct FaceMeasure {
  double energy = 0;  ///< sum over its corners, with a size weight of 1
  /// Least scaled Jacobian of its corners in the metric, 1 for a rectangle.
  double least_jacobian = 1;
};

/// Where the vertices of a mesh of quads are, and what the metric makes of its corners.
///
/// Smoothing and cleaning know nothing else of the place of a vertex, so they work in the domain of
/// a patch as in space. A trial ends with keep_trial() or with undo_trial(), after which all
/// vertices are where they were at begin_trial().
class QuadGeometry {
 public:
  virtual ~QuadGeometry() = default;

  /// True if the vertex may move.
  virtual bool is_free(VertexHandle vh) const = 0;

  /// True if a new side may join two vertices that have none in this mesh: they may have one beyond
  /// its border, or be the same vertex there.
  virtual bool may_join(VertexHandle a, VertexHandle b) const { return a != b; }

  /// Collect how the corners of the faces around a vertex depend on its step.
  /// Returns  false if the metric there is singular
  virtual bool collect(VertexHandle vh, std::vector<CornerTerms>& star) const = 0;

  /// Move a vertex by a step in its chart, and ask for the metric there.
  /// Returns  false, and does nothing, if that leads far out of the domain, or to where there is no
  ///          metric
  virtual bool move(VertexHandle vh, ChartStep step) = 0;

  /// Put a vertex in the middle of others, or upon the first of them where that is no place.
  virtual void put_between(VertexHandle vh, std::span<const VertexHandle> others) = 0;

  virtual FaceMeasure measure(FaceHandle fh) const = 0;

  virtual void begin_trial() = 0;
  virtual void keep_trial() = 0;
  virtual void undo_trial() = 0;
};

}  // namespace surfmesh
