// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <utility>
#include <vector>

#include "surfmesh/assemble/assembly_notices.hh"
#include "surfmesh/assemble/border_links.hh"
#include "surfmesh/assemble/common_vertices.hh"
#include "surfmesh/assemble/copy_links.hh"
#include "surfmesh/assemble/copy_values.hh"
#include "surfmesh/assemble/glue_sides.hh"
#include "surfmesh/assemble/number_pieces.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/assemble/piece_border.hh"
#include "surfmesh/assemble/placed_piece.hh"
#include "surfmesh/assemble/result_arrays.hh"
#include "surfmesh/core/freed_memory.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

using detail::BorderSide;
using detail::GluedSides;
using detail::Piece;

/// Call `work` for all pieces at once, the greatest first.
template <class Work>
void for_each_piece(std::vector<Piece>& pieces, const RunContext& context, Work work) {
  std::vector<std::size_t> sizes;
  for (const Piece& piece : pieces) sizes.push_back(piece.source.mesh->n_faces());
  share_indices(heaviest_first(sizes), [&](std::size_t p) {
    context.throw_if_cancelled();
    work(pieces[p]);
  });
}

/// The glued edges come from `first_edge` on.
void write_contours(const GluedSides& glued, const std::vector<BorderSide>& sides,
                    std::size_t first_edge, std::vector<int>& contours) {
  for (std::size_t i = 0; i < glued.edges.size(); ++i) {
    contours[first_edge + i] = sides[static_cast<std::size_t>(glued.edges[i][0])].contour;
  }
}

}  // namespace

AssembleReport assemble(PolyMesh& mesh, const Model& model, const std::vector<ContourNodes>& nodes,
                        const NodeNumbers& numbers, std::vector<PatchMesh> patches,
                        const RunContext& context) {
  const PatchOrientation orientation = orient_patches(model);
  std::vector<Piece> pieces = detail::take_pieces(std::move(patches), orientation, numbers);
  for_each_piece(pieces, context, detail::survey_border);
  const detail::CommonVertices common(pieces, numbers);
  detail::ElementCounts counts = detail::number_elements(pieces);
  const std::vector<BorderSide> sides = detail::sides_of(pieces);
  const GluedSides glued = detail::glue_sides(sides, model, orientation.cut_contours);
  const std::size_t first_glued = std::exchange(counts.edges, counts.edges + glued.edges.size());
  const std::vector<HalfedgeHandle> halfedges = detail::give_halfedges(glued, first_glued, pieces);

  // Values come before links, and of the pieces nothing stays longer than it is needed: two thirds
  // of the memory of a run are taken here.
  const detail::ResultArrays arrays = detail::make_result_arrays(mesh, counts);
  common.set_points(model, nodes, numbers, arrays.point);
  write_contours(glued, sides, first_glued, arrays.contour);
  for_each_piece(pieces, context, [&](Piece& piece) {
    detail::place_edges(piece);
    detail::copy_values(piece, common, arrays);
    detail::release_values(*piece.source.mesh);
  });
  return_freed_memory();
  mesh.resize(counts.vertices, counts.edges, counts.faces);
  for_each_piece(pieces, context, [&](Piece& piece) {
    detail::copy_links(piece, common, mesh);
    piece.source.mesh.reset();
    piece.edge_places = {};
  });
  detail::link_open_halfedges(halfedges, mesh);
  detail::separate_fans(sides, halfedges, mesh);
  return {detail::notices_of_assembly(model, glued.cut), {common.contour_count(), common.count()}};
}

}  // namespace surfmesh
