// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/turned_triangles.hh"

#include <Eigen/Geometry>
#include <algorithm>

namespace surfmesh {
namespace {

/// Rounds without progress: triangles lie flat only after some halving; more makes slivers.
constexpr int kMaxFailures = 4;

bool is_turned(const PatchMesh& patch, const TriangleVertices& triangle) {
  const std::size_t a = index(triangle[0]), b = index(triangle[1]), c = index(triangle[2]);
  const Vec3& origin = patch.points[a];
  const Vec3 normal = (patch.points[b] - origin).cross(patch.points[c] - origin);
  return normal.dot(patch.normals[a] + patch.normals[b] + patch.normals[c]) <= 0;
}

std::vector<FaceHandle> turned_faces(const PatchMesh& patch) {
  std::vector<FaceHandle> faces;
  for (std::size_t f = 0; f < patch.delaunay->n_faces(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (is_turned(patch, fh)) faces.push_back(fh);
  }
  return faces;
}

/// True if a swap of the edge leaves none of its two triangles turned.
bool swap_mends(const PatchMesh& patch, HalfedgeHandle heh) {
  const TriMesh& mesh = patch.delaunay->mesh();
  if (!patch.delaunay->can_flip(mesh.edge_handle(heh))) return false;
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(heh);
  const VertexHandle origin = mesh.from_vertex_handle(heh), tip = mesh.to_vertex_handle(heh);
  const VertexHandle left = mesh.to_vertex_handle(mesh.next_halfedge_handle(heh));
  const VertexHandle right = mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite));
  return !is_turned(patch, {right, tip, left}) && !is_turned(patch, {left, origin, right});
}

double squared_chord(const PatchMesh& patch, HalfedgeHandle heh) {
  const TriMesh& mesh = patch.delaunay->mesh();
  const Vec3& from = patch.points[index(mesh.from_vertex_handle(heh))];
  const Vec3& to = patch.points[index(mesh.to_vertex_handle(heh))];
  return (to - from).squaredNorm();
}

/// Swap an edge of the triangle, or return its longest inner edge; invalid after a swap, and if all
/// edges are segments.
EdgeHandle swap_or_choose(PatchMesh& patch, FaceHandle fh) {
  const TriMesh& mesh = patch.delaunay->mesh();
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

std::size_t count_turned_in_fans(const PatchMesh& patch) {
  std::size_t count = 0;
  for (const PoleFan& fan : patch.boundary.fans) {
    const Vec3 pole = patch.surface->evaluate(fan.sides.front(), Order::Position).point;
    for (std::size_t i = 0; i + 1 < fan.ring.size(); ++i) {
      const auto near = static_cast<std::size_t>(fan.ring[i]);
      const auto far = static_cast<std::size_t>(fan.ring[i + 1]);
      const Vec3 normal = (patch.points[far] - pole).cross(patch.points[near] - pole);
      if (normal.dot(patch.normals[near] + patch.normals[far]) <= 0) ++count;
    }
  }
  return count;
}

}  // namespace

bool is_turned(const PatchMesh& patch, FaceHandle fh) {
  return is_turned(patch, vertices(patch.delaunay->mesh(), fh));
}

std::size_t mend_turned_triangles(PatchMesh& patch) {
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
  return faces.size() + count_turned_in_fans(patch);
}

std::optional<Vec3> find_turned_place(const PatchMesh& patch) {
  const std::vector<FaceHandle> faces = turned_faces(patch);
  if (faces.empty()) return {};
  Vec3 sum = Vec3::Zero();
  for (const VertexHandle vh : vertices(patch.delaunay->mesh(), faces.front())) {
    sum += patch.points[index(vh)];
  }
  return sum / 3;
}

std::size_t count_turned_triangles(const PatchMesh& patch) {
  return turned_faces(patch).size() + count_turned_in_fans(patch);
}

}  // namespace surfmesh
