// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/obj_groups.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/obj_labels.hh"
#include "surfmesh/formats/patch_numbers.hh"

namespace surfmesh {
namespace {

/// A name as one word of an OBJ file, where blanks part the names of several groups.
std::string word_of(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
  }
  if (name.empty()) return name;
  if (name.front() == '#') name.front() = '_';
  if (name.back() == '\\') name.back() = '_';
  return name;
}

/// True if patches come up in the order of their numbers, without gaps, in the faces.
bool are_in_order(std::span<const int> patches, std::size_t count) {
  int seen = 0;
  for (const int patch : patches) {
    if (patch > seen) return false;
    if (patch == seen) ++seen;
  }
  return seen == static_cast<int>(count);
}

/// The material of each patch, if all have one, its groups, then the patch itself.
std::vector<std::string> group_lines(const MeshNames& names, std::size_t count) {
  std::vector<std::string> lines;
  const ObjWords words(names, count);
  const auto groups = groups_by_patch(names, count);
  const auto is_material = [&](int group) {
    return names.groups[static_cast<std::size_t>(group)].is_material;
  };
  const bool has_materials =
      std::all_of(groups.begin(), groups.end(), [&](const std::vector<int>& of_patch) {
        return std::count_if(of_patch.begin(), of_patch.end(), is_material) == 1;
      });
  for (std::size_t p = 0; p < count; ++p) {
    std::string& line = lines.emplace_back();
    if (has_materials) {
      const int group = *std::find_if(groups[p].begin(), groups[p].end(), is_material);
      line.append("\nusemtl ").append(words.groups[static_cast<std::size_t>(group)]);
    }
    line += "\ng ";
    for (const int group : groups[p]) {
      if (has_materials && is_material(group)) continue;
      line.append(words.groups[static_cast<std::size_t>(group)]).append(" ");
    }
    line += words.patches[p];
  }
  return lines;
}

}  // namespace

ObjWords::ObjWords(const MeshNames& names, std::size_t patch_count) {
  DifferentNames different;
  different.add(kNoGroup);  // means faces without a patch
  for (std::size_t p = 0; p < patch_count; ++p) {
    const bool has_name = p < names.patches.size() && !names.patches[p].empty();
    patches.push_back(
        different.add(has_name ? word_of(names.patches[p]) : fmt::format("patch{}", p)));
  }
  DifferentNames different_groups;
  for (const Group& group : names.groups) {
    const std::string word = word_of(group.name);
    groups.push_back(different_groups.add(word.empty() ? "group" : word));
  }
}

ObjGroups::ObjGroups(std::span<const int> patches, const MeshNames& names) {
  const int most = patches.empty() ? -1 : *std::max_element(patches.begin(), patches.end());
  if (most > kMostPatches) {
    throw Error(ErrorCode::InvalidInput, fmt::format("a face is of patch {}, but OBJ files hold "
                                                     "patches up to {}",
                                                     most, kMostPatches));
  }
  lines_ = group_lines(names, std::max(names.patches.size(), static_cast<std::size_t>(most + 1)));
}

std::string ObjGroups::before_faces(std::span<const int> patches) const {
  std::string text;
  if (are_in_order(patches, lines_.size())) return text;
  for (const std::string& line : lines_) text += line;
  return text;
}

}  // namespace surfmesh
