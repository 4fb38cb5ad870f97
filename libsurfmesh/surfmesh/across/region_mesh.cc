// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/region_mesh.hh"

#include <algorithm>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/topology.hh"

namespace surfmesh {
namespace {

/// The place of a value in a sorted list; -1 if it is not there.
template <class Value>
int place_in(const std::vector<Value>& sorted, const Value& value) {
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), value);
  return found == sorted.end() || *found != value ? -1 : static_cast<int>(found - sorted.begin());
}

/// The sides of the faces of a piece, corner by corner.
struct PieceSides {
  std::vector<HalfedgeHandle> sides;
  std::vector<std::size_t> first;  ///< by face

  PieceSides(const PolyMesh& result, const FacePiece& piece) {
    for (const FaceHandle fh : piece) {
      first.push_back(sides.size());
      for_each_corner(result, fh, [&](HalfedgeHandle heh) { sides.push_back(heh); });
    }
  }

  /// The corner of a side; -1 if its face is not of the piece.
  int corner_of(const PolyMesh& result, const FacePiece& piece, HalfedgeHandle heh) const {
    const FaceHandle fh = result.face_handle(heh);
    const int face = fh.is_valid() ? place_in(piece, fh) : -1;
    if (face < 0) return -1;
    std::size_t corner = first[static_cast<std::size_t>(face)];
    while (sides[corner] != heh) ++corner;
    return static_cast<int>(corner);
  }
};

std::vector<int> vertices_of(const PolyMesh& result, const std::vector<HalfedgeHandle>& sides) {
  std::vector<int> vertices;
  vertices.reserve(sides.size());
  for (const HalfedgeHandle heh : sides) {
    vertices.push_back(result.from_vertex_handle(heh).idx());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

RegionMesh cut_region(const PolyMesh& result, const FacePiece& piece,
                      const std::vector<char>& is_held) {
  RegionMesh region;
  region.mesh = std::make_unique<PolyMesh>();
  region.faces = piece;
  const PieceSides corners(result, piece);
  region.vertices = vertices_of(result, corners.sides);
  FaceList faces;
  std::vector<int> cycle, twins;
  for (const FaceHandle fh : piece) {
    cycle.clear();
    for_each_corner(result, fh, [&](HalfedgeHandle heh) {
      cycle.push_back(place_in(region.vertices, result.from_vertex_handle(heh).idx()));
      const int twin = is_held[index(result.edge_handle(heh))] != 0
                           ? -1
                           : corners.corner_of(result, piece, result.opposite_halfedge_handle(heh));
      twins.push_back(twin < 0 ? kOpenSide : twin);
    });
    faces.add(cycle);
  }
  PolyMesh& mesh = *region.mesh;
  const Separation separation =
      build_faces(mesh, region.vertices.size(), faces, FirstSide::FromFirstCorner, twins);
  for (const int copied : separation.copied) {
    region.vertices.push_back(region.vertices[static_cast<std::size_t>(copied)]);
  }
  for (std::size_t v = 0; v < region.vertices.size(); ++v) {
    mesh.set_point(VertexHandle(static_cast<int>(v)),
                   result.point(VertexHandle(region.vertices[v])));
  }
  region.sides.resize(mesh.n_edges());
  std::size_t corner = 0;
  for (const FaceHandle fh : mesh.faces()) {
    for_each_corner(mesh, fh, [&](HalfedgeHandle heh) {
      const EdgeHandle eh = mesh.edge_handle(heh);
      const HalfedgeHandle side = corners.sides[corner++];
      region.sides[index(eh)] =
          heh == mesh.halfedge_handle(eh, 0) ? side : result.opposite_halfedge_handle(side);
    });
  }
  return region;
}

}  // namespace surfmesh
