// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/returning_region.hh"

#include <algorithm>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh {
namespace {

/// Call `give(wanting, number)` for pairs of elements, as long as there are both.
template <class Give>
void use_own(ElementExchange& exchange, Give give) {
  const std::size_t count = std::min(exchange.given_up.size(), exchange.wanting.size());
  for (std::size_t i = 0; i < count; ++i) give(exchange.wanting[i], exchange.given_up[i]);
  const auto used = static_cast<std::ptrdiff_t>(count);
  exchange.given_up.erase(exchange.given_up.begin(), exchange.given_up.begin() + used);
  exchange.wanting.erase(exchange.wanting.begin(), exchange.wanting.begin() + used);
}

}  // namespace

ReturningRegion::ReturningRegion(const RegionWork& work, const PolyMesh& result)
    : taken_(work.region.faces),
      vertex_numbers_(work.region.vertices),
      sides_(work.region.sides),
      kept_edges_(sides_.size()) {
  sides_.resize(work.region.mesh->n_edges());
  collect_faces(work);
  collect_vertices(work);
  collect_edges();
  collect_border(*work.region.mesh, result);
}

void ReturningRegion::collect_faces(const RegionWork& work) {
  const PolyMesh& mesh = *work.region.mesh;
  faces_.reserve(work.editor->face_bound());
  corners_.reserve(mesh.n_halfedges());
  for (std::size_t f = 0; f < work.editor->face_bound(); ++f) {
    const FaceHandle fh(static_cast<int>(f));
    if (!work.editor->is_used(fh)) continue;
    const FaceInPatch& face = work.faces[f];
    std::size_t k = 0;
    for_each_corner(mesh, fh, [&](HalfedgeHandle heh) {
      const VertexHandle vh = mesh.from_vertex_handle(heh);
      corners_.push_back(
          {heh, vh, face.uvs[k], face.metrics[k], face.is_beyond[k], !mesh.is_boundary(vh)});
      ++k;
    });
    faces_.emplace_back(face.patch, corners_.size());
    ++face_counts_[face.patch];
  }
}

void ReturningRegion::collect_vertices(const RegionWork& work) {
  const std::size_t before = vertex_numbers_.size();
  vertex_numbers_.resize(work.editor->vertex_bound(), -1);
  for (std::size_t v = 0; v < vertex_numbers_.size(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    const bool is_used = work.editor->is_used(vh);
    if (is_used && work.is_moved(vh)) {
      moved_.push_back({vh, work.charts[v].point, work.charts[v].place});
    }
    if (v < before && !is_used) vertices_.given_up.push_back(vertex_numbers_[v]);
    if (v >= before && is_used) vertices_.wanting.push_back(vh.idx());
  }
  use_own(vertices_, [this](int vertex, int number) { set_number(VertexHandle(vertex), number); });
}

void ReturningRegion::collect_edges() {
  std::vector<char> is_used(sides_.size(), 0);
  for (const ReturningCorner& corner : corners_) is_used[index(corner.side) / 2] = 1;
  for (std::size_t e = 0; e < sides_.size(); ++e) {
    if (e < kept_edges_ && is_used[e] == 0) edges_.given_up.push_back(sides_[e].idx() / 2);
    if (e >= kept_edges_ && is_used[e] != 0) edges_.wanting.push_back(static_cast<int>(e));
  }
  use_own(edges_, [this](int edge, int number) { set_number(EdgeHandle(edge), number); });
}

/// The sides at the border stay, so that a vertex there can leave by its own one.
void ReturningRegion::collect_border(const PolyMesh& mesh, const PolyMesh& result) {
  for (const ReturningCorner& corner : corners_) {
    if (!mesh.is_boundary(mesh.opposite_halfedge_handle(corner.side))) continue;
    const HalfedgeHandle side = in_result(corner.side);
    const VertexHandle vh = result.from_vertex_handle(side);
    const FaceHandle left_by = result.face_handle(result.halfedge_handle(vh));
    if (left_by.is_valid() && std::binary_search(taken_.begin(), taken_.end(), left_by)) {
      relinked_.emplace_back(vh, side);
    }
  }
}

}  // namespace surfmesh
