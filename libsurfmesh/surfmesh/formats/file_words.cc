// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/file_words.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/obj_labels.hh"

namespace surfmesh {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// Makes words differ.
class DifferentWords {
 public:
  explicit DifferentWords(const WordRule& rule) : rule_(rule) {
    for (const std::string_view word : rule.taken) different_.add(lower_case(std::string(word)));
  }

  std::string add(const std::string& name) {
    if (name.empty()) return {};
    const std::string word = rule_.word_of(name);
    if (rule_.has_case) return different_.add(word);
    return word + different_.add(lower_case(word)).substr(word.size());
  }

 private:
  const WordRule& rule_;
  DifferentNames different_;
};

/// Whether each of so many contours has edges in a mesh.
std::vector<char> contours_with_edges(const PolyMesh& mesh, std::size_t count) {
  std::vector<char> has_edges(count, 0);
  const auto contour_of = find(mesh, keys::edge_contour);
  if (!contour_of.is_valid()) return has_edges;
  for (const int contour : mesh.property(contour_of).data_vector()) {
    if (contour >= 0 && static_cast<std::size_t>(contour) < count) {
      has_edges[static_cast<std::size_t>(contour)] = 1;
    }
  }
  return has_edges;
}

}  // namespace

FileWords file_words(const MeshNames& names, const WordRule& rule) {
  FileWords words;
  DifferentWords different(rule);
  for (const std::string& name : names.patches) words.patches.push_back(different.add(name));
  for (const Group& group : names.groups) words.groups.push_back(different.add(group.name));
  for (const std::string& name : names.contours) words.contours.push_back(different.add(name));
  return words;
}

std::vector<ChangedName> changed_words(const PolyMesh& mesh, const MeshNames& names,
                                       const WordRule& rule) {
  const FileWords words = file_words(names, rule);
  std::vector<ChangedName> changed;
  const auto compare = [&](const std::string& name, const std::string& word) {
    if (name != word) changed.push_back({name, word});
  };
  for (std::size_t p = 0; p < words.patches.size(); ++p) {
    compare(names.patches[p], words.patches[p]);
  }
  for (std::size_t g = 0; g < words.groups.size(); ++g) {
    compare(names.groups[g].name, words.groups[g]);
  }
  const std::vector<char> has_edges = contours_with_edges(mesh, words.contours.size());
  for (std::size_t c = 0; c < words.contours.size(); ++c) {
    if (has_edges[c] != 0) compare(names.contours[c], words.contours[c]);
  }
  return changed;
}

void add_changed_words(const PolyMesh& mesh, const MeshNames& names, const WordRule& rule,
                       std::vector<std::string>& lost) {
  add_changed(changed_words(mesh, names, rule), lost);
}

void add_changed(const std::vector<ChangedName>& changed, std::vector<std::string>& lost) {
  if (changed.empty()) return;
  lost.push_back(fmt::format("{} as they are, the first: {} is {}",
                             counted(changed.size(), "name", "names"), changed.front().name,
                             changed.front().word));
}

std::string one_line(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  }
  return text;
}

std::string shortened(std::string text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  const auto is_inside_character = [&](std::size_t place) {
    return (static_cast<unsigned char>(text[place]) & 0xC0U) == 0x80U;
  };
  while (bytes > 0 && is_inside_character(bytes)) --bytes;
  text.resize(bytes);
  return text;
}

}  // namespace surfmesh
