// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/formats/piece_output.hh"

namespace surfmesh {

/// Writes a mesh into a folder: NAME.pvtu, and NAME_0000.vtu, NAME_0001.vtu ... for the pieces,
/// where NAME is that of the folder.
///
/// All or nothing: the pieces of all ranks go to a temporary folder, .surfmesh-N.tmp beside it,
/// that takes its place in the end. All ranks have to see the same file system. What was in the
/// folder, if anything, must be such an output; it is replaced. Without a commit the temporary
/// folder is removed, by whichever rank comes last, and the old one stays as it was.
class PieceFolder final : public PieceOutput {
 public:
  /// Called by all ranks, as all functions but write(). The exchange must outlive this.
  PieceFolder(std::filesystem::path folder, Exchange& exchange);
  ~PieceFolder() override;

  /// Throws   AgreedError of code Io: there is no folder for it, it has other files in it, no
  ///          temporary folder can be made
  void begin(const PieceIndex& index) override;

  /// Cost     see write_vtu_piece
  /// Throws   Io; Geometry for a position that is not finite
  void write(int piece, const MeshPiece& mesh) override;

  /// Throws   AgreedError of code Io
  void finish() override;

  /// Throws   AgreedError of code Io, as where the folder has got other files since begin()
  void commit(OutputFile* with) override;
  std::filesystem::path temporary() const override { return temporary_; }

 private:
  std::string piece_name(int piece) const;
  void check_old() const;
  void make_temporary();
  template <class Write>
  void write_file(const std::string& name, Write write) const;
  void publish();
  void take_back();

  std::filesystem::path given_;   ///< for messages
  std::filesystem::path folder_;  ///< absolute, with links followed
  std::string name_;
  Exchange& exchange_;
  PieceIndex index_;
  std::filesystem::path temporary_;
  std::filesystem::path old_;  ///< the old folder under another name; empty for none
};

}  // namespace surfmesh
