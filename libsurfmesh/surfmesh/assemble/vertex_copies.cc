// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/vertex_copies.hh"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/model/joined_uses.hh"

namespace surfmesh {
namespace {

using Vertices = std::vector<VertexHandle>;

/// What a range of the edges adds.
struct FoundVertices {
  Vertices vertices;

  FoundVertices& operator+=(const FoundVertices& other) {
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    return *this;
  }
};

/// The vertices on contours for which `is_wanted` holds, by their numbers.
template <class IsWanted>
Vertices vertices_on(const PolyMesh& mesh, IsWanted is_wanted) {
  const auto contour_of = require(mesh, keys::edge_contour);
  FoundVertices found = sum_of_ranges(mesh.n_edges(), [&](std::size_t first, std::size_t end) {
    FoundVertices own;
    for (std::size_t e = first; e < end; ++e) {
      const EdgeHandle eh(static_cast<int>(e));
      const int contour = mesh.property(contour_of, eh);
      if (contour < 0 || !is_wanted(static_cast<std::size_t>(contour))) continue;
      const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
      own.vertices.push_back(mesh.from_vertex_handle(heh));
      own.vertices.push_back(mesh.to_vertex_handle(heh));
    }
    return own;
  });
  std::sort(found.vertices.begin(), found.vertices.end());
  found.vertices.erase(std::unique(found.vertices.begin(), found.vertices.end()),
                       found.vertices.end());
  return std::move(found.vertices);
}

}  // namespace

void mark_copies(PolyMesh& mesh, const Model& model) {
  const auto joined = joined_uses(model);
  const auto is_shared = [&](std::size_t contour) {
    return joined[contour].empty() && model.contours[contour].uses.size() > 2;
  };
  bool has_shared = false;
  for (std::size_t c = 0; c < model.contours.size(); ++c) has_shared |= is_shared(c);
  if (!has_shared) return;
  const std::vector<VertexHandle> on_shared = vertices_on(mesh, is_shared);
  const auto original_of = attach(mesh, keys::vertex_original, -1);
  share_ranges(mesh.n_vertices(), [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      const int number = static_cast<int>(v);
      mesh.property(original_of, VertexHandle(number)) = number;
    }
  });
  std::map<std::array<double, 3>, int> first_at;
  for (const VertexHandle vh : on_shared) {
    const auto& p = mesh.point(vh);
    mesh.property(original_of, vh) =
        first_at.try_emplace({p[0], p[1], p[2]}, vh.idx()).first->second;
  }
}

}  // namespace surfmesh
