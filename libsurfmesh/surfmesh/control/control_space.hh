// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/control/control_node.hh"
#include "surfmesh/control/node_discs.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/metric_field.hh"

namespace surfmesh {

/// Which nodes the sizes at a point are averaged from.
/// Source   paper, sections 4.1 and 4.2
enum class Interpolation {
  Single,     ///< V_s: one vertex of the containing triangle
  Triangle,   ///< V_t: its three vertices
  Circles,    ///< V_o: the vertices of all triangles whose circumcircles contain the point
  Automatic,  ///< V_x: for each triangle the cheapest of these that is as good as V_o to epsilon
  Linear,     ///< linear in the containing triangle: not in the paper, of second order
};

/// What is averaged.
enum class Blend {
  Linear,       ///< H, as in the paper
  Logarithmic,  ///< log H: averages of lengths are geometric
};

/// Where a node of an extended form is looked for.
enum class DiscLookup {
  Disc,      ///< in its whole disc
  Vertices,  ///< only from the triangles at the node, as in the paper
};

/// How a control space answers queries.
struct ControlSpaceOptions {
  double grade = 0;  ///< sizes grow by at most ln(grade) per unit of length; 0 is off, or >= 1
  Interpolation interpolation = Interpolation::Linear;
  double epsilon = 0.1;  ///< eq. (6): conformity below which a cheaper interpolation is as good
  Blend blend = Blend::Linear;
  DiscLookup lookup = DiscLookup::Disc;
  /// True if the nodes hold sizes of area sources: in a disc the minimum with them is taken, as it
  /// is with any grade. False: in a disc its own sizes hold alone, as in the paper.
  bool discs_meet_area_sources = false;
  /// R of the paper: within this metric distance the last sizes are used again, where the caller
  /// allows it (QueryHint::can_reuse); 0 is off.
  double reuse = 0;
};

/// Throws   InvalidOption naming the option, its value and its range
void check(const ControlSpaceOptions& options);

/// The sizes of one patch, at any point of it.
///
/// Immutable after construction; queries are const and may come from several threads, each with a
/// hint of its own.
class ControlSpace {
 public:
  virtual ~ControlSpace() = default;

  /// The sizes wanted at a point of the patch.
  ///
  /// In the order of the paper, section 4: the last sizes if the point is near the last one, then
  /// the extended nodes, then interpolation. A point outside the bounding rectangle gets the sizes
  /// of a point at its rim.
  SizeTensor size(const SurfacePoint& at, QueryHint& hint) const;

  /// These sizes as the metric at the point.
  Metric metric(const SurfacePoint& at, QueryHint& hint) const;

  /// The nodes with surf:uv, surf:size and positions in space, and the faces between them.
  virtual const PolyMesh& mesh() const = 0;

  /// The first form at a node, by its vertex in mesh().
  virtual FirstFormFactor form(int node) const = 0;

  /// The nodes with the metrics of their sizes. Sizes change there, so every mesh must resolve
  /// these points.
  const std::vector<MetricCorner>& node_metrics() const { return node_metrics_; }

 protected:
  /// `discs` are the nodes of extended forms.
  ControlSpace(const ControlSpaceOptions& options, const std::vector<ControlNode>& nodes);

  const ControlSpaceOptions& options() const { return options_; }

  /// Store the metrics of the nodes after gradation.
  void store_node_metrics(std::vector<MetricCorner> metrics) { node_metrics_ = std::move(metrics); }

  /// Find the triangle that contains a point, for the queries below, and store it in the hint. A
  /// lattice finds the cell with the interpolation.
  virtual void locate(Uv, QueryHint&) const {}

  /// The sizes of the extended nodes at the triangle of a point whose discs contain the point; a
  /// lattice has no such triangles.
  /// Pre      locate() was called last for this point
  virtual std::optional<SizeTensor> extended_size_by_vertices(const SurfacePoint&,
                                                              const QueryHint&) const {
    return std::nullopt;
  }

  /// The sizes from the nodes around a point, without any extended form.
  /// Pre      locate() was called last for this point
  virtual SizeTensor interpolate(const SurfacePoint& at, QueryHint& hint) const = 0;

 private:
  SizeTensor size_anew(const SurfacePoint& at, QueryHint& hint) const;

  ControlSpaceOptions options_;
  NodeDiscs discs_;
  std::vector<MetricCorner> node_metrics_;
};

}  // namespace surfmesh
