// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/mesh_names.hh"

/// The header of a PLY file: what its body holds, and what our comments tell.
namespace surfmesh::ply {

enum class Type { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

inline bool is_float(Type type) { return type == Type::Float32 || type == Type::Float64; }

struct Property {
  std::string name;
  Type type = Type::Int32;
  std::optional<Type> count_type;  ///< of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Format { Ascii, Little, Big };

/// Faces of one patch in a row.
struct PatchRun {
  std::size_t count = 0;
  int patch = -1;
};

struct Header {
  Format format = Format::Ascii;
  std::vector<Element> elements;
  MeshNames names;
  std::vector<PatchRun> runs;
  std::size_t size = 0;  ///< in bytes, with the end of its last line
  int lines = 0;
};

/// Read the header of a file; `name` stands in messages.
/// Throws   InvalidInput, naming the line
Header read_header(std::string_view bytes, const std::string& name);

}  // namespace surfmesh::ply
