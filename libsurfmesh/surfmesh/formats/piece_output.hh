// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/io/output_file.hh"
#include "surfmesh/pieces/piece_sink.hh"

namespace surfmesh {

/// Writes a mesh that comes in pieces: all of it appears, or nothing.
class PieceOutput : public PieceSink {
 public:
  /// Put what was written in its place, and another file with it: both appear, or none does. Called
  /// by all ranks; the file is that of rank 0, which may be null, as it is for all others.
  /// Throws   AgreedError of code Io; what was there before then stays
  virtual void commit(OutputFile* with) = 0;

  /// The file or folder that a rank has to remove if it ends at once, without destroying this;
  /// empty for none, which it is before begin() and after commit().
  virtual std::filesystem::path temporary() const = 0;
};

}  // namespace surfmesh
