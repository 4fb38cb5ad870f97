// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/assemble/assemble.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Faces that are worked on together.
using FacePiece = std::vector<FaceHandle>;

/// The part of a result that may change across dissolved contours.
struct SmoothRegions {
  std::vector<char> is_chosen;  ///< by face
  std::vector<char> is_held;    ///< by edge: on contours that stay there
};

/// Choose triangles within three rings of dissolved contours, or all quads of patches at such
/// contours and those within three rings of the cuts between tiles; faces at poles, which (u,v)
/// tells nothing of, are left out. Edges on dissolved contours are held where their faces make an
/// angle of more than 60°.
///
/// `is_dissolved` is by contour. Triangles at cuts would gain too little for their time.
/// Reads    surf:patch (face), surf:contour (edge), surf:uv (halfedge)
/// Cost     O(faces)
SmoothRegions choose_regions(const PolyMesh& result, const Model& model,
                             const std::vector<char>& is_dissolved,
                             const VertexRange& between_tiles = {});

/// Choose the faces within three rings of vertices, but those at poles, of a result whose edges on
/// dissolved contours are no longer marked. All edges that are on contours are held.
/// Reads    as choose_regions
SmoothRegions choose_along(const PolyMesh& result, const Model& model,
                           std::vector<VertexHandle> seam);

/// Divide chosen faces into pieces of about 8,192: large parts that edges connect which are not
/// held are halved along their box, small ones are put together.
///
/// Depends on nothing but the mesh, and so not on the number of threads.
/// Cost     O(n log n) for the chosen faces
std::vector<FacePiece> divide_in_pieces(const PolyMesh& result, const SmoothRegions& regions);

/// The parts of a piece that edges connect which are not held.
/// Cost     O(n log n) for the faces of the piece
std::vector<FacePiece> parts_of(const PolyMesh& result, const FacePiece& piece,
                                const std::vector<char>& is_held);

/// The chosen faces, in pieces that edges connect which are not held.
/// Cost     O(faces of the result), shared, and O(n log n) for the chosen ones
std::vector<FacePiece> connected_pieces(const PolyMesh& result, const SmoothRegions& regions);

/// The vertices of the edges between pieces that are not held, by their numbers.
std::vector<VertexHandle> seam_between(const PolyMesh& result, const std::vector<FacePiece>& pieces,
                                       const std::vector<char>& is_held);

}  // namespace surfmesh
