// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/turned_triangles.hh"

#include <algorithm>
#include <array>

#include "surfmesh/quality/facing.hh"

namespace surfmesh {
namespace {

/// Rounds without progress: triangles lie flat only after some halving; more makes slivers.
constexpr int kMaxFailures = 4;

bool is_turned(const TriangulatedPatch& patch, const TriangleVertices& triangle) {
  const std::size_t a = index(triangle[0]), b = index(triangle[1]), c = index(triangle[2]);
  return surfmesh::is_turned(patch.points[a], patch.points[b], patch.points[c],
                             patch.normals[a] + patch.normals[b] + patch.normals[c]);
}

std::vector<FaceHandle> turned_faces(const TriangulatedPatch& patch) {
  std::vector<FaceHandle> faces;
  for (std::size_t f = 0; f < patch.delaunay->n_faces(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (is_turned(patch, fh)) faces.push_back(fh);
  }
  return faces;
}

/// True if a swap of the edge leaves none of its two triangles turned.
bool swap_mends(const TriangulatedPatch& patch, HalfedgeHandle heh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  if (!patch.delaunay->can_flip(mesh.edge_handle(heh))) return false;
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
  const VertexHandle origin = mesh.from_vertex_handle(heh), tip = mesh.to_vertex_handle(heh);
  const VertexHandle left = mesh.to_vertex_handle(mesh.next_halfedge_handle(heh));
  const VertexHandle right = mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite));
  return !is_turned(patch, {right, tip, left}) && !is_turned(patch, {left, origin, right});
}

double squared_chord(const TriangulatedPatch& patch, HalfedgeHandle heh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  const Vec3& from = patch.points[index(mesh.from_vertex_handle(heh))];
  const Vec3& to = patch.points[index(mesh.to_vertex_handle(heh))];
  return (to - from).squaredNorm();
}

/// Swap an edge of the triangle, or return its longest inner edge; invalid after a swap, and if all
/// edges are segments.
EdgeHandle swap_or_choose(TriangulatedPatch& patch, FaceHandle fh) {
  const PolyMesh& mesh = patch.delaunay->mesh();
  HalfedgeHandle longest;
  HalfedgeHandle heh = mesh.halfedge_handle(fh);
  for (int k = 0; k < 3; ++k, heh = mesh.next_halfedge_handle(heh)) {
    if (patch.delaunay->is_constrained(mesh.edge_handle(heh))) continue;
    if (swap_mends(patch, heh)) {
      patch.delaunay->flip(mesh.edge_handle(heh));
      return EdgeHandle();
    }
    if (!longest.is_valid() || squared_chord(patch, heh) > squared_chord(patch, longest)) {
      longest = heh;
    }
  }
  return longest.is_valid() ? mesh.edge_handle(longest) : EdgeHandle();
}

std::size_t count_turned_in_fans(const TriangulatedPatch& patch) {
  std::size_t count = 0;
  for (const PoleFan& fan : patch.boundary.fans) {
    const Vec3 pole = patch.surface->evaluate(fan.sides.front(), Order::Position).point;
    for (std::size_t i = 0; i + 1 < fan.ring.size(); ++i) {
      const auto near = static_cast<std::size_t>(fan.ring[i]);
      const auto far = static_cast<std::size_t>(fan.ring[i + 1]);
      if (surfmesh::is_turned(pole, patch.points[far], patch.points[near],
                              patch.normals[near] + patch.normals[far])) {
        ++count;
      }
    }
  }
  return count;
}

TurnedPlace place_of(const TriangulatedPatch& patch, FaceHandle fh) {
  TurnedPlace place{{0, 0}, Vec3::Zero()};
  std::array<Vec3, 3> normals;
  std::size_t k = 0;
  for (const VertexHandle vh : vertices(patch.delaunay->mesh(), fh)) {
    place.uv = place.uv + 1.0 / 3 * patch.delaunay->uv(vh);
    place.point += patch.points[index(vh)] / 3;
    normals[k++] = patch.normals[index(vh)];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (normals[i].dot(normals[(i + 1) % 3]) <= 0) place.is_of_surface = true;
  }
  return place;
}

/// `faces` are all that are turned outside fans.
TurnedTriangles turned_triangles(const TriangulatedPatch& patch,
                                 const std::vector<FaceHandle>& faces) {
  TurnedTriangles result{faces.size() + count_turned_in_fans(patch), {}};
  for (const FaceHandle fh : faces) {
    const TurnedPlace place = place_of(patch, fh);
    if (!result.place || place.is_of_surface) result.place = place;
    if (place.is_of_surface) break;
  }
  return result;
}

}  // namespace

bool is_turned(const TriangulatedPatch& patch, FaceHandle fh) {
  return is_turned(patch, vertices(patch.delaunay->mesh(), fh));
}

TurnedTriangles mend_turned_triangles(TriangulatedPatch& patch) {
  std::vector<FaceHandle> faces = turned_faces(patch);
  std::size_t least = faces.size();
  int failures = 0;
  while (!faces.empty() && failures < kMaxFailures) {
    std::vector<EdgeHandle> chords;
    for (const FaceHandle fh : faces) {
      if (!is_turned(patch, fh)) continue;  // mended by a swap of its neighbour
      const EdgeHandle eh = swap_or_choose(patch, fh);
      if (eh.is_valid()) chords.push_back(eh);
    }
    std::sort(chords.begin(), chords.end());
    chords.erase(std::unique(chords.begin(), chords.end()), chords.end());
    for (const EdgeHandle eh : chords) split_chord(patch, eh);
    patch.delaunay->shrink();
    evaluate_vertices(patch);
    faces = turned_faces(patch);
    if (faces.size() >= least) ++failures;
    least = std::min(least, faces.size());
  }
  return turned_triangles(patch, faces);
}

TurnedTriangles find_turned_triangles(const TriangulatedPatch& patch) {
  return turned_triangles(patch, turned_faces(patch));
}

}  // namespace surfmesh
