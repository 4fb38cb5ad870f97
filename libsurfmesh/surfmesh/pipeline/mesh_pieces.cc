// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_pieces.hh"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/patch_mesh/improper_chords.hh"
#include "surfmesh/pieces/piece_builder.hh"
#include "surfmesh/pieces/shared_numbers.hh"
#include "surfmesh/pieces/tile_part.hh"
#include "surfmesh/pieces/tile_summary.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/for_each_patch.hh"
#include "surfmesh/pipeline/mesh_plan.hh"
#include "surfmesh/pipeline/options_of_model.hh"
#include "surfmesh/pipeline/tile_notices.hh"
#include "surfmesh/pipeline/unused_options.hh"
#include "surfmesh/quality/patch_measures.hh"

namespace surfmesh {
namespace {

/// Triangles of a piece if there is one rank: some 80 MB in a file.
constexpr double kTrianglesOfPiece = 2e6;

/// Rounds in which edges that tiles make improper together are mended: one is enough, for new
/// edges have new vertices.
constexpr int kMaxRounds = 3;

/// Corrections see a little less than the measure: they aim below the sag.
constexpr double kCorrectedShare = 0.97;

ElementKind element_kind(const PipelineOptions& options) {
  return options.quads.is_on ? ElementKind::Quads : ElementKind::Triangles;
}

PipelineOptions without_across(PipelineOptions options) {
  options.across.is_on = false;
  return options;
}

/// What the options ask for that pieces do not have.
Notices notices_of_pieces(const PipelineOptions& options, double sag) {
  Notices notices;
  if (options.across.is_on) {
    notices.push_back(information(
        NoticeKind::UnusedOption,
        "elements do not cross contours in pieces: each is made by itself (across = off)"));
  }
  if (sag > 0) {
    notices.push_back(warning(NoticeKind::UnusedOption,
                              "in pieces, the triangles of each tile are corrected for the sag one "
                              "by one; what the whole mesh has reached is not measured"));
  }
  if (options.output.normals || options.output.texture) {
    notices.push_back(warning(NoticeKind::UnusedOption,
                              "pieces have no normals and no texture coordinates (normals, "
                              "texture)"));
  }
  return notices;
}

/// The tiles of a model and how they are dealt to pieces and ranks: alike on all ranks.
struct Deal {
  std::vector<int> piece_of;       ///< by tile
  std::vector<int> rank_of_piece;  ///< ascending
  int pieces = 0;

  int rank_of(std::size_t tile) const {
    return rank_of_piece[static_cast<std::size_t>(piece_of[tile])];
  }
};

std::vector<double> weights_of(const std::vector<Tile>& tiles) {
  std::vector<double> weights;
  for (const Tile& tile : tiles) weights.push_back(std::max(1.0, tile.triangles));
  return weights;
}

/// How many nodes each two tiles have in common.
TileGraph graph_of(const std::vector<Tile>& tiles) {
  TileGraph graph{weights_of(tiles), {}};
  std::unordered_map<int, std::vector<int>> tiles_at;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    for (const BoundaryLoop& loop : tiles[t].boundary.loops) {
      for (const BoundaryNode& node : loop) {
        if (node.vertex < 0) continue;
        std::vector<int>& there = tiles_at[node.vertex];
        if (there.empty() || there.back() != static_cast<int>(t)) {
          there.push_back(static_cast<int>(t));
        }
      }
    }
  }
  std::map<std::pair<int, int>, int> common;
  for (const auto& [vertex, there] : tiles_at) {
    for (std::size_t i = 0; i < there.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) ++common[{there[j], there[i]}];
    }
  }
  for (const auto& [pair, nodes] : common) {
    graph.neighbours.push_back({pair.first, pair.second, nodes});
  }
  return graph;
}

Deal deal_out(const std::vector<Tile>& tiles, const PiecesOptions& options, int ranks) {
  const std::vector<double> weights = weights_of(tiles);
  double triangles = 0;
  for (const double weight : weights) triangles += weight;
  Deal deal;
  deal.pieces = options.pieces > 0 ? options.pieces
                : ranks > 1        ? ranks
                                   : static_cast<int>(std::ceil(triangles / kTrianglesOfPiece));
  deal.pieces = std::clamp(deal.pieces, 1, std::max(1, static_cast<int>(tiles.size())));
  deal.piece_of = options.deal ? options.deal(graph_of(tiles), deal.pieces)
                               : deal_in_runs(weights, deal.pieces);
  std::vector<double> of_pieces(static_cast<std::size_t>(deal.pieces), 0);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    of_pieces[static_cast<std::size_t>(deal.piece_of[t])] += weights[t];
  }
  deal.rank_of_piece = deal_in_runs(of_pieces, ranks);
  return deal;
}

/// What is kept of a tile of this rank.
struct OwnTile {
  TilePart part;
  TileSummary summary;
  std::vector<EdgeEnds> chords;
};

/// An edge of a tile, as ranks exchange them.
struct TileEdge {
  std::int64_t tile;
  EdgeEnds ends;
};

class PiecesRun {
 public:
  PiecesRun(const Model& model, const Sources& sources, const PipelineOptions& options,
            const PiecesOptions& pieces, const RunContext& context, int ranks)
      : model_(model),
        sources_(sources),
        asked_(options),
        options_(without_across(options)),
        pieces_(pieces),
        context_(context),
        ranks_(ranks),
        sizing_(resolve(options.sizing, model)),
        plan_(model, sizing_, options_, context, result_.report),
        is_turned_(orient_patches(model).is_turned) {}

  /// Control spaces, nodes on contours, tiles, and who makes them: alike on all ranks.
  void plan() {
    Report& report = result_.report;
    report.options = detail::options_in_effect(model_, options_);
    report.surfaces = model_.fits;
    append(model_.notices, report.notices);
    append(detail::options_too_late(model_, options_), report.notices);
    append(detail::unused_options(options_), report.notices);
    append(notices_of_pieces(asked_, sizing_.sag), report.notices);
    context_.begin_mesh();
    plan_.take_spaces(control_spaces());
    ContourDemands demands;
    if (sizing_.sag > 0) demands.sag = sizing_.sag;
    if (options_.quads.is_on) demands.parity = SegmentParity::EvenPatches;
    plan_.divide(demands, kCorrectedShare * sizing_.sag, nullptr);
    deal_ = deal_out(plan_.tiles(), pieces_, ranks_);
    shared_.emplace(model_, plan_.nodes(), plan_.numbers(), boundaries(), deal_.piece_of,
                    deal_.pieces);
  }

  const std::vector<Tile>& tiles() const { return plan_.tiles(); }
  const Deal& deal() const { return deal_; }
  const SharedNumbers& shared() const { return *shared_; }

  PiecesReport make(Exchange& exchange, PieceSink& sink) {
    sink.begin({.pieces = deal_.pieces,
                .patches = static_cast<int>(model_.patches.size()),
                .has_quads = options_.quads.is_on,
                .names = mesh_names(model_)});
    own_.resize(tiles().size());
    mesh_tiles(exchange);
    mend_edges(exchange);
    const std::vector<TileSummary> summaries = gather_summaries(exchange);
    write(exchange, summaries, sink);
    sink.finish();
    sum_up(exchange, summaries);
    return std::move(result_);
  }

 private:
  ControlSpaces control_spaces() {
    const StageClock clock(result_.report.seconds[Stage::Control]);
    return make_control_spaces(model_, sources_, sizing_, options_.control, context_);
  }

  std::vector<const PatchBoundary*> boundaries() const {
    std::vector<const PatchBoundary*> boundaries;
    for (const Tile& tile : tiles()) boundaries.push_back(&tile.boundary);
    return boundaries;
  }

  /// The tiles of this rank, the largest first.
  std::vector<std::size_t> own_tiles(int rank) const {
    std::vector<std::size_t> own;
    for (const std::size_t t : detail::largest_first(tiles())) {
      if (deal_.rank_of(t) == rank) own.push_back(t);
    }
    return own;
  }

  void mesh_tiles(Exchange& exchange) {
    const std::vector<std::size_t> own = own_tiles(exchange.rank());
    std::optional<RankError> error;
    std::mutex mutex;
    const auto mesh_own = [&](std::size_t i) {
      try {
        take(own[i], plan_.mesh_tile(own[i]));
      } catch (const Error& thrown) {
        const std::lock_guard lock(mutex);
        const auto tile = static_cast<std::int64_t>(own[i]);
        if (!error || tile < error->index) error = RankError{tile, thrown.code(), thrown.what()};
        throw;
      }
    };
    agree_on_errors_of(exchange, [&] {
      std::vector<std::size_t> order(own.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      try {
        share_and_tell("mesh", order, context_, mesh_own);
      } catch (const Error&) {
        if (!error) throw;
      }
    });
    agree_on_error(exchange, error);
    const auto elements = sum_all(exchange, static_cast<std::int64_t>(context_.elements()));
    if (static_cast<std::size_t>(elements) > context_.max_elements()) {
      agree_on_errors_of(exchange, [&] { context_.throw_too_many_elements(); });
    }
  }

  /// Keep what is needed of a tile, and free its mesh.
  void take(std::size_t t, PatchResult result) {
    OwnTile own;
    own.chords = shared_edges(result.mesh).chords;
    own.summary = summary_of(t, result);
    {
      const std::lock_guard lock(mutex_);
      result_.report.seconds += result.seconds;
      result_.report.control.queries += result.queries;
    }
    const bool is_turned = is_turned_[result.mesh.patch()] != 0;
    const detail::Piece piece = surveyed(std::move(result.mesh), plan_.numbers(), is_turned);
    own.part = part_of(piece, plan_.numbers().count());
    own.summary.own_vertices = static_cast<std::int64_t>(own.part.own_count());
    count_loose(piece, own.summary);
    own_[t] = std::move(own);
  }

  /// Count what is left of faces that collapse, and those of fans.
  static void count_loose(const detail::Piece& piece, TileSummary& summary) {
    const PolyMesh& mesh = *piece.source.mesh;
    for (const detail::CollapsedFace& collapsed : piece.collapsed) {
      --(mesh.valence(collapsed.face) == 3 ? summary.triangles : summary.quads);
    }
    for (const detail::LooseFace& face : piece.loose_faces) {
      ++(face.count == 3 ? summary.triangles : summary.quads);
    }
  }

  /// Mesh tiles anew whose edges join what those of others join, together: few, if there are any.
  void mend_edges(Exchange& exchange) {
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::vector<std::size_t> involved = improper_tiles(exchange);
      if (involved.empty()) return;
      agree_on_errors_of(exchange, [&] { mesh_together(involved, exchange.rank()); });
    }
  }

  /// The tiles with an edge between two vertices that a chord of another tile joins, too.
  std::vector<std::size_t> improper_tiles(Exchange& exchange) const {
    std::vector<TileEdge> mine;
    for (std::size_t t = 0; t < own_.size(); ++t) {
      for (const EdgeEnds ends : own_[t].chords) {
        mine.push_back({static_cast<std::int64_t>(t), ends});
      }
    }
    std::map<EdgeEnds, std::set<std::size_t>> tiles_at;
    for (const std::vector<TileEdge>& of_rank : gather_all(exchange, mine)) {
      for (const TileEdge& edge : of_rank) {
        tiles_at[edge.ends].insert(static_cast<std::size_t>(edge.tile));
      }
    }
    add_segments(tiles_at);
    std::set<std::size_t> involved;
    for (const auto& [ends, there] : tiles_at) {
      if (there.size() > 1) involved.insert(there.begin(), there.end());
    }
    return {involved.begin(), involved.end()};
  }

  /// Add the tiles whose boundaries have a segment between vertices that a chord joins.
  void add_segments(std::map<EdgeEnds, std::set<std::size_t>>& tiles_at) const {
    if (tiles_at.empty()) return;
    for (std::size_t t = 0; t < tiles().size(); ++t) {
      for (const BoundaryLoop& loop : tiles()[t].boundary.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const int from = loop[i].vertex, to = loop[i + 1 == loop.size() ? 0 : i + 1].vertex;
          if (from < 0 || to < 0) continue;
          const auto found = tiles_at.find(edge_ends(from, to));
          if (found != tiles_at.end()) found->second.insert(t);
        }
      }
    }
  }

  void mesh_together(const std::vector<std::size_t>& involved, int rank) {
    std::vector<PatchResult> results(involved.size());
    share_indices(involved.size(),
                  [&](std::size_t i) { results[i] = plan_.mesh_tile(involved[i]); });
    std::vector<PatchMesh> meshes;
    for (PatchResult& result : results) meshes.push_back(std::move(result.mesh));
    for (const auto& [i, turned] : plan_.make_proper(meshes)) results[i].turned = turned;
    for (std::size_t i = 0; i < involved.size(); ++i) {
      results[i].mesh = std::move(meshes[i]);
      if (deal_.rank_of(involved[i]) == rank) take(involved[i], std::move(results[i]));
    }
  }

  /// The summaries of all tiles, in their order.
  std::vector<TileSummary> gather_summaries(Exchange& exchange) const {
    std::vector<TileSummary> mine;
    for (std::size_t t = 0; t < own_.size(); ++t) {
      if (deal_.rank_of(t) == exchange.rank()) mine.push_back(own_[t].summary);
    }
    std::vector<TileSummary> all(tiles().size());
    for (const std::vector<TileSummary>& of_rank : gather_all(exchange, mine)) {
      for (const TileSummary& summary : of_rank) {
        all[static_cast<std::size_t>(summary.tile)] = summary;
      }
    }
    return all;
  }

  /// Put the pieces of this rank together and write them, one after the other.
  void write(Exchange& exchange, const std::vector<TileSummary>& summaries, PieceSink& sink) {
    const StageClock clock(result_.report.seconds[Stage::Write]);
    std::vector<std::int64_t> first_own = {shared_->count()};
    for (const TileSummary& summary : summaries) {
      first_own.push_back(first_own.back() + summary.own_vertices);
    }
    vertices_ = first_own.back();
    agree_on_errors_of(exchange, [&] {
      for (int piece = 0; piece < deal_.pieces; ++piece) {
        if (deal_.rank_of_piece[static_cast<std::size_t>(piece)] != exchange.rank()) continue;
        context_.throw_if_cancelled();
        sink.write(piece, built(piece, first_own));
      }
    });
  }

  MeshPiece built(int piece, const std::vector<std::int64_t>& first_own) {
    PieceBuilder builder;
    for (std::size_t t = 0; t < own_.size(); ++t) {
      if (deal_.piece_of[t] != piece) continue;
      builder.add(t, std::move(own_[t].part));
      own_[t].part = {};
    }
    MeshPiece& mesh = builder.piece();
    const PieceNumbers& numbers = builder.numbers();
    mesh.ids.resize(mesh.points.size());
    std::unordered_map<int, int> vertex_of;
    for (std::size_t i = 0; i < numbers.shared.size(); ++i) {
      const auto vertex = static_cast<std::size_t>(numbers.shared_vertices[i]);
      const int number = numbers.shared[i];
      vertex_of.emplace(number, numbers.shared_vertices[i]);
      mesh.ids[vertex] = shared_->id(number);
      if (shared_->is_on_contour(number)) mesh.points[vertex] = shared_->point(number);
    }
    for (const PieceNumbers::Run& run : numbers.runs) {
      for (int k = 0; k < run.count; ++k) {
        mesh.ids[static_cast<std::size_t>(run.first_vertex + k)] = first_own[run.tile] + k;
      }
    }
    mesh.neighbours = shared_->neighbours(piece);
    for (SharedWithPiece& neighbour : mesh.neighbours) {
      for (int& vertex : neighbour.vertices) vertex = vertex_of.at(vertex);
    }
    return std::move(mesh);
  }

  /// The report of the whole, from the summaries alone.
  void sum_up(Exchange& exchange, const std::vector<TileSummary>& summaries) {
    Report& report = result_.report;
    const SummaryOfTiles all = sum_of(summaries, model_.patches.size());
    report.mesh.vertices = static_cast<std::size_t>(vertices_);
    report.mesh.triangles = all.triangles;
    report.mesh.quads = all.quads;
    report.mesh.patches = model_.patches.size();
    report.edges = all.edges;
    report.quality = all.quality;
    report.quads = all.quad_statistics;
    report.lengths = {all.lengths.min, all.lengths.mean, all.lengths.max};
    report.refine = all.refine;
    report.diagonal = model_.diagonal;
    report.tolerance = greatest_tolerance(model_);
    report.worst = place_of(summaries, all.worst, &TileSummary::worst);
    report.worst_quad = place_of(summaries, all.worst_quad, &TileSummary::worst_quad);
    report.worst_quad_in_space =
        place_of(summaries, all.worst_quad_in_space, &TileSummary::worst_quad_in_space);
    if (sizing_.sag > 0) report.sag.asked = sizing_.sag;
    measure_patches(summaries);
    tell(summaries);
    result_.pieces = deal_.pieces;
    result_.ranks = exchange.size();
    result_.seconds_of_ranks = gather_one(exchange, report.seconds.sum());
    result_.faces_of_ranks.assign(static_cast<std::size_t>(exchange.size()), 0);
    for (std::size_t t = 0; t < summaries.size(); ++t) {
      result_.faces_of_ranks[static_cast<std::size_t>(deal_.rank_of(t))] +=
          summaries[t].triangles + summaries[t].quads;
    }
    result_.bytes_sent = sum_all(exchange, exchange.bytes_sent());
  }

  std::optional<Report::WorstFace> place_of(const std::vector<TileSummary>& summaries,
                                            std::ptrdiff_t tile,
                                            FacePlace TileSummary::*place) const {
    if (tile < 0) return {};
    const TileSummary& summary = summaries[static_cast<std::size_t>(tile)];
    const FacePlace& at = summary.*place;
    return Report::WorstFace{model_.patch(static_cast<int>(summary.patch)).name,
                             {at.x, at.y, at.z}};
  }

  void measure_patches(const std::vector<TileSummary>& summaries) {
    Report& report = result_.report;
    const MeshNames names = mesh_names(model_);
    const auto groups = groups_by_patch(names, model_.patches.size());
    report.patches.assign(model_.patches.size(), {});
    for (std::size_t p = 0; p < model_.patches.size(); ++p) {
      PatchMeasure& measure = report.patches[p];
      measure.name = model_.patches[p].name;
      for (const int group : groups[p]) {
        measure.groups.push_back(names.groups[static_cast<std::size_t>(group)].name);
      }
      const double quality = report.quality.min_of_patches[p];
      const double jacobian = report.quads.min_of_patches[p];
      if (std::isfinite(quality)) measure.least_quality = quality;
      if (std::isfinite(jacobian)) measure.least_jacobian = jacobian;
    }
    for (const TileSummary& summary : summaries) {
      PatchMeasure& measure = report.patches[static_cast<std::size_t>(summary.patch)];
      measure.triangles += static_cast<std::size_t>(summary.triangles);
      measure.quads += static_cast<std::size_t>(summary.quads);
      measure.area += summary.area;
    }
  }

  void tell(const std::vector<TileSummary>& summaries) {
    std::vector<char> is_given_up(model_.patches.size(), 0);
    std::vector<detail::TurnedTile> turned;
    for (const TileSummary& summary : summaries) {
      if (summary.is_given_up != 0) is_given_up[static_cast<std::size_t>(summary.patch)] = 1;
      detail::TurnedTile& tile =
          turned.emplace_back(detail::TurnedTile{static_cast<int>(summary.patch), {}});
      tile.turned.count = static_cast<std::size_t>(summary.turned);
      if (summary.has_turned_place == 0) continue;
      const FacePlace& at = summary.turned_at;
      tile.turned.place = TurnedPlace{{summary.turned_u, summary.turned_v},
                                      {at.x, at.y, at.z},
                                      summary.is_turned_by_surface != 0};
    }
    append(detail::notices_of_given_up(model_, is_given_up, context_.element_kind()),
           result_.report.notices);
    if (!options_.quads.is_on) {
      append(detail::notices_of_turned(model_, turned), result_.report.notices);
    }
  }

  const Model& model_;
  const Sources& sources_;
  const PipelineOptions& asked_;
  PipelineOptions options_;
  const PiecesOptions& pieces_;
  const RunContext& context_;
  int ranks_;
  ResolvedSizing sizing_;
  PiecesReport result_;
  detail::MeshPlan plan_;
  std::vector<char> is_turned_;
  Deal deal_;
  std::optional<SharedNumbers> shared_;
  std::vector<OwnTile> own_;  ///< by tile; those of other ranks are empty
  std::mutex mutex_;          ///< of the seconds and queries
  std::int64_t vertices_ = 0;
};

}  // namespace

PiecesReport mesh_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                         const PiecesOptions& pieces, Exchange& exchange, PieceSink& sink,
                         Observer* observer) {
  const auto start = std::chrono::steady_clock::now();
  const RunContext context(observer, options.max_elements, element_kind(options));
  std::optional<PiecesRun> run;
  PiecesReport report;
  agree_on_errors_of(exchange, [&] {
    check(options);
    check(model);
    run.emplace(model, sources, options, pieces, context, exchange.size());
  });
  with_threads(options.threads, [&] {
    agree_on_errors_of(exchange, [&] { run->plan(); });
    report = run->make(exchange, sink);
  });
  report.report.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

PiecesEstimate estimate_pieces(const Model& model, const Sources& sources,
                               const PipelineOptions& options, const PiecesOptions& pieces,
                               int ranks, Observer* observer) {
  check(options);
  check(model);
  const RunContext context(observer, options.max_elements, element_kind(options));
  PiecesRun run(model, sources, options, pieces, context, ranks);
  with_threads(options.threads, [&] { run.plan(); });
  PiecesEstimate estimate;
  estimate.tiles = run.tiles().size();
  estimate.triangles_of_ranks.assign(static_cast<std::size_t>(ranks), 0);
  for (std::size_t t = 0; t < run.tiles().size(); ++t) {
    estimate.triangles += run.tiles()[t].triangles;
    estimate.triangles_of_ranks[static_cast<std::size_t>(run.deal().rank_of(t))] +=
        run.tiles()[t].triangles;
  }
  std::set<int> shared;
  for (int piece = 0; piece < run.deal().pieces; ++piece) {
    for (const SharedWithPiece& neighbour : run.shared().neighbours(piece)) {
      shared.insert(neighbour.vertices.begin(), neighbour.vertices.end());
    }
  }
  estimate.shared_vertices = static_cast<std::int64_t>(shared.size());
  estimate.bytes_sent = static_cast<std::int64_t>(estimate.tiles * sizeof(TileSummary));
  return estimate;
}

}  // namespace surfmesh
