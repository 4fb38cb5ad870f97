// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace surfmesh {

/// Where the script of the page may be: three.js and what shows a mesh with it, in one file.
struct ViewerPlaces {
  std::filesystem::path installed;   ///< beside an installed program
  std::filesystem::path built = {};  ///< in the sources, where tools/setup.sh puts it; or empty
  std::filesystem::path setup = {};  ///< tools/setup.sh in the sources; or empty
};

/// The places for a program. Those in the sources are for one in the folder that it was built in:
/// an installed one takes no script from wherever its sources once were.
ViewerPlaces viewer_places(const std::filesystem::path& program);

/// The places for the program that runs.
ViewerPlaces viewer_places();

/// Read the script from the first place that has it.
///
/// Throws   Io if no place has it, with the command that makes it
std::string read_viewer_script(const ViewerPlaces& places);

}  // namespace surfmesh
