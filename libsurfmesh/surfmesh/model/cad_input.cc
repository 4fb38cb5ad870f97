// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/cad_input.hh"

#include <algorithm>
#include <array>
#include <string_view>

#include "surfmesh/io/input_file.hh"

namespace surfmesh {

std::span<const std::string_view> cad_endings() {
  static constexpr std::array<std::string_view, 5> kEndings = {".step", ".stp", ".iges", ".igs",
                                                               ".brep"};
  return kEndings;
}

bool has_cad_ending(const std::filesystem::path& path) {
  const auto endings = cad_endings();
  return std::find(endings.begin(), endings.end(), lower_case_ending(path)) != endings.end();
}

}  // namespace surfmesh
