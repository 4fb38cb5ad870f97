// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Faces of any number of corners as their vertices, one face after the other in one array.
class FaceList {
 public:
  std::size_t size() const { return first_.size() - 1; }
  bool empty() const { return size() == 0; }

  /// Corners of all faces; they are numbered in the order of the faces.
  std::size_t corner_count() const { return vertices_.size(); }

  /// Number of the first corner of a face; that of size() is corner_count().
  std::size_t first_corner(std::size_t face) const { return first_[face]; }

  int vertex(std::size_t corner) const { return vertices_[corner]; }

  /// The vertices of a face.
  std::span<const int> operator[](std::size_t face) const {
    return {vertices_.data() + first_[face], first_[face + 1] - first_[face]};
  }

  /// The arrays themselves: the vertices of all corners, and the first corner of each face with
  /// corner_count() at the end.
  std::span<const int> vertices() const { return vertices_; }
  std::span<const std::uint32_t> offsets() const { return first_; }

  std::span<int> vertices() { return vertices_; }

  /// Cost     O(faces), O(1) where corners are too few or too many
  bool has_only_triangles() const {
    if (corner_count() != 3 * size()) return false;
    for (std::size_t f = 0; f < size(); ++f) {
      if (first_[f] != 3 * f) return false;
    }
    return true;
  }

  /// Have so many faces of so many corners each, to be set by vertices(); what was there is gone.
  void assign(std::span<const std::size_t> sizes) {
    first_.assign(sizes.size() + 1, 0);
    std::inclusive_scan(sizes.begin(), sizes.end(), first_.begin() + 1);
    vertices_.resize(first_.back());
  }

  void add(std::span<const int> vertices) {
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    first_.push_back(static_cast<std::uint32_t>(vertices_.size()));
  }

  void reserve(std::size_t faces, std::size_t corners) {
    first_.reserve(faces + 1);
    vertices_.reserve(corners);
  }

  friend bool operator==(const FaceList&, const FaceList&) = default;

 private:
  std::vector<int> vertices_;
  std::vector<std::uint32_t> first_ = {0};  ///< a list of more than 4e9 corners takes 16 GB
};

/// A mesh in flat arrays, as a viewer or Python takes it and as files have it: its faces may make
/// anything but a proper mesh.
///
/// Arrays by corner have an entry for each corner of `faces`, in its order; an array of what the
/// mesh does not have is empty.
struct MeshArrays {
  std::vector<Vec3> points;
  FaceList faces;               ///< vertices in range, at least three different ones a face
  std::vector<int> patches;     ///< by face, -1 for none
  std::vector<int> contours;    ///< by corner, of the side to the next corner; -1 for none
  std::vector<Uv> uvs;          ///< by corner, in the patch of the face
  std::vector<Metric> metrics;  ///< by corner, in the patch of the face
  std::vector<int> beyond;      ///< by corner, 1 where (u,v) go on beyond the patch of the face
  std::vector<Normal> normals;  ///< by corner, of the surface
  MeshNames names;
};

/// Which arrays are made: those of the corners take three times the memory of the others.
enum class ArrayParts { Faces, FacesAndCorners };

/// Make arrays of a mesh.
///
/// Copies of vertices at contours of three and more patches are one point.
///
/// Reads    surf:original (vertex), surf:patch (face), surf:contour (edge), surf:uv, surf:metric,
/// surf:beyond,
///          surf:normal (halfedge), all optional
/// Cost     O(corners), about 20 ns a triangle, 50 ns with those of the corners
MeshArrays mesh_arrays(const PolyMesh& mesh, MeshNames names = {},
                       ArrayParts parts = ArrayParts::FacesAndCorners);

/// Call `visit` with each corner of a face, as the halfedge that leads to it, the first one first.
template <class Visitor>
void for_each_corner(const PolyMesh& mesh, FaceHandle fh, Visitor visit) {
  const HalfedgeHandle start = mesh.halfedge_handle(fh);
  HalfedgeHandle heh = start;
  do {
    visit(heh);
    heh = mesh.next_halfedge_handle(heh);
  } while (heh != start);
}

/// Call `visit` with the index of each vertex of a face, the first one first.
template <class Visitor>
void for_each_vertex_of(const PolyMesh& mesh, FaceHandle fh, Visitor visit) {
  for_each_corner(mesh, fh, [&](HalfedgeHandle heh) { visit(mesh.to_vertex_handle(heh).idx()); });
}

}  // namespace surfmesh
