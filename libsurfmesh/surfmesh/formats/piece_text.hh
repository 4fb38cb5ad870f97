// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "surfmesh/core/values.hh"
#include "surfmesh/io/text_buffer.hh"
#include "surfmesh/pieces/piece_sink.hh"

namespace surfmesh {

/// A format as text that can be made of pieces: a head, the vertices in the order of their ids, and
/// the faces. Each text begins with the end of the line before it.
class PieceText {
 public:
  virtual ~PieceText() = default;

  virtual std::string head(std::int64_t vertices, std::int64_t faces) const = 0;
  virtual void add_vertex(const Vec3& point, TextBuffer& buffer) const = 0;

  /// What stands before all faces. `patches` are those of the faces; of faces in a row with the
  /// same patch one is enough.
  virtual std::string before_faces(std::span<const int> patches) const = 0;

  /// What stands before the first of some faces of a patch.
  virtual std::string_view before_patch(int patch) const = 0;

  /// `ids` are those of the vertices.
  virtual void add_face(std::span<const std::int64_t> ids, int patch, TextBuffer& buffer) const = 0;
};

/// True for endings of formats that can be made of pieces: .obj and .ply.
bool has_piece_text(const std::filesystem::path& path);

/// The text of the format of a path, as write_mesh makes it, for the pieces of a mesh.
/// Throws   InvalidInput for another ending, and for .ply with quads, which has patches only where
///          all faces have the same number of corners; for a name that does not fit
std::unique_ptr<PieceText> piece_text(const std::filesystem::path& path, const PieceIndex& index);

}  // namespace surfmesh
