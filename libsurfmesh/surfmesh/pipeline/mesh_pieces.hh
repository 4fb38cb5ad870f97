// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Mesh a model in pieces that are never in one place: each rank meshes the tiles of its pieces and
/// gives them to its sink.
///
/// The pieces together are the mesh of mesh_model without the stage across contours, with the same
/// vertices in the same order: ids are their numbers, and the same faces in the order of tiles.
/// They do not depend on the number of ranks and threads, nor on who makes what. The mesh is
/// another one than that of mesh_model
///
/// - with a sag: triangles of each tile are corrected one by one, once, and the sag of the whole is
///   not measured;
/// - of up to 1,000 quads in several patches: mesh_model makes such a mesh in two ways, and keeps
///   the better one.
///
/// All ranks call this with the same arguments, each with its own exchange and sink. The observer
/// may be null.
///
/// Returns  the report of the whole mesh, with Report::pieces; the same on all ranks but for its
///          seconds, and for the queries of their tiles
/// Error    of the report: see TileSummary. The mesh is closed, and has an Euler characteristic, as
///          pieces are joined by ids: vertices along contours at which mesh_model has to cut are
///          one
/// Cost     40 bytes a triangle of the rank, besides the model and the control spaces of its
///          patches; before tiles are meshed, those of all patches
/// Throws   AgreedError, the same on all ranks, for what mesh_model throws: in tiles that of the
///          first one, whatever the ranks and threads; in a cancelled run nothing but Cancelled
Report mesh_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                   const PiecesOptions& pieces, Exchange& exchange, PieceSink& sink,
                   Observer* observer = nullptr);

/// Foretell how a number of ranks would mesh a model in pieces, from its tiles alone: as
/// estimate_mesh does, with Report::tiles and Report::pieces.
///
/// Error    of the faces of a rank: that of the estimated elements. The bytes sent are fewer than
/// in
///          the run, mostly by 1 to 3 %, by a fifth where sizes change fast: chords between nodes
///          on boundaries are not known yet (`Pieces.AreForetold`), and the sink is not
/// Cost     that of mesh_pieces before any tile is meshed
/// Throws   as mesh_model
Report estimate_pieces(const Model& model, const Sources& sources, const PipelineOptions& options,
                       const PiecesOptions& pieces, int ranks, Observer* observer = nullptr);

}  // namespace surfmesh
