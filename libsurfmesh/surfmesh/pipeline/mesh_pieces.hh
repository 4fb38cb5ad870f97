// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "surfmesh/core/observer.hh"
#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/pieces/partition.hh"
#include "surfmesh/pieces/piece_sink.hh"
#include "surfmesh/pipeline/options.hh"
#include "surfmesh/pipeline/report.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// How a mesh is divided into pieces.
struct PiecesOptions {
  /// Number of pieces. 0 is one for each rank; for a single rank, one for each two million
  /// triangles.
  int pieces = 0;
  /// Deals tiles to pieces; null for runs of tiles that follow each other.
  DealTiles deal = nullptr;
};

/// What a run in pieces made, and what it took.
struct PiecesReport {
  Report report;  ///< of the whole mesh, the same on all ranks but for its seconds
  int pieces = 0;
  int ranks = 1;
  std::int64_t bytes_sent = 0;               ///< by all ranks
  std::vector<std::int64_t> faces_of_ranks;  ///< by rank
  std::vector<double> seconds_of_ranks;      ///< processor time, likewise
};

/// Mesh a model in pieces that are never in one place: each rank meshes the tiles of its pieces and
/// gives them to its sink.
///
/// The pieces together are the mesh of mesh_model without the stage across contours, with the same
/// vertices in the same order: ids are their numbers, and the same faces in the order of tiles.
/// They do not depend on the number of ranks and threads, nor on who makes what. With a sag,
/// triangles of each tile are corrected one by one; the sag of the whole is not measured.
///
/// All ranks call this with the same arguments, each with its own exchange and sink. The observer
/// may be null.
///
/// Error    of the report: see TileSummary
/// Cost     40 bytes a triangle of the rank, besides the model and its control spaces, which every
///          rank holds
/// Throws   AgreedError, the same on all ranks, for what mesh_model throws
PiecesReport mesh_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                         const PiecesOptions& pieces, Exchange& exchange, PieceSink& sink,
                         Observer* observer = nullptr);

/// How the triangles of a model would be dealt to ranks, and what would be exchanged: from its
/// tiles alone.
struct PiecesEstimate {
  std::size_t tiles = 0;
  double triangles = 0;
  std::vector<double> triangles_of_ranks;
  std::int64_t shared_vertices = 0;  ///< that several pieces have
  std::int64_t bytes_sent = 0;       ///< by all ranks together
};

/// Throws   as mesh_pieces
PiecesEstimate estimate_pieces(const Model& model, const Sources& sources,
                               const PipelineOptions& options, const PiecesOptions& pieces,
                               int ranks, Observer* observer = nullptr);

}  // namespace surfmesh
