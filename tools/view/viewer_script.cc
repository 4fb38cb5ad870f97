// SPDX-License-Identifier: BSD-3-Clause
#include "view/viewer_script.hh"

#include <fmt/format.h>

#include <system_error>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {

namespace fs = std::filesystem;

ViewerPlaces viewer_places(const fs::path& program) {
  const fs::path data = (program.parent_path() / SURFMESH_DATA_FROM_PROGRAM).lexically_normal();
  ViewerPlaces places = {.installed = data / "surfmesh" / "viewer.js"};
  const fs::path from_build = program.lexically_relative(SURFMESH_BUILD_TREE);
  if (from_build.empty() || *from_build.begin() == "..") return places;
  places.built = fs::path(SURFMESH_VIEW_SOURCES) / "page" / "dist" / "viewer.js";
  places.setup = fs::path(SURFMESH_VIEW_SOURCES).parent_path() / "setup.sh";
  return places;
}

ViewerPlaces viewer_places() {
  std::error_code ignored;
  return viewer_places(fs::read_symlink("/proc/self/exe", ignored));
}

std::string read_viewer_script(const ViewerPlaces& places) {
  std::error_code ignored;
  for (const fs::path& path : {places.installed, places.built}) {
    if (fs::is_regular_file(path, ignored)) return read_file(path);
  }
  if (fs::is_regular_file(places.setup, ignored)) {
    throw Error(ErrorCode::Io, fmt::format("the script of the page, {}, is not there; make it with "
                                           "\"{} --viewer\"",
                                           places.built.string(), places.setup.string()));
  }
  throw Error(ErrorCode::Io,
              fmt::format("the script of the page, {}, is not there; make it with "
                          "\"tools/setup.sh --viewer\" in the sources of surfmesh and install "
                          "them again, or copy tools/view/page/dist/viewer.js there",
                          places.installed.string()));
}

}  // namespace surfmesh
