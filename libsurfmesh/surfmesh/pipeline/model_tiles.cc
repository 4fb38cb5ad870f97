// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/model_tiles.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/for_each_patch.hh"

namespace surfmesh::detail {
namespace {

/// Put the tiles of all patches in one list, with numbers of their own for the nodes they share.
ModelTiles joined(std::vector<Tiles> of_patches, NodeNumbers& numbers) {
  ModelTiles result;
  const int first_vertex = numbers.count();
  for (Tiles& tiles : of_patches) {
    const int by = numbers.add(tiles.shared_nodes) - first_vertex;
    result.first.push_back(result.tiles.size());
    result.refused += tiles.refused;
    result.queries += tiles.queries;
    for (Tile& tile : tiles.tiles) {
      shift_shared_nodes(tile.boundary, first_vertex, by);
      result.tiles.push_back(std::move(tile));
    }
  }
  result.first.push_back(result.tiles.size());
  return result;
}

}  // namespace

ModelTiles cut_patches(const Model& model, const std::vector<const MetricField*>& fields,
                       const std::vector<ContourNodes>& nodes, NodeNumbers& numbers,
                       const TileRules& rules, const RunContext& context) {
  std::vector<Tiles> of_patches(model.patches.size());
  share_indices(of_patches.size(), [&](std::size_t p) {
    context.throw_if_cancelled();
    at_patch(model.patches[p], [&] {
      PatchBoundary boundary =
          collect_boundary(model, static_cast<int>(p), nodes, numbers, *fields[p], rules.multiple);
      const TileTask task{.surface = *model.patches[p].surface,
                          .field = *fields[p],
                          .triangles = rules.triangles[p],
                          .most = rules.most,
                          .multiple = rules.multiple,
                          .sag = rules.sag};
      of_patches[p] = cut_into_tiles(std::move(boundary), task, numbers.count());
    });
  });
  return joined(std::move(of_patches), numbers);
}

std::vector<std::size_t> largest_first(const std::vector<Tile>& tiles) {
  std::vector<std::size_t> weights;
  for (const Tile& tile : tiles) {
    weights.push_back(static_cast<std::size_t>(std::max(0.0, tile.triangles)));
  }
  return heaviest_first(weights);
}

}  // namespace surfmesh::detail
