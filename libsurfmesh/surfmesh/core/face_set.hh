// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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

/// Points and the faces between them, as files have them: may be anything but a proper mesh.
struct FaceSet {
  std::vector<Vec3> points;
  FaceList faces;            ///< vertices in range, at least three different ones a face
  std::vector<int> patches;  ///< of each face, -1 for none; empty if no face has one
};

}  // namespace surfmesh
