// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/io/file_writer.hh"

/// The lines vt and vn of OBJ files.
namespace surfmesh {

inline Vec3 numbers_of(const Normal& normal) { return {normal.x, normal.y, normal.z}; }
inline Eigen::Vector2d numbers_of(Uv uv) { return {uv.u, uv.v}; }

/// What it means that a corner has no value.
enum class Unset { IsFault, HasNoNumber };

inline bool is_unset(Uv uv) { return std::isnan(uv.u) || std::isnan(uv.v); }
inline bool is_unset(const Normal& normal) { return std::isnan(normal.x); }

/// Writes the values of a property of the corners, one a line, and their numbers at the corners.
/// Equal values at a vertex are one.
template <class Value>
class CornerWriter {
 public:
  CornerWriter(const PolyMesh& mesh, const PropertyKey<HalfedgeHandle, Value>& key,
               bool is_asked_for, Unset unset = Unset::IsFault)
      : mesh_(mesh), key_(key), unset_(unset), values_(find(mesh, key)) {
    if (is_asked_for && values_.is_valid()) numbers_.resize(mesh.n_halfedges(), 0);
  }

  bool has_values() const { return !numbers_.empty(); }

  /// Throws   Geometry for a value that is not finite, unless it may be unset
  void write_values(std::string_view keyword, FileWriter& writer) {
    if (!has_values()) return;
    const std::size_t count = mesh_.n_vertices();
    std::vector<int> counts(count / FileWriter::kPiece + 1, 0);
    writer.pieces(count, [&](std::size_t first, std::size_t end, TextBuffer& buffer) {
      std::vector<Value> values;
      int& of_piece = counts[first / FileWriter::kPiece];
      for (std::size_t v = first; v < end; ++v) {
        write_values_at(VertexHandle(static_cast<int>(v)), of_piece, keyword, values, buffer);
        of_piece += static_cast<int>(values.size());
      }
    });
    before_.assign(counts.size(), 0);
    std::exclusive_scan(counts.begin(), counts.end(), before_.begin(), 0);
  }

  /// The number at a corner, from 1; 0 if there is none.
  int number(HalfedgeHandle heh) const {
    if (!has_values() || numbers_[index(heh)] == 0) return 0;
    return numbers_[index(heh)] + before_[index(mesh_.to_vertex_handle(heh)) / FileWriter::kPiece];
  }

 private:
  /// Write the values that differ at a vertex, and keep them. Those of its piece are `before`.
  void write_values_at(VertexHandle vh, int before, std::string_view keyword,
                       std::vector<Value>& values, TextBuffer& buffer) {
    values.clear();
    for (const HalfedgeHandle heh : mesh_.vih_range(vh)) {
      if (mesh_.is_boundary(heh)) continue;
      const Value& value = mesh_.property(values_, heh);
      if (unset_ == Unset::HasNoNumber && is_unset(value)) continue;
      const auto found = std::find(values.begin(), values.end(), value);
      numbers_[index(heh)] = before + 1 + static_cast<int>(found - values.begin());
      if (found != values.end()) continue;
      write_value(heh, keyword, buffer);
      values.push_back(value);
    }
  }

  void write_value(HalfedgeHandle heh, std::string_view keyword, TextBuffer& buffer) const {
    const auto numbers = numbers_of(mesh_.property(values_, heh));
    if (!numbers.allFinite()) {
      throw Error(
          ErrorCode::Geometry,
          fmt::format("a corner of face {} at vertex {} has no finite {}",
                      mesh_.face_handle(heh).idx(), mesh_.to_vertex_handle(heh).idx(), key_.name));
    }
    buffer.text(keyword);
    for (const double x : numbers) buffer.number(' ', x);
  }

  const PolyMesh& mesh_;
  const PropertyKey<HalfedgeHandle, Value>& key_;
  Unset unset_;
  typename PropertyKey<HalfedgeHandle, Value>::Handle values_;
  std::vector<int> numbers_;  ///< by halfedge, within the piece of its tip; empty for none
  std::vector<int> before_;   ///< by piece of the vertices, how many values come before it
};

}  // namespace surfmesh
