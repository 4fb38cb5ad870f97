// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/formats/piece_text.hh"

namespace surfmesh {

/// Vertices with ids that follow each other.
struct VertexRun {
  std::int64_t first_id;
  std::int64_t count;
  std::uint64_t bytes;
};

/// The faces of a piece, without what stands before the first of them.
struct FaceText {
  int piece;
  int first_patch;
  int last_patch;
  std::int64_t faces;
  std::uint64_t bytes;
};

/// The patch of faces in a row of a piece.
struct PatchOfFaces {
  int piece;
  int patch;
};

/// The parts that a file is made of, in the order in which ranks have written them.
struct PieceFileParts {
  std::vector<VertexRun> vertices;
  std::vector<FaceText> faces;  ///< but of pieces without
  std::vector<PatchOfFaces> patches;
};

/// The parts of all ranks, in the order of the file.
PieceFileParts parts_of_all_ranks(Exchange& exchange, const PieceFileParts& mine);

/// Where the parts stand in a file.
struct PieceFileLayout {
  /// The text of the faces of a piece.
  struct Place {
    std::uint64_t offset;
    std::string_view before;  ///< what stands there before the faces; the text must outlive it
  };

  std::string head;  ///< where the file begins
  std::string before_faces;
  std::uint64_t before_faces_offset = 0;
  std::map<std::int64_t, std::uint64_t> vertices;  ///< by the first id of a run
  std::map<int, Place> faces;                      ///< by piece
  std::uint64_t end = 0;
};

/// Lay out a file. `parts` are those of all ranks.
/// Throws   Limit if the format cannot number so many vertices
PieceFileLayout lay_out(const PieceFileParts& parts, const PieceText& text);

}  // namespace surfmesh
