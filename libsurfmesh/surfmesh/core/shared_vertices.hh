// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// The vertices of a mesh without the copies that a half-edge mesh has where three and more faces
/// meet at an edge: as files of indexed vertices have them.
///
/// Reads    surf:original (vertex), optional
/// Cost     O(vertices) if there are copies, else nothing
class SharedVertices {
 public:
  explicit SharedVertices(const PolyMesh& mesh);

  std::size_t count() const { return count_; }

  /// False for copies.
  bool is_first(VertexHandle vh) const { return numbers_.empty() || is_first_[index(vh)] != 0; }

  /// The number of a vertex, or of the one of which it is a copy, among those that are no copies.
  int number(int vertex) const {
    return numbers_.empty() ? vertex : numbers_[static_cast<std::size_t>(vertex)];
  }

 private:
  std::size_t count_;
  std::vector<int> numbers_;    ///< by vertex; empty if there are no copies
  std::vector<char> is_first_;  ///< by vertex
};

}  // namespace surfmesh
