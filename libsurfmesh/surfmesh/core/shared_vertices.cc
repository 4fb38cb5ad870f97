// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/shared_vertices.hh"

#include "surfmesh/core/properties.hh"

namespace surfmesh {

SharedVertices::SharedVertices(const PolyMesh& mesh) : count_(mesh.n_vertices()) {
  const auto original_of = find(mesh, keys::vertex_original);
  if (!original_of.is_valid()) return;
  numbers_.assign(mesh.n_vertices(), -1);
  is_first_.assign(mesh.n_vertices(), 0);
  int next = 0;
  const auto is_first = [&](VertexHandle vh) {
    // One that was added later, or whose original is gone, is its own.
    const VertexHandle original(mesh.property(original_of, vh));
    return original == vh || !original.is_valid() || !mesh.is_valid_handle(original) ||
           mesh.property(original_of, original) != original.idx();
  };
  for (const VertexHandle vh : mesh.vertices()) {
    if (!is_first(vh)) continue;
    is_first_[index(vh)] = 1;
    numbers_[index(vh)] = next++;
  }
  for (const VertexHandle vh : mesh.vertices()) {
    int& number = numbers_[index(vh)];
    if (number < 0) number = numbers_[static_cast<std::size_t>(mesh.property(original_of, vh))];
  }
  count_ = static_cast<std::size_t>(next);
}

}  // namespace surfmesh
