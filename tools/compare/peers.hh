// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace surfmesh::compare {

/// Pmp and Cgal are programs of the user that call the remeshing of these libraries, with the
/// arguments INPUT OUTPUT LENGTH ANGLE.
enum class PeerKind { Gmsh, Bamg, Mmg2d, Mmgs, Pmp, Cgal };

/// Another mesher of this computer.
struct Peer {
  PeerKind kind;
  std::string name;               ///< "Gmsh"
  std::filesystem::path program;  ///< empty if it was not found
  std::string version;
};

/// All that are known, with those found in PATH. Asks each for its version.
std::vector<Peer> find_peers(const std::filesystem::path& work);

/// Among the names, the first in one of the directories of a PATH; empty if none is.
std::filesystem::path find_program(const std::vector<std::string>& names, std::string_view path);

/// The processor seconds of meshing that a tool tells in its output, without reading and writing;
/// nothing if it does not.
std::optional<double> told_seconds(PeerKind kind, const std::string& log);

}  // namespace surfmesh::compare
