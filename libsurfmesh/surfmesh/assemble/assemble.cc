// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <fmt/format.h>

#include <span>
#include <utility>
#include <vector>

#include "surfmesh/assemble/border_links.hh"
#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/copy_piece.hh"
#include "surfmesh/assemble/glue_sides.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/piece.hh"
#include "surfmesh/assemble/piece_border.hh"
#include "surfmesh/assemble/promised_topology.hh"
#include "surfmesh/assemble/result_arrays.hh"
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

/// Copy all pieces, and free the mesh of each as soon as it is copied.
void copy_pieces(std::vector<Piece>& pieces, const CommonVertices& common,
                 const std::vector<HalfedgeHandle>& halfedges, const RunContext& context,
                 detail::ResultArrays& result) {
  std::vector<std::size_t> sizes;
  for (const Piece& piece : pieces) sizes.push_back(piece.source.mesh->n_faces());
  share_indices(heaviest_first(sizes), [&](std::size_t p) {
    context.throw_if_cancelled();
    Piece& piece = pieces[p];
    const std::span sides = std::span(halfedges).subspan(piece.first_side, piece.sides.size());
    detail::copy_piece(piece, static_cast<int>(p), common, sides, result);
    piece.source.mesh.reset();
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

  const int vertex_count = pieces.empty() ? 0 : pieces.back().vertices.end_of_own();
  const std::size_t copied_edges = static_cast<std::size_t>(counts.edges);
  detail::ResultArrays result =
      detail::make_room(mesh, static_cast<std::size_t>(vertex_count),
                        copied_edges + glued.edges.size(), static_cast<std::size_t>(counts.faces));
  common.set_points(model, nodes, numbers, mesh);
  copy_pieces(pieces, common, halfedges, context, result);
  for (std::size_t i = 0; i < glued.edges.size(); ++i) {
    const auto first = static_cast<std::size_t>(glued.edges[i][0]);
    result.contour[copied_edges + i] = sides[first].contour;
  }
  detail::link_open_halfedges(halfedges, mesh);
  detail::separate_fans(sides, halfedges, mesh);
  return {notices_of(model, glued.cut)};
}

}  // namespace surfmesh
