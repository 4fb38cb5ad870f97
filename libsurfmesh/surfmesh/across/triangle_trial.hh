// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "surfmesh/across/space_moves.hh"

namespace surfmesh {

/// Makes changes of triangles on trial.
///
/// The vertices of the new triangles are smoothed. The change is kept if edges outside of the unit
/// range and bad triangles are much fewer in sum, or no more in sum and lengths and shapes of all
/// that has changed are better; otherwise everything is as before.
class TriangleTrial {
 public:
  explicit TriangleTrial(TriangleState& state)
      : state_(state), moves_(state), star_(state.charts) {}

  /// Swap an edge.
  /// Returns  whether it was done
  /// Cost     5 to 10 µs, as for the others
  bool swap(EdgeHandle eh);

  /// Merge the origin of a halfedge, an inner vertex, into its tip.
  bool collapse(HalfedgeHandle heh);

  /// Put a vertex into the middle of an inner edge.
  bool split(EdgeHandle eh);

 private:
  /// The sum of a measure over triangles and their sides.
  struct Sum {
    double badness = 0;  ///< what is outside of the unit range, or of low quality
    double energy = 0;

    void add_length(double length);
    void add_quality(double quality);
  };

  bool attempt(std::span<const VertexHandle> moving, std::span<const VertexHandle> around);
  Sum measure(std::span<const VertexHandle> around);

  TriangleState& state_;
  SpaceMoves moves_;
  SpaceStar star_;
  std::vector<FaceHandle> old_, made_;
  FaceCycles fresh_;
  std::vector<FaceHandle> faces_;
  std::vector<std::pair<int, int>> edges_;
  std::vector<VertexHandle> moving_, around_;
  std::vector<std::pair<VertexHandle, VertexChart>> before_;
};

}  // namespace surfmesh
