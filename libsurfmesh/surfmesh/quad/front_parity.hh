// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/quad/front_mesh.hh"

namespace surfmesh {

/// Watches that each region of triangles can be filled with quads: it must consist of an even
/// number of triangles.
///
/// A quad cuts a region in two where its corners join a front to itself. Loops of fronts bound the
/// regions, so the edges of a loop are counted; where a loop around a hole was odd at the beginning
/// that does not suffice, and triangles are.
class FrontParity {
 public:
  /// `has_odd_loops` tells whether a loop of the boundary has an odd number of segments.
  FrontParity(const FrontMesh& mesh, bool has_odd_loops)
      : mesh_(mesh), has_odd_loops_(has_odd_loops) {}

  /// True if all regions beside a quad just made are even, or it cuts none off.
  /// Cost     O(size of the smaller regions), or of their loops
  bool is_even_around(FaceHandle quad);

 private:
  /// One that goes on from a side of the quad, along a front or through a region.
  struct Walker {
    HalfedgeHandle start, at;
    bool is_odd = false;
    std::vector<FaceHandle> faces;  ///< of the region, reached so far
    std::size_t next = 0;           ///< of these, the first not looked at
  };
  enum class Step { GoesOn, HasClosed, HasMet };

  std::vector<HalfedgeHandle> runs(FaceHandle quad) const;
  Step step_along(Walker& walker) const;
  Step step_through(Walker& walker, int number);

  const FrontMesh& mesh_;
  bool has_odd_loops_;
  std::vector<Walker> walkers_;
  std::vector<int> seen_;  ///< by face: the number of the walker that was there
  int walks_ = 0;
};

}  // namespace surfmesh
