// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_text.hh"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/formats/obj_groups.hh"
#include "surfmesh/formats/ply_head.hh"

namespace surfmesh {
namespace {

std::vector<int> numbers_below(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

class ObjText final : public PieceText {
 public:
  explicit ObjText(const PieceIndex& index) : groups_(numbers_below(index.patches), index.names) {}

  std::string head(std::int64_t, std::int64_t) const override { return "# surfmesh"; }

  void add_vertex(const Vec3& point, TextBuffer& buffer) const override {
    buffer.text("\nv");
    for (const double x : point) buffer.number(' ', x);
  }

  std::string before_faces(std::span<const int> patches) const override {
    return groups_.before_faces(patches);
  }

  std::string_view before_patch(int patch) const override { return groups_.of_patch(patch); }

  void add_face(std::span<const std::int64_t> ids, int, TextBuffer& buffer) const override {
    buffer.text("\nf");
    for (const std::int64_t id : ids) buffer.number(' ', id + 1);
  }

 private:
  ObjGroups groups_;
};

/// Faces have their patch as a value.
class PlyText final : public PieceText {
 public:
  explicit PlyText(const PieceIndex& index) : names_(index.names) {}

  std::string head(std::int64_t vertices, std::int64_t faces) const override {
    if (vertices > std::numeric_limits<int>::max()) {
      throw Error(ErrorCode::Limit,
                  fmt::format("{} vertices, but .ply files number them with 32 bits", vertices));
    }
    return ply_head({.names = &names_,
                     .vertices = static_cast<std::size_t>(vertices),
                     .faces = static_cast<std::size_t>(faces),
                     .most_corners = 3,
                     .has_patch_values = true});
  }

  void add_vertex(const Vec3& point, TextBuffer& buffer) const override {
    buffer.number('\n', point.x());
    buffer.number(' ', point.y());
    buffer.number(' ', point.z());
  }

  std::string before_faces(std::span<const int>) const override { return {}; }
  std::string_view before_patch(int) const override { return {}; }

  void add_face(std::span<const std::int64_t> ids, int patch, TextBuffer& buffer) const override {
    buffer.number('\n', ids.size());
    for (const std::int64_t id : ids) buffer.number(' ', id);
    buffer.number(' ', patch);
  }

 private:
  MeshNames names_;
};

/// The ending of the format of a path; empty if there is none.
std::string_view ending_of(const std::filesystem::path& path) {
  const MeshFormat* format = find_format(path);
  return format ? format->ending : std::string_view();
}

}  // namespace

bool has_piece_text(const std::filesystem::path& path) {
  return ending_of(path) == ".obj" || ending_of(path) == ".ply";
}

std::unique_ptr<PieceText> piece_text(const std::filesystem::path& path, const PieceIndex& index) {
  if (ending_of(path) == ".obj") return std::make_unique<ObjText>(index);
  if (ending_of(path) != ".ply") {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: only .obj and .ply can be written in pieces", path.string()));
  }
  if (!index.has_quads) return std::make_unique<PlyText>(index);
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: quads can be written in pieces as .obj only", path.string()));
}

}  // namespace surfmesh
