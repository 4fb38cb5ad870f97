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

/// True if a cage is most likely a mesh of a surface: fine, without tags, and half of its edges
/// that are no features turn by less than 20 degrees, under other schemes than Loop 8. Under the
/// bilinear scheme both are the same.
///
/// Pre      scheme is not Auto
bool is_mesh_of_surface(const Cage& cage, Scheme scheme, const MeshTurns& turns);

}  // namespace surfmesh
