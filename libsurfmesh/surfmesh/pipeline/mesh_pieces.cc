// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/mesh_pieces.hh"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/core/freed_memory.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/pieces/number_piece.hh"
#include "surfmesh/pieces/piece_builder.hh"
#include "surfmesh/pipeline/do_or_cancel.hh"
#include "surfmesh/pipeline/own_tiles.hh"
#include "surfmesh/pipeline/pieces_plan.hh"
#include "surfmesh/pipeline/pieces_report.hh"

namespace surfmesh {
namespace {

/// Bytes of parts of tiles that are added to a piece before their memory is given back: a rank with
/// one large piece would else need twice as much.
constexpr std::size_t kBytesAtOnce = std::size_t{8} << 20;

std::size_t bytes_of(const TilePart& part) {
  return part.points.size() * sizeof(Vec3) + part.faces.corner_count() * sizeof(int);
}

/// What a rank does once it is known who meshes which tile.
class PiecesRun {
 public:
  PiecesRun(detail::PiecesPlan& plan, Exchange& exchange, PieceSink& sink)
      : plan_(plan), exchange_(exchange), sink_(sink), tiles_(plan, exchange) {}

  Report make() {
    PieceIndex index;
    agree_on_errors_of(exchange_, [&] { index = piece_index(); });
    sink_.begin(index);
    tiles_.mesh();
    tiles_.mend_edges();
    const std::vector<TileSummary> summaries = tiles_.gather_summaries();
    std::vector<std::int64_t> first_own;
    agree_on_errors_of(exchange_, [&] { first_own = first_own_ids(summaries, plan_.shared()); });
    double writing = 0;
    write(first_own, writing);
    sink_.finish();
    Report report;
    agree_on_errors_of(exchange_, [&] {
      report = plan_.report();
      report.seconds += tiles_.seconds();
      report.seconds[Stage::Write] += writing;
      report.control.queries += tiles_.queries();
      detail::report_tiles(plan_, summaries, first_own.back(), report);
    });
    report.pieces = pieces(summaries, report.seconds.sum());
    return report;
  }

 private:
  PieceIndex piece_index() const {
    return {.pieces = plan_.deal().pieces,
            .patches = static_cast<int>(plan_.model().patches.size()),
            .has_quads = plan_.options().quads.is_on,
            .names = mesh_names(plan_.model())};
  }

  /// Put the pieces of this rank together and write them, one after the other.
  void write(const std::vector<std::int64_t>& first_own, double& seconds) {
    const StageClock clock(seconds);
    agree_on_errors_of(exchange_, [&] {
      for (int piece = 0; piece < plan_.deal().pieces; ++piece) {
        const int rank = plan_.deal().rank_of_piece[static_cast<std::size_t>(piece)];
        if (rank != exchange_.rank()) continue;
        plan_.context().throw_if_cancelled();
        sink_.write(piece, built(piece, first_own));
      }
    });
  }

  MeshPiece built(int piece, const std::vector<std::int64_t>& first_own) {
    PieceBuilder builder;
    const std::vector<std::size_t> tiles = tiles_of(piece);
    make_room(tiles, builder);
    return_freed_memory();  // of the meshes of tiles
    std::size_t freed = 0;
    for (const std::size_t t : tiles) {
      freed += bytes_of(tiles_.part(t));
      builder.add(t, tiles_.take_part(t));
      if (freed < kBytesAtOnce) continue;
      return_freed_memory();
      freed = 0;
    }
    return numbered(std::move(builder), piece, plan_.shared(), first_own);
  }

  std::vector<std::size_t> tiles_of(int piece) const {
    std::vector<std::size_t> tiles;
    for (std::size_t t = 0; t < plan_.tiles().size(); ++t) {
      if (plan_.deal().piece_of[t] == piece) tiles.push_back(t);
    }
    return tiles;
  }

  void make_room(const std::vector<std::size_t>& tiles, PieceBuilder& builder) const {
    std::size_t vertices = 0, faces = 0, corners = 0;
    for (const std::size_t t : tiles) {
      const TilePart& part = tiles_.part(t);
      vertices += part.points.size();
      faces += part.faces.size();
      corners += part.faces.corner_count();
    }
    builder.reserve(vertices, faces, corners);
  }

  Report::Pieces pieces(const std::vector<TileSummary>& summaries, double seconds) {
    Report::Pieces pieces;
    detail::count_shared(plan_, pieces);
    pieces.seconds_of_ranks = gather_one(exchange_, seconds);
    pieces.faces_of_ranks.assign(static_cast<std::size_t>(exchange_.size()), 0);
    for (std::size_t t = 0; t < summaries.size(); ++t) {
      const auto rank = static_cast<std::size_t>(plan_.deal().rank_of(t));
      pieces.faces_of_ranks[rank] +=
          static_cast<std::size_t>(summaries[t].triangles + summaries[t].quads);
    }
    pieces.bytes_sent = static_cast<std::size_t>(sum_all(exchange_, exchange_.bytes_sent()));
    return pieces;
  }

  detail::PiecesPlan& plan_;
  Exchange& exchange_;
  PieceSink& sink_;
  detail::OwnTiles tiles_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What OwnTiles exchanges but for chords, and the seconds.
std::size_t bytes_to_send(const std::vector<Tile>& tiles, std::size_t ranks) {
  if (ranks == 1) return 0;
  const std::size_t of_rank = sizeof(std::int64_t) + sizeof(double);
  return ranks * of_rank + tiles.size() * sizeof(TileSummary);
}

Report::Pieces foretold(const detail::PiecesPlan& plan, std::size_t ranks) {
  const double elements = elements_per_triangle(plan.context().element_kind());
  std::vector<double> of_ranks(ranks, 0);
  for (std::size_t t = 0; t < plan.tiles().size(); ++t) {
    of_ranks[static_cast<std::size_t>(plan.deal().rank_of(t))] +=
        elements * plan.tiles()[t].triangles;
  }
  Report::Pieces pieces;
  detail::count_shared(plan, pieces);
  for (const double faces : of_ranks) {
    pieces.faces_of_ranks.push_back(static_cast<std::size_t>(std::llround(faces)));
  }
  pieces.bytes_sent = bytes_to_send(plan.tiles(), ranks);
  return pieces;
}

}  // namespace

Report mesh_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                   const PiecesOptions& pieces, Exchange& exchange, PieceSink& sink,
                   Observer* observer) try {
  const auto start = std::chrono::steady_clock::now();
  const RunContext context(observer, options.max_elements, element_kind(options));
  std::optional<detail::PiecesPlan> plan;
  agree_on_errors_of(exchange, [&] {
    check(options);
    check(model);
    plan.emplace(model, sources, options, context);
  });
  Report report;
  double serial_seconds = 0;
  with_threads(options.threads, [&] {
    const SerialClock clock(serial_seconds);
    std::optional<PiecesRun> run;
    agree_on_errors_of(exchange, [&] {
      detail::do_or_cancel(context, "tiles", [&] { plan->make(pieces, exchange.size()); });
      run.emplace(*plan, exchange, sink);
    });
    report = run->make();
  });
  report.serial_seconds = serial_seconds;
  report.wall_seconds = seconds_since(start);
  return report;
} catch (const std::bad_alloc&) {
  fail_without_memory("while meshing");
}

Report estimate_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                       const PiecesOptions& pieces, int ranks, Observer* observer) try {
  const auto start = std::chrono::steady_clock::now();
  check(options);
  check(model);
  const RunContext context(observer, options.max_elements, element_kind(options));
  detail::PiecesPlan plan(model, sources, options, context);
  double serial_seconds = 0;
  with_threads(options.threads, [&] {
    const SerialClock clock(serial_seconds);
    plan.make(pieces, ranks);
  });
  Report report = plan.report();
  report.pieces = foretold(plan, static_cast<std::size_t>(ranks));
  report.mesh.patches = model.patches.size();
  report.serial_seconds = serial_seconds;
  report.wall_seconds = seconds_since(start);
  return report;
} catch (const std::bad_alloc&) {
  fail_without_memory("while estimating");
}

}  // namespace surfmesh
