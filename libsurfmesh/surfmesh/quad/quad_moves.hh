// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/quad/quad_state.hh"

/// Changes of the connectivity of quads. Each function prepares a change and returns whether it is
/// possible: it joins no two vertices twice, and leaves no inner vertex with less than three faces,
/// but for doublets, whose neighbours may become such.
///
/// `most`, where there is one, bounds how much the sum of excess² over all vertices may grow: a
/// change beyond is not prepared. Vertices that it needs are added to the mesh, so a change that is
/// not made has to be discarded.
namespace surfmesh {

/// The quad in place of two quads that share two sides, whose common vertex goes.
/// Pre      the vertex is inner and has two faces
bool dissolve_doublet(const QuadState& state, VertexHandle vh, Replacement& change);

/// Close the face of a halfedge by merging the halfedge's tip into the opposite corner.
bool collapse_quad(const QuadState& state, HalfedgeHandle heh, int most, Replacement& change);

enum class Turn { CounterClockwise, Clockwise };

/// Turn the edge of a halfedge on to the next corners of both of its faces.
bool rotate_edge(const QuadState& state, HalfedgeHandle heh, Turn turn, int most,
                 Replacement& change);

/// Split the origin of a halfedge along it and the edge `faces` faces on counter-clockwise, and put
/// a new quad between.
bool open_vertex(QuadState& state, HalfedgeHandle heh, int faces, int most, Replacement& change);

/// Give a vertex at the boundary that is the corner of one quad another edge, to the neighbour
/// `faces` faces on from the corner after the opposite one, which is split along.
bool insert_column(QuadState& state, HalfedgeHandle heh, int faces, Replacement& change);

/// Put a smaller quad into a quad, and four around it.
bool insert_pillow(QuadState& state, FaceHandle fh, Replacement& change);

}  // namespace surfmesh
