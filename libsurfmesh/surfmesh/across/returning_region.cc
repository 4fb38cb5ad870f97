// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/returning_region.hh"

#include <algorithm>
#include <cstddef>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh {
namespace {

/// Call `give(wanting, number)` for pairs of elements, as long as there are both.
template <class Give>
void use_own(ElementExchange& exchange, Give give) {
  const auto count =
      static_cast<std::ptrdiff_t>(std::min(exchange.given_up.size(), exchange.wanting.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    give(exchange.wanting[i], exchange.given_up[i]);
  }
  exchange.given_up.erase(exchange.given_up.begin(), exchange.given_up.begin() + count);
  exchange.wanting.erase(exchange.wanting.begin(), exchange.wanting.begin() + count);
}

}  // namespace

ReturningRegion::ReturningRegion(const RegionWork& work, const PolyMesh& result)
    : work_(work),
      mesh_(*work.region.mesh),
      vertex_numbers_(work.region.vertices),
      sides_(work.region.sides) {
  for_each_face([this](FaceHandle fh) { ++face_counts_[in_patch(fh).patch]; });
  survey_vertices();
  survey_edges();
  survey_border(result);
}

void ReturningRegion::survey_vertices() {
  const std::size_t before = vertex_numbers_.size();
  vertex_numbers_.resize(work_.editor->vertex_bound(), -1);
  for (std::size_t v = 0; v < vertex_numbers_.size(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    if (work_.editor->is_used(vh) == (v < before)) continue;
    if (v < before) {
      vertices_.given_up.push_back(vertex_numbers_[v]);
    } else {
      vertices_.wanting.push_back(vh.idx());
    }
  }
  use_own(vertices_, [this](int vertex, int number) { set_number(VertexHandle(vertex), number); });
}

void ReturningRegion::survey_edges() {
  const std::size_t before = sides_.size();
  sides_.resize(mesh_.n_edges());
  std::vector<char> is_used(sides_.size(), 0);
  for_each_face([&](FaceHandle fh) {
    for_each_corner(mesh_, fh,
                    [&](HalfedgeHandle heh) { is_used[index(mesh_.edge_handle(heh))] = 1; });
  });
  for (std::size_t e = 0; e < sides_.size(); ++e) {
    if ((is_used[e] != 0) == (e < before)) continue;
    if (e < before) {
      edges_.given_up.push_back(mesh_.edge_handle(sides_[e]).idx());
    } else {
      edges_.wanting.push_back(static_cast<int>(e));
    }
  }
  use_own(edges_, [this](int edge, int number) { set_number(EdgeHandle(edge), number); });
}

/// The sides at the border stay, so that a vertex there can leave by its own one.
void ReturningRegion::survey_border(const PolyMesh& result) {
  const FacePiece& faces = work_.region.faces;
  for_each_face([&](FaceHandle fh) {
    for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
      if (!mesh_.is_boundary(mesh_.opposite_halfedge_handle(heh))) return;
      const HalfedgeHandle side = in_result(heh);
      const VertexHandle vh = result.from_vertex_handle(side);
      const FaceHandle left_by = result.face_handle(result.halfedge_handle(vh));
      if (left_by.is_valid() && std::binary_search(faces.begin(), faces.end(), left_by)) {
        relinked_.emplace_back(vh, side);
      }
    });
  });
}

}  // namespace surfmesh
