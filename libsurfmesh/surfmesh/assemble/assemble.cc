// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <fmt/format.h>

#include <span>
#include <utility>
#include <vector>

#include "surfmesh/assemble/border_links.hh"
#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/copy_links.hh"
#include "surfmesh/assemble/copy_values.hh"
#include "surfmesh/assemble/glue_sides.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/piece.hh"
#include "surfmesh/assemble/piece_border.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/assemble/result_arrays.hh"
#include "surfmesh/core/freed_memory.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using detail::CommonVertices;
using detail::GluedSides;
using detail::Piece;

std::vector<Piece> take_pieces(std::vector<PatchMesh> patches, const PatchOrientation& orientation,
                               const NodeNumbers& numbers) {
  std::vector<Piece> pieces;
  pieces.reserve(patches.size());
  int first_own = numbers.count();
  for (PatchMesh& patch : patches) {
    const detail::PieceVertices vertices(patch.boundary, patch.mesh->n_vertices(), first_own);
    first_own = vertices.end_of_own();
    const bool is_turned = orientation.is_turned[patch.patch()] != 0;
    pieces.push_back({std::move(patch), is_turned, vertices});
  }
  return pieces;
}

std::size_t vertex_count(const std::vector<Piece>& pieces) {
  return pieces.empty() ? 0 : static_cast<std::size_t>(pieces.back().vertices.end_of_own());
}

/// What is counted over all pieces.
struct PieceCounts {
  int edges = 0;  ///< copied ones
  int faces = 0;
  std::size_t sides = 0;
};

/// Give each piece the numbers after those of the pieces before it.
PieceCounts number_elements(std::vector<Piece>& pieces) {
  PieceCounts counts;
  for (Piece& piece : pieces) {
    piece.first_edge = counts.edges;
    piece.first_face = counts.faces;
    piece.first_side = counts.sides;
    counts.edges += piece.copied_edge_count();
    counts.faces += piece.face_count();
    counts.sides += piece.sides.size();
  }
  return counts;
}

std::vector<detail::BorderSide> sides_of(const std::vector<Piece>& pieces,
                                         const PieceCounts& counts) {
  std::vector<detail::BorderSide> sides;
  sides.reserve(counts.sides);
  for (const Piece& piece : pieces) {
    sides.insert(sides.end(), piece.sides.begin(), piece.sides.end());
  }
  return sides;
}

/// Give the sides of each edge their halfedges: those edges follow the copied ones.
std::vector<HalfedgeHandle> halfedges_of_sides(const GluedSides& glued, const PieceCounts& counts) {
  std::vector<HalfedgeHandle> halfedges(counts.sides);
  int next = 2 * counts.edges;
  for (const auto& [first, second] : glued.edges) {
    halfedges[static_cast<std::size_t>(first)] = HalfedgeHandle(next);
    if (second >= 0) halfedges[static_cast<std::size_t>(second)] = HalfedgeHandle(next + 1);
    next += 2;
  }
  return halfedges;
}

/// Call `copy(piece, number, sides)` for all pieces, the greatest first.
template <class Copy>
void for_each_piece(std::vector<Piece>& pieces, const std::vector<HalfedgeHandle>& halfedges,
                    const RunContext& context, Copy copy) {
  std::vector<std::size_t> sizes;
  for (const Piece& piece : pieces) sizes.push_back(piece.source.mesh->n_faces());
  share_indices(heaviest_first(sizes), [&](std::size_t p) {
    context.throw_if_cancelled();
    Piece& piece = pieces[p];
    copy(piece, static_cast<int>(p),
         std::span(halfedges).subspan(piece.first_side, piece.sides.size()));
  });
}

/// Vertices of the model at which patches meet in nothing but this point, so that the mesh has
/// several there although no contour is cut.
std::vector<int> touched_vertices(const Model& model) {
  const PromisedTopology promise = promised_topology(model);
  std::vector<char> is_touched = promise.is_split;
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (promise.is_open[c] == 0 || contour.uses.size() < 2) continue;
    for (const int end : {contour.start, contour.end}) {
      is_touched[static_cast<std::size_t>(end)] = 0;
    }
  }
  std::vector<int> result;
  for (std::size_t v = 0; v < is_touched.size(); ++v) {
    if (is_touched[v] != 0) result.push_back(static_cast<int>(v));
  }
  return result;
}

/// What the mesh is other than the model, for a half-edge mesh cannot be so.
Notices notices_of(const Model& model, std::size_t cut_sides) {
  Notices notices;
  if (cut_sides > 0) {
    notices.push_back(warning(
        NoticeKind::CutEdges,
        fmt::format("{} sides of faces are left open where three or more patches meet, or where "
                    "the surface cannot be oriented",
                    cut_sides)));
  }
  if (const std::vector<int> touched = touched_vertices(model); !touched.empty()) {
    const Vec3& first = model.position(touched.front());
    notices.push_back(warning(
        NoticeKind::SplitVertices,
        fmt::format("vertices that are taken apart, as patches meet there in a point only: {}, the "
                    "first at {}",
                    touched.size(), point_text(first))));
    notices.back().point = first;
  }
  return notices;
}

}  // namespace

AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, std::vector<PatchMesh> patches,
                        const RunContext& context) {
  const PatchOrientation orientation = orient_patches(model);
  std::vector<Piece> pieces = take_pieces(std::move(patches), orientation, numbers);
  share_indices(pieces.size(), [&](std::size_t p) { detail::survey_border(pieces[p]); });
  const CommonVertices common(pieces, numbers);
  const PieceCounts counts = number_elements(pieces);
  const std::vector<detail::BorderSide> sides = sides_of(pieces, counts);
  const GluedSides glued = detail::glue_sides(sides, model, orientation.cut_contours);
  const std::vector<HalfedgeHandle> halfedges = halfedges_of_sides(glued, counts);
  context.throw_if_cancelled();

  const auto copied_edges = static_cast<std::size_t>(counts.edges);
  const detail::ElementCounts size{vertex_count(pieces), copied_edges + glued.edges.size(),
                                   static_cast<std::size_t>(counts.faces)};
  const detail::ResultArrays result = detail::make_result_arrays(mesh, size);
  common.set_points(model, nodes, numbers, result.point);
  for (std::size_t i = 0; i < glued.edges.size(); ++i) {
    const auto first = static_cast<std::size_t>(glued.edges[i][0]);
    result.contour[copied_edges + i] = sides[first].contour;
  }
  for_each_piece(pieces, halfedges, context, [&](Piece& piece, int number, auto own_sides) {
    detail::copy_values(piece, number, common, own_sides, result);
    detail::release_values(*piece.source.mesh);
  });
  return_freed_memory();
  mesh.resize(size.vertices, size.edges, size.faces);
  for_each_piece(pieces, halfedges, context, [&](Piece& piece, int number, auto own_sides) {
    detail::copy_links(piece, number, common, own_sides, mesh);
    piece.source.mesh.reset();
  });
  detail::link_open_halfedges(halfedges, mesh);
  detail::separate_fans(sides, halfedges, mesh);
  return {notices_of(model, glued.cut)};
}

}  // namespace surfmesh
