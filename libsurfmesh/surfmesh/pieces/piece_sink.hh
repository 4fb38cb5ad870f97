// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/pieces/mesh_piece.hh"

namespace surfmesh {

/// What is known of a mesh before its pieces come.
struct PieceIndex {
  int pieces = 0;          ///< of the whole mesh, on all ranks
  int patches = 0;         ///< of the model
  bool has_quads = false;  ///< perhaps with triangles among them; else triangles only
  MeshNames names = {};    ///< of the patches and contours of the model, and groups of patches
};

/// Takes the pieces of a mesh, each on the rank that makes it.
///
/// All ranks call begin() and finish() together, for both may exchange something. They leave by an
/// AgreedError if one of them fails on any rank. An Error of write() is of its rank alone: who
/// calls it has to tell the others before they meet again.
class PieceSink {
 public:
  virtual ~PieceSink() = default;

  /// Called once, before all pieces.
  virtual void begin(const PieceIndex& index) = 0;

  /// Take a piece of this rank, pieces with ascending numbers; by one thread at a time.
  virtual void write(int piece, const MeshPiece& mesh) = 0;

  /// Called once, after all pieces. All that could not be written is told by now.
  virtual void finish() = 0;
};

}  // namespace surfmesh
