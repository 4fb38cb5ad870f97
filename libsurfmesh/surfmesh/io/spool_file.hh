// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "surfmesh/io/file_at_offsets.hh"

namespace surfmesh {

/// Bytes that wait on the disk until it is known where they belong. The file has no name, so that
/// nothing is left of it, whatever ends the program.
class SpoolFile {
 public:
  /// Make a file on the disk of `folder`.
  /// Throws   Io with the reason
  explicit SpoolFile(const std::filesystem::path& folder);
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  /// Throws   Io with the reason
  void write(std::string_view bytes);

  /// Bytes that it has.
  std::uint64_t size() const { return size_; }

  /// Write `count` bytes from `first` on to another file.
  /// Throws   Io with the reason
  void copy(std::uint64_t first, std::uint64_t count, FileAtOffsets& to,
            std::uint64_t offset) const;

 private:
  std::filesystem::path folder_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace surfmesh
