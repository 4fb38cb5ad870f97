// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_file_layout.hh"

#include <algorithm>
#include <optional>

namespace surfmesh {
namespace {

/// What all ranks have, ascending by a member, in their order where that is the same.
template <class Part, class Key>
std::vector<Part> gather_sorted(Exchange& exchange, const std::vector<Part>& mine, Key Part::*key) {
  std::vector<Part> all;
  for (const std::vector<Part>& of_rank : gather_all(exchange, mine)) {
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  }
  std::ranges::stable_sort(all, {}, key);
  return all;
}

}  // namespace

PieceFileParts parts_of_all_ranks(Exchange& exchange, const PieceFileParts& mine) {
  return {gather_sorted(exchange, mine.vertices, &VertexRun::first_id),
          gather_sorted(exchange, mine.faces, &FaceText::piece),
          gather_sorted(exchange, mine.patches, &PatchOfFaces::piece)};
}

PieceFileLayout lay_out(const PieceFileParts& parts, const PieceText& text) {
  std::int64_t vertex_count = 0, face_count = 0;
  for (const VertexRun& run : parts.vertices) vertex_count += run.count;
  for (const FaceText& faces : parts.faces) face_count += faces.faces;
  std::vector<int> patches;
  for (const PatchOfFaces& faces : parts.patches) patches.push_back(faces.patch);

  PieceFileLayout layout;
  layout.head = text.head(vertex_count, face_count);
  layout.before_faces = text.before_faces(patches);
  std::uint64_t at = layout.head.size();
  for (const VertexRun& run : parts.vertices) {
    layout.vertices[run.first_id] = at;
    at += run.bytes;
  }
  layout.before_faces_offset = at;
  at += layout.before_faces.size();
  std::optional<int> patch;
  for (const FaceText& faces : parts.faces) {
    const bool goes_on = patch == faces.first_patch;
    const std::string_view before = goes_on ? "" : text.before_patch(faces.first_patch);
    layout.faces[faces.piece] = {at, before};
    at += before.size() + faces.bytes;
    patch = faces.last_patch;
  }
  layout.end = at;
  return layout;
}

}  // namespace surfmesh
