// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surfmesh::testing {

/// A source file as lines; line numbers count from 1.
struct SourceFile {
  std::string path;    ///< from the folder that is looked through on: "core/mesh.hh"
  std::string folder;  ///< "core"; empty at the top
  std::vector<std::string> lines;
  std::vector<std::string> code;  ///< the lines without their comments
};

/// All .hh and .cc files of the library, and those that CMake fills in (.hh.in), in the order of
/// their paths.
std::vector<SourceFile> library_sources();

/// Those of the library and of the optional ones beside it.
std::vector<SourceFile> library_sources_with_parts();

/// All .hh and .cc files of the project, from its root on, in the order of their paths.
std::vector<SourceFile> project_sources();

/// The text of a file, whose path is from the root of the project on.
std::string text_of_file(const std::string& path);

/// Text split into lines, and the same without comments; strings and characters are kept.
std::vector<std::string> lines_of(std::string_view text);
std::string without_comments(std::string_view text);

/// The text with the contents of its string literals taken out.
std::string without_strings(std::string_view text);

/// "core/mesh.hh:12: text" for messages.
std::string place(const SourceFile& file, std::size_t line_index);

}  // namespace surfmesh::testing
