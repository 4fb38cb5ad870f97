// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/across.hh"

#include <algorithm>
#include <iterator>
#include <utility>

#include "surfmesh/across/dissolved_contours.hh"
#include "surfmesh/across/put_back.hh"
#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/freed_memory.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/quad_topology.hh"

namespace surfmesh {
namespace {

std::vector<std::vector<SingularPoint>> singular_points_of(const Model& model) {
  std::vector<std::vector<SingularPoint>> points;
  for (const Patch& patch : model.patches) points.push_back(patch.surface->singular_points());
  return points;
}

std::vector<std::size_t> sheets_of(const Model& model, const std::vector<char>& is_dissolved) {
  DisjointSets sets(model.patches.size());
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (is_dissolved[c] == 0) continue;
    const auto& uses = model.contours[c].uses;
    sets.unite(static_cast<std::size_t>(uses[0].patch), static_cast<std::size_t>(uses[1].patch));
  }
  std::vector<std::size_t> sheets;
  for (std::size_t p = 0; p < model.patches.size(); ++p) sheets.push_back(sets.find(p));
  return sheets;
}

/// What has become of a piece: nothing where it did not become better.
struct ImprovedPiece {
  std::vector<ReturningRegion> regions;
  QueryCounts queries;
};

class Across {
 public:
  Across(PolyMesh& result, const Model& model, const std::vector<const MetricField*>& fields,
         std::vector<char> is_dissolved, const RunContext& context,
         const VertexRange& between_tiles)
      : result_(result),
        context_(context),
        between_tiles_(between_tiles),
        is_dissolved_(std::move(is_dissolved)),
        orientation_(orient_patches(model)),
        walk_(model, is_dissolved_, Walks::FromOpenPatches),
        singular_points_(singular_points_of(model)),
        sheets_(sheets_of(model, is_dissolved_)),
        input_{result,           model,   fields, walk_, orientation_.is_turned,
               singular_points_, sheets_, {}} {}

  /// First inside the pieces, then across the edges between them.
  AcrossReport run() {
    const SmoothRegions regions =
        choose_regions(result_, input_.model, is_dissolved_, between_tiles_);
    report_.faces =
        static_cast<std::size_t>(std::count(regions.is_chosen.begin(), regions.is_chosen.end(), 1));
    clear_contours(regions.is_held);
    const std::vector<FacePiece> pieces = divide_in_pieces(result_, regions);
    if (pieces.empty()) return report_;
    return_freed_memory();  // of assembly, which put_back finds no room in for its long arrays
    std::vector<VertexHandle> seam = seam_between(result_, pieces, regions.is_held);
    PutBackReport report = improve(pieces, regions.is_held);
    if (seam.empty()) return report_;
    for (VertexHandle& vh : seam) vh = report.now(vh);
    input_.places = std::move(report.places);
    improve_along(std::move(seam));
    return report_;
  }

 private:
  /// Edges that are not held are no longer on contours.
  void clear_contours(const std::vector<char>& is_held) {
    auto& contours = result_.property(require(result_, keys::edge_contour)).data_vector();
    share_ranges(contours.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t e = first; e < end; ++e) {
        if (is_held[e] == 0) contours[e] = -1;
      }
    });
  }

  PutBackReport improve(const std::vector<FacePiece>& pieces, const std::vector<char>& is_held) {
    std::vector<ImprovedPiece> improved(pieces.size());
    share_indices(pieces.size(),
                  [&](std::size_t p) { improved[p] = improve_piece(pieces[p], is_held); });
    std::vector<ReturningRegion> regions;
    for (ImprovedPiece& piece : improved) {
      report_.queries += piece.queries;
      std::move(piece.regions.begin(), piece.regions.end(), std::back_inserter(regions));
    }
    return put_back(regions, result_);
  }

  /// A piece that does not become better as a whole may do so in some of its parts.
  ImprovedPiece improve_piece(const FacePiece& piece, const std::vector<char>& is_held) const {
    ImprovedPiece improved;
    const auto improve_part = [&](const FacePiece& part) {
      const RegionWork work = improve_region(input_, part, is_held, context_);
      improved.queries += work.queries;
      if (!work.region.faces.empty()) improved.regions.emplace_back(work, result_);
    };
    improve_part(piece);
    if (!improved.regions.empty()) return improved;
    const std::vector<FacePiece> parts = parts_of(result_, piece, is_held);
    if (parts.size() > 1) std::for_each(parts.begin(), parts.end(), improve_part);
    return improved;
  }

  void improve_along(std::vector<VertexHandle> seam) {
    const SmoothRegions regions = choose_along(result_, input_.model, std::move(seam));
    improve(connected_pieces(result_, regions), regions.is_held);
  }

  PolyMesh& result_;
  const RunContext& context_;
  VertexRange between_tiles_;
  std::vector<char> is_dissolved_;
  PatchOrientation orientation_;
  SurfaceWalk walk_;
  std::vector<std::vector<SingularPoint>> singular_points_;
  std::vector<std::size_t> sheets_;
  RegionInput input_;
  AcrossReport report_;
};

}  // namespace

AcrossReport improve_across(PolyMesh& result, const Model& model,
                            const std::vector<const MetricField*>& fields,
                            const RunContext& context, const VertexRange& between_tiles) {
  std::vector<char> is_dissolved = dissolved_contours(model);
  const bool has_dissolved =
      std::find(is_dissolved.begin(), is_dissolved.end(), 1) != is_dissolved.end();
  const bool has_cuts = between_tiles.first < between_tiles.end && has_quads(result);
  if (!has_dissolved && !has_cuts) return {};
  return Across(result, model, fields, std::move(is_dissolved), context, between_tiles).run();
}

}  // namespace surfmesh
