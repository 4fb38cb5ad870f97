// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/vertex_copies.hh"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "surfmesh/core/properties.hh"

namespace surfmesh {

void mark_copies(PolyMesh& mesh, const Model& model) {
  const auto is_shared = [](const Contour& contour) { return contour.uses.size() > 2; };
  if (std::none_of(model.contours.begin(), model.contours.end(), is_shared)) return;
  const auto contour_of = require(mesh, keys::edge_contour);
  std::vector<char> is_on_shared(mesh.n_vertices(), 0);
  for (const EdgeHandle eh : mesh.edges()) {
    const int contour = mesh.property(contour_of, eh);
    if (contour < 0 || !is_shared(model.contour(contour))) continue;
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    is_on_shared[index(mesh.from_vertex_handle(heh))] = 1;
    is_on_shared[index(mesh.to_vertex_handle(heh))] = 1;
  }
  const auto original_of = attach(mesh, keys::vertex_original, -1);
  std::map<std::array<double, 3>, int> first_at;
  for (const VertexHandle vh : mesh.vertices()) {
    int& original = mesh.property(original_of, vh);
    original = vh.idx();
    if (is_on_shared[index(vh)] == 0) continue;
    const auto& p = mesh.point(vh);
    original = first_at.try_emplace({p[0], p[1], p[2]}, vh.idx()).first->second;
  }
}

}  // namespace surfmesh
