// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/formats/mesh_format.hh"

namespace surfmesh {

/// How a format writes names, all of which are to differ.
struct WordRule {
  std::string (*word_of)(std::string_view name);  ///< a name by itself
  bool has_case = true;                           ///< "Rim" and "rim" differ
  std::span<const std::string_view> taken = {};   ///< words that the file has besides
};

/// The names of a mesh as the words of a file; empty for no name.
struct FileWords {
  std::vector<std::string> patches;
  std::vector<std::string> groups;
  std::vector<std::string> contours;
};

/// The words for all names. Those that would be the same get a number: "rim_2".
FileWords file_words(const MeshNames& names, const WordRule& rule);

/// Names that are other words, but for those of contours that have no edges.
///
/// Reads    surf:contour (edge; optional)
std::vector<ChangedName> changed_words(const PolyMesh& mesh, const MeshNames& names,
                                       const WordRule& rule);

/// Add to what is lost the names that are changed.
void add_changed_words(const PolyMesh& mesh, const MeshNames& names, const WordRule& rule,
                       std::vector<std::string>& lost);

/// The same where it is known which ones are.
void add_changed(const std::vector<ChangedName>& changed, std::vector<std::string>& lost);

/// A name as a part of one line: bytes below 32 and 127 are blanks.
std::string one_line(std::string_view name);

/// At most so many bytes of a text, without a part of a character of UTF-8 at the end.
std::string shortened(std::string text, std::size_t bytes);

}  // namespace surfmesh
