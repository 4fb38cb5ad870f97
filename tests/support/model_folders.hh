// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace surfmesh::testing {

/// The folder of our own models, and of those that are shared with other programs.
inline const std::filesystem::path kModels = std::filesystem::path(SURFMESH_SOURCE_DIR) / "models";
inline const std::filesystem::path kSharedModels =
    std::filesystem::path(SURFMESH_SHARED_DIR) / "models";

}  // namespace surfmesh::testing
