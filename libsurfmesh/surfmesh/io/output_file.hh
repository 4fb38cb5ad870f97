// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
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

  /// The path as it was given.
  const std::filesystem::path& path() const { return path_; }

  /// Where it is written before the commit; empty if it is written directly.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Throws   Io, naming the file and the reason
  void write(std::string_view text);

  /// For writers that need a stream; finish() detects its errors.
  std::ostream& stream() { return file_; }

  /// Close the file: all of it is on its way to the disk. Nothing may be written afterwards.
  /// Throws   Io if anything could not be written; the old file then stays
  void finish();

  /// Finish the file, and put it in the place of the old one.
  /// Throws   Io; the old file then stays
  void commit();

  /// Commit several files: all of them appear, or none does. All are finished before the first old
  /// file is replaced, and old files come back if a later one cannot be replaced.
  /// Throws   Io; the old files then stay
  static void commit_all(std::span<OutputFile* const> files);

 private:
  void open_temporary();
  void keep_old();
  void drop_old();
  void publish();
  void take_back();
  [[noreturn]] void fail();

  std::filesystem::path path_;       ///< as given, for messages
  std::filesystem::path target_;     ///< with links followed
  std::filesystem::path temporary_;  ///< empty if the target is written directly
  std::filesystem::path old_;        ///< the old file under another name; empty for none
  bool is_published_ = false;
  std::unique_ptr<char[]> buffer_;  ///< of the file
  std::ofstream file_;
};

/// Write a file completely or not at all.
/// Throws   Io, naming the file and the reason
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace surfmesh
