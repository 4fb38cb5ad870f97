// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/mesh_turns.hh"

namespace surfmesh {

/// True if a cage has tags of subdivision, or rules other than the usual ones: somebody made it for
/// its limit surface.
bool has_tags(const Cage& cage);

/// True if a cage has so many faces that it may be a mesh: 1,000 triangles, or 2,500 faces under
/// another scheme than Loop, where cages are at home.
///
/// Pre      scheme is not Auto
bool is_fine(const Cage& cage, Scheme scheme);

/// The angle below which half of the edges of a mesh turn, degrees: 20 for triangles, under other
/// schemes than Loop 8.
///
/// Pre      scheme is not Auto
double smooth_turn(Scheme scheme);

/// True if a cage is most likely a mesh of a surface: fine, without tags, most of its edges have
/// two faces, and half of those that are no features turn by less than smooth_turn. Under the
/// bilinear scheme a surface is its mesh.
///
/// Pre      scheme is not Auto
bool is_mesh_of_surface(const Cage& cage, Scheme scheme, const MeshTurns& turns);

}  // namespace surfmesh
