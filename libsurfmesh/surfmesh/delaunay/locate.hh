// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/random_bits.hh"

namespace surfmesh {

/// Where a point lies in a triangulation.
struct Location {
  enum class Kind { Inside, OnEdge, OnVertex, Outside };

  Kind kind = Kind::Outside;
  FaceHandle face;      ///< a triangle that contains the point; the last one met if outside
  HalfedgeHandle edge;  ///< of `face`: the edge the point lies on, or the open one it lies behind
  VertexHandle vertex;  ///< the vertex with the point's position
};

/// Walk through the triangles towards a point.
///
/// A visibility walk with a random choice between two sides that both lead on: a fixed choice was
/// seen to cycle in meshes of aspect 100. After a bounded number of steps all triangles are
/// searched instead, so it always ends. Exact: the returned closed triangle contains the point.
/// Across concave boundaries or holes the walk may end Outside although the point is inside.
///
/// Cost     O(steps), about 10 ns each
/// Pre      start is a face; faces from 0 to face_count are in use
Location locate(const PolyMesh& mesh, decltype(keys::vertex_uv)::Handle uv, Uv p, FaceHandle start,
                RandomBits& random, std::size_t face_count);

}  // namespace surfmesh
