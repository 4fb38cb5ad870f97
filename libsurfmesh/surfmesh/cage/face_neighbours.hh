// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <array>
#include <cstddef>
#include <vector>

namespace surfmesh {

/// How the faces of a refiner's base level, all triangles or all quads, lie beside each other on a
/// smooth surface.
class FaceNeighbours {
 public:
  struct Side {
    int face = -1;  ///< -1 for none
    int side = -1;  ///< from its corner of this number to the next
  };

  /// `sets` has a number for each face, -1 for one that is left out. Faces are neighbours across an
  /// edge of two faces of one set without any sharpness, which they pass in opposite directions.
  ///
  /// Cost     O(faces)
  FaceNeighbours(const OpenSubdiv::Far::TopologyRefiner& refiner, const std::vector<int>& sets);

  int face_count() const { return level_.GetNumFaces(); }
  int corner_count() const { return corner_count_; }
  bool is_used(int face) const { return sets_[static_cast<std::size_t>(face)] >= 0; }

  int vertex(Side side) const { return level_.GetFaceVertices(side.face)[side.side]; }
  int end_vertex(Side side) const { return vertex(after(side)); }
  int edge(Side side) const { return level_.GetFaceEdges(side.face)[side.side]; }

  /// The next side of the same face.
  Side after(Side side) const { return {side.face, (side.side + 1) % corner_count_}; }

  /// The same edge as its neighbour passes it; none if there is no neighbour.
  Side across(Side side) const {
    return across_[static_cast<std::size_t>(4 * side.face + side.side)];
  }

  const OpenSubdiv::Far::TopologyLevel& level() const { return level_; }

 private:
  Side neighbour(Side side) const;

  OpenSubdiv::Far::TopologyLevel level_;
  std::vector<int> sets_;
  int corner_count_;
  std::vector<Side> across_;  ///< by face and side
};

}  // namespace surfmesh
