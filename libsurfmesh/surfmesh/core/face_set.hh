// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Faces with any number of corners, stored as vertex indices in one array, face after face.
class FaceList {
 public:
  std::size_t size() const { return first_.size() - 1; }
  bool empty() const { return size() == 0; }

  /// Number of corners of all faces. Corners are numbered in the order of the faces.
  std::size_t corner_count() const { return vertices_.size(); }

  /// Index of the first corner of a face; first_corner(size()) is corner_count().
  std::size_t first_corner(std::size_t face) const { return first_[face]; }

  int vertex(std::size_t corner) const { return vertices_[corner]; }

  /// The vertices of a face.
  std::span<const int> operator[](std::size_t face) const {
    return {vertices_.data() + first_[face], first_[face + 1] - first_[face]};
  }

  /// The vertices of all corners.
  std::span<const int> vertices() const { return vertices_; }
  std::span<int> vertices() { return vertices_; }

  /// Cost     O(1) where there are other numbers of corners in all, O(faces) else
  bool has_only_triangles() const {
    if (corner_count() != 3 * size()) return false;
    for (std::size_t f = 0; f < size(); ++f) {
      if (first_[f] != 3 * f) return false;
    }
    return true;
  }

  void add(std::span<const int> vertices) {
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    first_.push_back(vertices_.size());
  }

  void reserve(std::size_t faces, std::size_t corners) {
    first_.reserve(faces + 1);
    vertices_.reserve(corners);
  }

  friend bool operator==(const FaceList&, const FaceList&) = default;

 private:
  std::vector<int> vertices_;
  std::vector<std::size_t> first_ = {0};
};

/// Points and the faces between them, as read from a file. They need not form a proper mesh.
struct FaceSet {
  std::vector<Vec3> points;
  FaceList faces;            ///< all vertices in range, at least three different ones per face
  std::vector<int> patches;  ///< of each face, -1 for none; empty if no face has one
};

}  // namespace surfmesh
