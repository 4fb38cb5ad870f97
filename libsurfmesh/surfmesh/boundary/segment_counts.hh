// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "surfmesh/boundary/metric_arc.hh"
#include "surfmesh/model/model.hh"

/// How many segments a contour gets.
namespace surfmesh {

/// The least number of segments with which a contour can be part of a proper mesh.
class LeastSegments {
 public:
  explicit LeastSegments(const Model& model);

  /// Three for a closed contour, two if another one joins the same vertices, one to spare beside
  /// each pole.
  int operator()(const Contour& contour) const;

 private:
  std::vector<bool> is_pole_;                 ///< by vertex
  std::map<std::pair<int, int>, int> count_;  ///< of the contours that join two vertices
};

/// The least multiple that is not below a count.
int rounded_up(int count, int multiple);

/// What segments of a curve are to hold.
struct SegmentBounds {
  int least = 1;  ///< number of them
  int multiple = 1;
  double sag = 0;     ///< greatest distance from the curve, model units
  double factor = 1;  ///< of the number that holds the sag
};

/// The least number of segments of equal metric arc, a multiple, with which a curve on a surface
/// holds the sag: from √½ of the length up, and at most four times the length. The factor makes it
/// greater, up to three times the length.
///
/// `arc` is that of the curve.
/// Cost     five evaluations a segment and number
int segments_for_sag(const Surface& surface, const Curve& curve, const MetricArc& arc,
                     const SegmentBounds& bounds);

}  // namespace surfmesh
