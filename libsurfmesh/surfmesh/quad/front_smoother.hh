// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/quad/front_mesh.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh {

/// Smooths the mesh in the neighbourhood of quads as they are made.
class FrontSmoother {
 public:
  /// The mesh must outlive this.
  explicit FrontSmoother(FrontMesh& front) : front_(front), quads_(front) {}

  /// Move the corners of a quad to where the quads there have unit sides and right angles, and the
  /// vertices before them, that no quad has yet, to where their edges are of unit length. Such
  /// vertices go where they come too near to a front.
  /// Cost     some 10 metric queries
  void smooth_around(FaceHandle quad);

  /// Move vertices and those beside them until no face there is inverted.
  /// Returns  false, and does nothing, if that fails
  bool untangle(std::span<const VertexHandle> vertices);

 private:
  std::vector<VertexHandle> free_vertices_near(std::span<const VertexHandle> vertices) const;
  void smooth_before(VertexHandle corner);
  void spring(VertexHandle vh);

  FrontMesh& front_;
  QuadSmoother quads_;
  std::vector<VertexHandle> before_;  ///< the vertices of triangles beside a corner
};

}  // namespace surfmesh
