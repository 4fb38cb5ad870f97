// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A file that is written completely or not at all.
///
/// Everything is written to a temporary file in the same folder. commit() replaces the old file by
/// it and keeps the permissions. Without a commit, the temporary file is removed and the old one
/// stays as it was. Links are followed; devices and pipes are written directly.
class OutputFile {
 public:
  /// Throws   Io if no file can be created there: the folder is missing, the path is a folder, the
  ///          file is write-protected
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();

  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Throws   Io, naming the file and the reason
  void write(std::string_view text);

  /// For writers that need a stream; commit() detects its errors.
  std::ostream& stream() { return file_; }

  /// Finish the file. Nothing may be written afterwards.
  /// Throws   Io if anything could not be written; the old file then stays
  void commit();

 private:
  void open_temporary();
  [[noreturn]] void fail();

  std::filesystem::path path_;       ///< as given, for messages
  std::filesystem::path target_;     ///< with links followed
  std::filesystem::path temporary_;  ///< empty if the target is written directly
  std::unique_ptr<char[]> buffer_;   ///< of the file
  std::ofstream file_;
};

/// Write a file completely or not at all.
/// Throws   Io, naming the file and the reason
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace surfmesh
