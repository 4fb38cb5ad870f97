// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/own_tiles.hh"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/pieces/improper_tiles.hh"
#include "surfmesh/pipeline/do_or_cancel.hh"
#include "surfmesh/pipeline/for_each_patch.hh"

namespace surfmesh::detail {
namespace {

/// Rounds in which edges that tiles make improper together are mended: one is enough, for new
/// edges have new vertices.
constexpr int kMaxRounds = 3;

/// Run `body` for a tile. Its errors get the tile: on all ranks, that of the least one counts.
template <class Body>
void at_tile(std::size_t tile, const RunContext& context, Body body) {
  const auto error =
      rank_error_of([&] { do_or_cancel(context, "tiles", body); }, static_cast<std::int64_t>(tile));
  if (error) throw ErrorAt(*error);
}

/// Count the faces as the result has them: some may have collapsed.
void count_faces(const FaceList& faces, TileSummary& summary) {
  summary.triangles = summary.quads = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    ++(faces[f].size() == 3 ? summary.triangles : summary.quads);
  }
}

}  // namespace

OwnTiles::OwnTiles(PiecesPlan& plan, Exchange& exchange)
    : plan_(plan),
      exchange_(exchange),
      is_turned_(orient_patches(plan.model()).is_turned),
      tiles_(plan.tiles().size()) {}

void OwnTiles::mesh() {
  agree_on_errors_of(exchange_, [&] {
    plan_.drop_other_spaces(exchange_.rank());
    do_or_cancel(plan_.context(), "tiles", [&] { mesh_own(); });
  });
  check_count();
}

/// The largest tiles begin first, but of errors that of the first tile counts.
void OwnTiles::mesh_own() {
  std::vector<std::size_t> own, weights;
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    if (!is_own(t)) continue;
    own.push_back(t);
    weights.push_back(static_cast<std::size_t>(std::max(0.0, plan_.tiles()[t].triangles)));
  }
  share_and_tell("mesh", heaviest_first(weights), plan_.context(), [&](std::size_t i) {
    const std::size_t t = own[i];
    at_tile(t, plan_.context(), [&] { keep(t, plan_.mesh().mesh_tile(t, plan_.context())); });
  });
}

/// Each rank alone may have made few enough elements.
void OwnTiles::check_count() {
  const RunContext& context = plan_.context();
  const auto elements = sum_all(exchange_, static_cast<std::int64_t>(context.elements()));
  if (static_cast<std::size_t>(elements) <= context.max_elements()) return;
  agree_on_errors_of(exchange_, [&] { context.throw_too_many_elements(); });
}

/// Keep what is needed of a tile, and free its mesh.
void OwnTiles::keep(std::size_t t, PatchResult result) {
  OwnTile own;
  own.chords = shared_edges(result.mesh).chords;
  own.summary = summary_of(t, result, plan_.model());
  {
    const std::lock_guard lock(mutex_);
    seconds_ += result.seconds;
    queries_ += result.queries;
  }
  const NodeNumbers& numbers = plan_.mesh().numbers();
  const bool is_turned = is_turned_[result.mesh.patch()] != 0;
  const Piece piece = surveyed(std::move(result.mesh), numbers, is_turned);
  own.part = part_of(piece, numbers.count());
  own.summary.own_vertices = static_cast<std::int64_t>(own.part.own_count());
  count_faces(own.part.faces, own.summary);
  tiles_[t] = std::move(own);
}

void OwnTiles::mend_edges() {
  for (int round = 0; round <= kMaxRounds; ++round) {
    const std::vector<std::size_t> improper = find_improper();
    if (improper.empty()) return;
    agree_on_errors_of(exchange_, [&] {
      if (round == kMaxRounds) throw_too_coarse_boundary();
      mesh_together(improper);
    });
  }
}

std::vector<std::size_t> OwnTiles::find_improper() const {
  std::vector<TileEdge> chords;
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    for (const EdgeEnds ends : tiles_[t].chords) {
      chords.push_back({static_cast<std::int64_t>(t), ends});
    }
  }
  return improper_tiles(plan_.tiles(), chords, exchange_);
}

/// Every rank meshes all of them, and keeps its own. Their elements have been counted when they
/// were made for the first time; they are few, so that nothing is told of them.
void OwnTiles::mesh_together(const std::vector<std::size_t>& tiles) {
  plan_.need_spaces(tiles);
  std::vector<PatchResult> results(tiles.size());
  constexpr std::size_t without_bound = std::numeric_limits<std::size_t>::max();
  const RunContext uncounted(nullptr, without_bound, plan_.context().element_kind());
  share_indices(tiles.size(), [&](std::size_t i) {
    plan_.context().throw_if_cancelled();
    results[i] = plan_.mesh().mesh_tile(tiles[i], uncounted);
  });
  std::vector<PatchMesh> meshes;
  for (PatchResult& result : results) meshes.push_back(std::move(result.mesh));
  for (const auto& [i, turned] : plan_.mesh().make_proper(meshes)) results[i].turned = turned;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    results[i].mesh = std::move(meshes[i]);
    if (is_own(tiles[i])) keep(tiles[i], std::move(results[i]));
  }
}

std::vector<TileSummary> OwnTiles::gather_summaries() const {
  std::vector<TileSummary> mine;
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    if (is_own(t)) mine.push_back(tiles_[t].summary);
  }
  std::vector<TileSummary> all(tiles_.size());
  for (const std::vector<TileSummary>& of_rank : gather_all(exchange_, mine)) {
    for (const TileSummary& summary : of_rank) {
      all[static_cast<std::size_t>(summary.tile)] = summary;
    }
  }
  return all;
}

TilePart OwnTiles::take_part(std::size_t tile) { return std::exchange(tiles_[tile].part, {}); }

}  // namespace surfmesh::detail
