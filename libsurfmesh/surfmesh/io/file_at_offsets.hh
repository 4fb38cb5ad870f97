// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A file into which several processes write, each to its own bytes. The file system must keep what
/// they write at the same time apart: those of one machine and of clusters (Lustre, GPFS, BeeGFS)
/// do, NFS need not.
class FileAtOffsets {
 public:
  /// Open a file that is there; `told` stands in messages.
  /// Throws   Io with the reason
  FileAtOffsets(const std::filesystem::path& path, const std::filesystem::path& told);
  ~FileAtOffsets();
  FileAtOffsets(const FileAtOffsets&) = delete;
  FileAtOffsets& operator=(const FileAtOffsets&) = delete;

  /// Throws   Io with the reason
  void write(std::string_view bytes, std::uint64_t offset);

  /// All of it is on its way to the disk. Nothing may be written afterwards.
  /// Throws   Io with the reason
  void close();

 private:
  std::filesystem::path told_;
  int file_ = -1;
};

}  // namespace surfmesh
