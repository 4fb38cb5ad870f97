// SPDX-License-Identifier: BSD-3-Clause
#include "cad.hh"

#ifdef SURFMESH_HAS_CAD
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "signals.hh"
#include "surfmesh/core/error.hh"
#endif
#ifdef SURFMESH_READS_CAD
#include "surfmesh_cad/read_cad.hh"
#endif

namespace surfmesh {

#if defined(SURFMESH_READS_CAD)

namespace {

/// OpenCASCADE ends the program at some damaged files.
Model read_cad_or_tell(const std::filesystem::path& path, const CadOptions& options) {
  const TellsCrash tells(
      fmt::format("surfmesh: error: {}: OpenCASCADE, which reads it, crashed: the file is damaged, "
                  "or has what it cannot read; save it anew, as STEP where it is another format\n",
                  path.string()));
  return read_cad(path, options);
}

}  // namespace

CadReader cad_reader() { return read_cad_or_tell; }

#elif defined(SURFMESH_HAS_CAD)

namespace {

/// The words of the command line, the program's name first.
std::vector<std::string> own_arguments() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> arguments;
  for (std::string argument; std::getline(file, argument, '\0');) arguments.push_back(argument);
  return arguments;
}

/// Start the same command in the program that is linked with OpenCASCADE, in place of this one.
[[noreturn]] void go_on_in_cad_program() {
  std::vector<std::string> arguments = own_arguments();
  if (arguments.empty())
    throw Error(ErrorCode::Io, "/proc, which has the command line, is not there");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "surfmesh-cad";
  wipe_terminal();
  execv(program.c_str(), pointers.data());
  throw Error(ErrorCode::Io, fmt::format("{}, which reads CAD files, cannot be started: {}",
                                         program.string(), std::strerror(errno)));
}

}  // namespace

CadReader cad_reader() {
  return [](const std::filesystem::path&, const CadOptions&) -> Model { go_on_in_cad_program(); };
}

#else

CadReader cad_reader() { return {}; }

#endif

std::string cad_library() {
#ifdef SURFMESH_HAS_CAD
  return "OpenCASCADE " SURFMESH_HAS_CAD;
#else
  return {};
#endif
}

}  // namespace surfmesh
