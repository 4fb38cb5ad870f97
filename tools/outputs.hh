// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <filesystem>

#include "signals.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh {

/// The files that a command writes: all of them appear, or none does, whatever stops the command.
class Outputs {
 public:
  /// A file to write to. It lives as long as this.
  /// Throws   Io if no file can be created there
  OutputFile& add(const std::filesystem::path& path);

  /// Put all files in their places. The command is done then, with this exit status.
  /// Throws   Io, Cancelled; there are no new files then
  void commit(int status);

 private:
  struct Output {
    explicit Output(const std::filesystem::path& path) : file(path), guard(file.temporary()) {}

    OutputFile file;
    RemovedOnSignal guard;
  };

  std::deque<Output> outputs_;
};

}  // namespace surfmesh
