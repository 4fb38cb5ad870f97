// SPDX-License-Identifier: BSD-3-Clause
#include "output_paths.hh"

#include <fmt/format.h>

#include <system_error>

#include "surfmesh/core/error.hh"

namespace surfmesh {

namespace fs = std::filesystem;

void check_writable(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw Error(ErrorCode::Io, fmt::format("cannot write {}: it is a folder", path.string()));
  }
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ErrorCode::Io, fmt::format("cannot write {}: there is no folder {}", path.string(),
                                           folder.string()));
  }
}

void check_not_overwritten(std::span<const fs::path> inputs, const fs::path& output) {
  if (inputs.empty()) return;
  for (const fs::path& input : inputs) {
    if (!is_same_file(input, output)) continue;
    throw Error(ErrorCode::Io,
                &input == &inputs.front()
                    ? fmt::format("{} is the input, it is not overwritten", output.string())
                    : fmt::format("{} is read for {}, it is not overwritten", output.string(),
                                  inputs.front().string()));
  }
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored);
}

}  // namespace surfmesh
