// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
    for (const VertexHandle vh : mesh_.vertices()) {
      const int before = count_;
      for (const HalfedgeHandle heh : mesh_.vih_range(vh)) {
        if (mesh_.is_boundary(heh)) continue;
        const Value& value = mesh_.property(values_, heh);
        if (unset_ == Unset::HasNoNumber && is_unset(value)) continue;
        const int number = number_among(before, value);
        numbers_[index(heh)] = number > 0 ? number : write_value(heh, keyword, writer);
      }
      of_vertex_.clear();
    }
  }

  /// The number at a corner, from 1; 0 if there is none.
  int number(HalfedgeHandle heh) const { return has_values() ? numbers_[index(heh)] : 0; }

 private:
  /// The number of a value among those of this vertex, which come after `before`; 0 if it is new.
  int number_among(int before, const Value& value) const {
    const auto found = std::find(of_vertex_.begin(), of_vertex_.end(), value);
    return found == of_vertex_.end() ? 0
                                     : before + 1 + static_cast<int>(found - of_vertex_.begin());
  }

  int write_value(HalfedgeHandle heh, std::string_view keyword, FileWriter& writer) {
    const Value& value = mesh_.property(values_, heh);
    const auto numbers = numbers_of(value);
    if (!numbers.allFinite()) {
      throw Error(
          ErrorCode::Geometry,
          fmt::format("a corner of face {} at vertex {} has no finite {}",
                      mesh_.face_handle(heh).idx(), mesh_.to_vertex_handle(heh).idx(), key_.name));
    }
    writer.text(keyword);
    for (const double x : numbers) writer.number(' ', x);
    of_vertex_.push_back(value);
    return ++count_;
  }

  const PolyMesh& mesh_;
  const PropertyKey<HalfedgeHandle, Value>& key_;
  Unset unset_;
  typename PropertyKey<HalfedgeHandle, Value>::Handle values_;
  std::vector<int> numbers_;      ///< by halfedge; empty if none are written
  std::vector<Value> of_vertex_;  ///< those of the vertex that is being written
  int count_ = 0;
};

}  // namespace surfmesh
