// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/common_vertices.hh"

#include <algorithm>

#include "surfmesh/core/parallel.hh"

namespace surfmesh::detail {
namespace {

constexpr int kNone = -1;

}  // namespace

CommonVertices::CommonVertices(std::vector<Piece>& pieces, const NodeNumbers& numbers)
    : owner_(static_cast<std::size_t>(numbers.count()), kNone),
      contour_count_(numbers.contour_count()) {
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    // Every vertex of a face that is not a piece's own has a side at the border leave it.
    for (const BorderSide& side : pieces[p].sides) {
      if (side.from < count()) owner_[static_cast<std::size_t>(side.from)] = static_cast<int>(p);
    }
  }
  if (std::find(owner_.begin(), owner_.end(), kNone) != owner_.end()) drop_unused(pieces);
}

void CommonVertices::drop_unused(std::vector<Piece>& pieces) {
  std::vector<int> used_owners;
  int used_on_contours = 0;
  for (const int owner : owner_) {
    const bool is_used = owner != kNone;
    if (is_used && static_cast<int>(number_.size()) < contour_count_) ++used_on_contours;
    number_.push_back(is_used ? static_cast<int>(used_owners.size()) : kNone);
    if (is_used) used_owners.push_back(owner);
  }
  const int fewer = static_cast<int>(owner_.size() - used_owners.size());
  owner_ = std::move(used_owners);
  contour_count_ = used_on_contours;
  const auto new_number = [&](int vertex) {
    const auto v = static_cast<std::size_t>(vertex);
    return v < number_.size() ? number_[v] : vertex - fewer;
  };
  share_indices(pieces.size(), [&](std::size_t p) {
    Piece& piece = pieces[p];
    piece.vertices.renumber(new_number, fewer);
    for (BorderSide& side : piece.sides) {
      side.from = new_number(side.from);
      side.to = new_number(side.to);
    }
    for (LooseFace& face : piece.loose_faces) {
      for (std::size_t k = 0; k < face.count; ++k) {
        face.corners[k].vertex = new_number(face.corners[k].vertex);
      }
    }
  });
}

void CommonVertices::set_points(const Model& model, const std::vector<ContourNodes>& nodes,
                                const NodeNumbers& numbers,
                                std::vector<PolyMesh::Point>& points) const {
  for (std::size_t v = 0; v < model.vertices.size(); ++v) {
    set_point(static_cast<int>(v), model.vertices[v].position, points);
  }
  share_indices(nodes.size(), [&](std::size_t c) {
    for (int i = 1; i < nodes[c].segment_count(); ++i) {
      set_point(numbers(static_cast<int>(c), i), nodes[c].points[static_cast<std::size_t>(i)],
                points);
    }
  });
}

void CommonVertices::set_point(int node, const Vec3& point,
                               std::vector<PolyMesh::Point>& points) const {
  const int vertex = number_.empty() ? node : number_[static_cast<std::size_t>(node)];
  if (vertex != kNone) points[static_cast<std::size_t>(vertex)] = to_openmesh(point);
}

}  // namespace surfmesh::detail
