// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/formats/piece_file_layout.hh"
#include "surfmesh/formats/piece_output.hh"
#include "surfmesh/formats/piece_text.hh"
#include "surfmesh/io/spool_file.hh"

namespace surfmesh {

/// Writes a mesh that comes in pieces to one file of a format that has a PieceText: the bytes that
/// write_mesh writes of the whole mesh.
///
/// Each rank keeps the text of its pieces on the disk, beside the file. In the end all write to
/// their places in a temporary file, which replaces the old one. All ranks have to see the same
/// file system.
class PieceFile final : public PieceOutput {
 public:
  /// Called by all ranks, as all functions but write(). The exchange must outlive this.
  PieceFile(std::filesystem::path path, Exchange& exchange);

  /// Throws   AgreedError: Io if no file can be created there; what piece_text throws
  void begin(const PieceIndex& index) override;

  /// Cost     0.15 µs a triangle
  /// Throws   Io; Geometry for a position that is not finite
  void write(int piece, const MeshPiece& mesh) override;

  /// Cost     the text is copied once
  /// Throws   AgreedError: Io; Limit if the format cannot number so many vertices
  void finish() override;

  void commit(OutputFile* with) override;
  std::filesystem::path temporary() const override { return temporary_; }

 private:
  void make_file(const PieceIndex& index);
  void add_vertices(const MeshPiece& mesh, const std::vector<std::size_t>& own);
  void add_faces(int piece, const MeshPiece& mesh);
  void write_all(const PieceFileLayout& layout);

  std::filesystem::path path_;
  Exchange& exchange_;
  std::unique_ptr<PieceText> text_;
  std::unique_ptr<OutputFile> file_;  ///< of rank 0
  std::filesystem::path temporary_;
  std::optional<SpoolFile> vertices_, faces_;
  PieceFileParts parts_;  ///< of this rank
};

}  // namespace surfmesh
