// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_neighbours.hh"

namespace surfmesh {

FaceNeighbours::FaceNeighbours(const OpenSubdiv::Far::TopologyRefiner& refiner,
                               const std::vector<int>& sets)
    : level_(refiner.GetLevel(0)),
      sets_(sets),
      corner_count_(refiner.GetSchemeType() == OpenSubdiv::Sdc::SCHEME_LOOP ? 3 : 4),
      across_(4 * sets.size()) {
  for (int face = 0; face < face_count(); ++face) {
    for (int side = 0; side < corner_count_ && is_used(face); ++side) {
      across_[static_cast<std::size_t>(4 * face + side)] = neighbour({face, side});
    }
  }
}

FaceNeighbours::Side FaceNeighbours::neighbour(Side side) const {
  const int number = edge(side);
  const auto faces = level_.GetEdgeFaces(number);
  if (faces.size() != 2 || level_.GetEdgeSharpness(number) > 0) return {};
  const int other = faces[faces[0] == side.face ? 1 : 0];
  if (other == side.face || !is_used(other)) return {};
  if (sets_[static_cast<std::size_t>(other)] != sets_[static_cast<std::size_t>(side.face)]) {
    return {};
  }
  const Side beyond{other, level_.GetFaceEdges(other).FindIndex(number)};
  // A side that is a point has no direction, and makes no neighbours.
  if (vertex(side) == end_vertex(side)) return {};
  return vertex(beyond) == end_vertex(side) ? beyond : Side{};
}

}  // namespace surfmesh
