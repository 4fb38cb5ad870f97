// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

enum class CadFormat { Step, Iges, Brep };

/// The format of a file, by its ending.
///
/// The file is looked at before OpenCASCADE reads it, which takes a damaged file for a shorter one,
/// or never ends: it must begin as its format does, and be complete.
///
/// Throws   Io if it cannot be read; InvalidInput if it is of another kind, or cut off; Limit if it
///          is above 512 MB
CadFormat check_cad_file(const std::filesystem::path& path);

}  // namespace surfmesh
