// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "surfmesh/core/run_context.hh"
#include "surfmesh/metric/metric_field.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// The nodes of one contour in its direction, both ends included.
struct ContourNodes {
  std::vector<Vec3> points;
  std::vector<std::vector<Uv>> uv;  ///< by use, then by node

  int segment_count() const { return static_cast<int>(points.size()) - 1; }
};

/// Which numbers of segments are even.
enum class SegmentParity {
  Any,
  EvenPatches,  ///< those around each patch together, as quads need them
  EvenContours  ///< that of each contour: opposite sides are equal more often then
};

/// Requirements on the nodes of all contours, apart from sizes.
struct ContourDemands {
  SegmentParity parity = SegmentParity::Any;
  /// Greatest distance between a segment and its contour, model units; unset is off. Above 0.
  std::optional<double> sag = {};
  /// With a sag, factors of the number of segments, by contour: surfaces beside it may need more
  /// than the contour does. Empty for 1 everywhere.
  std::vector<double> more_segments = {};
};

/// See boundary/contour_memory.hh.
class ContourMemory;

/// What the division of contours costs.
struct BoundaryReport {
  QueryCounts queries;  ///< of the metric fields
};

/// The nodes of all contours, and what they cost.
struct BoundaryNodes {
  std::vector<ContourNodes> contours;
  BoundaryReport report;
};

/// Place the nodes of all contours.
///
/// The nodes of a contour come from the patch in whose metric it is longest. The number of segments
/// is the nearest integer to that length, at least 1, and nodes lie at equal metric arcs: this is
/// the marching of eq. (3) with the remainder spread evenly. Then every segment is measured in the
/// metric of every other patch and halved while it is longer than √2. If that gives more segments
/// than the finest patch at each point wants, the nodes are spread evenly over its lengths. If
/// segments of loops cross although their curves do not, they get further nodes there.
///
/// With a sag, the number of segments is the least with which all segments keep the sag, between √½
/// of the length and four times the length. The factor of the contour makes it greater, up to three
/// times the length.
///
/// Contours get more nodes where the result would not be a proper mesh otherwise: at least three
/// segments if closed, two if another contour joins the same vertices, and one more next to each
/// pole. A degenerate contour has one segment of length zero. If another part of a loop comes near
/// it, the segments next to it are halved until the ring around the pole has room.
///
/// `fields` holds the metric of each patch. Contours that `memory` knows are divided as they were;
/// all are kept there.
/// Cost     four to eight metric queries per segment and use
/// Throws   Cancelled; InvalidInput for demands that are out of range; Limit for more than a
///          million segments of one contour
/// Source   paper, section 2.1, item 1
BoundaryNodes place_contour_nodes(const Model& model, const std::vector<const MetricField*>& fields,
                                  const ContourDemands& demands = {},
                                  const RunContext& context = RunContext(),
                                  ContourMemory* memory = nullptr);

}  // namespace surfmesh
