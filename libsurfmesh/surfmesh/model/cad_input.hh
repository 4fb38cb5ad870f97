// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "surfmesh/core/length.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// How a file of a CAD program becomes a model.
struct CadOptions {
  /// Edges of single faces nearer than this become one, so that faces that the file does not join
  /// (IGES) get common edges. Unset: 1e-5 of the diagonal; 0 is off.
  std::optional<Length> sew = {};
};

namespace ranges {

inline constexpr LengthRange kSew = {"sew", true, 1e-5};

}  // namespace ranges

/// Reads a STEP, IGES or BREP file.
///
/// The library itself has no such reader, for it needs OpenCASCADE. `surfmesh_cad` is a library
/// that has: hand its `read_cad` to load_model.
using CadReader = std::function<Model(const std::filesystem::path&, const CadOptions&)>;

/// The endings of CAD files in lower case, with their dots.
std::span<const std::string_view> cad_endings();

/// True for the ending of a CAD file, in upper or lower case: .step, .stp, .iges, .igs, .brep.
bool has_cad_ending(const std::filesystem::path& path);

}  // namespace surfmesh
