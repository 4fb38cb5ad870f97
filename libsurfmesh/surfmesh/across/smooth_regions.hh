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

/// Choose all faces but those at poles, of a result whose edges on dissolved contours are no longer
/// marked.
/// Reads    as choose_regions
SmoothRegions choose_all(const PolyMesh& result, const Model& model);

/// Divide chosen faces into pieces of about 8,192: large parts that edges connect which are not
/// held are halved along their box, small ones are put together.
///
/// Depends on nothing but the mesh, and so not on the number of threads.
/// Cost     O(n log n) for the chosen faces
std::vector<FacePiece> divide_in_pieces(const PolyMesh& result, const SmoothRegions& regions);

/// The parts of a piece that edges connect which are not held.
/// Cost     O(faces of the result)
std::vector<FacePiece> parts_of(const PolyMesh& result, const FacePiece& piece,
                                const std::vector<char>& is_held);

/// The faces within three rings of vertices between pieces, as pieces that do not touch.
///
/// `is_chosen` are the faces that may be taken, `is_held` the edges that no piece reaches across.
/// Cost     O(faces)
std::vector<FacePiece> pieces_along(const PolyMesh& result, const std::vector<char>& is_chosen,
                                    const std::vector<char>& is_held,
                                    const std::vector<VertexHandle>& seam);

}  // namespace surfmesh
