// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/ply_head.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "surfmesh/io/text_buffer.hh"

namespace surfmesh {
namespace {

/// Gmsh takes 255 bytes for a line, VTK 4095: longer names go on in the next comment.
constexpr std::size_t kLongestName = 200;

/// Patches of a group in one comment, likewise.
constexpr std::size_t kPatchesPerLine = 20;

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

/// Add a name in comments of one line each, cut between letters.
void add_name(std::string_view before, std::size_t number, std::string name, TextBuffer& buffer) {
  std::replace_if(name.begin(), name.end(), is_control, ' ');
  std::string_view rest = name;
  do {
    std::size_t size = std::min(rest.size(), kLongestName);
    const auto is_inside_letter = [&] {
      return size < rest.size() && (static_cast<unsigned char>(rest[size]) & 0xC0) == 0x80;
    };
    while (size > kLongestName / 2 && is_inside_letter()) --size;
    buffer.text(before);
    buffer.number(' ', number);
    buffer.text(" ");
    buffer.text(rest.substr(0, size));
    rest.remove_prefix(size);
  } while (!rest.empty());
}

void add_names(const MeshNames& names, TextBuffer& buffer) {
  for (std::size_t p = 0; p < names.patches.size(); ++p) {
    add_name("\ncomment patch", p, names.patches[p], buffer);
  }
  for (std::size_t g = 0; g < names.groups.size(); ++g) {
    add_name("\ncomment group", g, names.groups[g].name, buffer);
  }
  for (std::size_t g = 0; g < names.groups.size(); ++g) {
    const std::vector<int>& patches = names.groups[g].patches;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (i % kPatchesPerLine == 0) {
        buffer.text("\ncomment patches");
        buffer.number(' ', g);
      }
      buffer.number(' ', patches[i]);
    }
  }
}

void add_runs(std::span<const int> patches, TextBuffer& buffer) {
  for (std::size_t begin = 0, end = 0; begin < patches.size(); begin = end) {
    while (end < patches.size() && patches[end] == patches[begin]) ++end;
    buffer.text("\ncomment faces");
    buffer.number(' ', end - begin);
    buffer.number(' ', patches[begin]);
  }
}

}  // namespace

bool can_be_in_ply(const std::string& name) {
  return std::none_of(name.begin(), name.end(), is_control);
}

std::string ply_head(const PlyHead& head) {
  TextBuffer buffer;
  buffer.text("ply\nformat ascii 1.0\ncomment surfmesh");
  if (head.names) add_names(*head.names, buffer);
  add_runs(head.runs, buffer);
  buffer.text("\nelement vertex");
  buffer.number(' ', head.vertices);
  buffer.text("\nproperty double x\nproperty double y\nproperty double z\nelement face");
  buffer.number(' ', head.faces);
  const bool is_small = head.most_corners <= std::numeric_limits<std::uint8_t>::max();
  buffer.text(fmt::format("\nproperty list {} int vertex_indices", is_small ? "uchar" : "int"));
  if (head.has_patch_values) buffer.text("\nproperty int patch");
  buffer.text("\nend_header");
  return std::string(buffer.text());
}

}  // namespace surfmesh
