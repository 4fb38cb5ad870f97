// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// The new number of every element of a mesh.
struct Numbering {
  std::vector<int> vertex;
  std::vector<int> edge;
  std::vector<int> face;
};

/// Number the elements of a mesh along a given order of its vertices. Edges and faces follow their
/// first vertex, so that neighbours in the mesh are near each other in memory.
///
/// Cost     O(n), sorts by counting
/// Pre      `vertex_order` contains every vertex once
Numbering number_along(const PolyMesh& mesh, const std::vector<int>& vertex_order);

/// Give the elements their new numbers. Properties do not move: see renumber_values.
///
/// The two halfedges of an edge keep their order.
/// Cost     O(n)
void renumber(PolyMesh& mesh, const Numbering& numbering);

/// Move the values of one property to the new numbers of their elements.
template <class Value>
void renumber_values(std::vector<Value>& values, const std::vector<int>& new_number) {
  std::vector<Value> moved(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    moved[static_cast<std::size_t>(new_number[i])] = values[i];
  }
  values.swap(moved);
}

}  // namespace surfmesh
