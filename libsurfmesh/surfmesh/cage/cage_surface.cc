// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_surface.hh"

#include "surfmesh/cage/turn_square.hh"

namespace surfmesh {

CagePlace place_on(const FaceOfCage& face, Uv uv) {
  uv = out_of_turned_square(uv, face.rotation);
  // The other way around, corner 0 keeps its place, and the sides beside it change theirs.
  if (face.is_turned) uv = {uv.v, uv.u};
  return {face.face, face.part, uv, face.corners};
}

CagePlace cage_place(const Surface& surface, Uv uv) {
  const auto* of_cage = dynamic_cast<const CageSurface*>(&surface);
  return of_cage != nullptr ? of_cage->place(uv) : CagePlace{};
}

}  // namespace surfmesh
