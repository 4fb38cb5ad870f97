// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_cage.hh"

#include <new>

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {

Cage read_cage(const std::filesystem::path& path) try {
  if (!has_cage_ending(path)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the ending of a cage is {}", path.string(), cage_endings()));
  }
  return format_of(path).parse_cage(read_file(path), path.string());
} catch (const std::bad_alloc&) {
  fail_without_memory("while reading " + path.string());
}

}  // namespace surfmesh
