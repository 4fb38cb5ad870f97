// SPDX-License-Identifier: BSD-3-Clause
#include "compare/peers.hh"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "compare/run_process.hh"

namespace surfmesh::compare {
namespace {

constexpr double kVersionTimeLimit = 20;  // seconds

/// The first number with a point, such as 4.8.4, of what a program says of itself.
std::string version_of(const std::filesystem::path& program, const std::string& option,
                       const std::filesystem::path& work) {
  const auto run = run_process({program.string(), option}, work, kVersionTimeLimit);
  static const std::regex pattern(R"([vV]?(\d+\.\d+(\.\d+)*))");
  std::smatch found;
  return std::regex_search(run.log, found, pattern) ? found[1].str() : "of unknown version";
}

Peer make_peer(PeerKind kind, const std::string& name, const std::vector<std::string>& programs,
               const std::string& version_option, const std::filesystem::path& work) {
  const char* path = std::getenv("PATH");
  Peer peer{kind, name, find_program(programs, path != nullptr ? path : ""), ""};
  if (!peer.program.empty()) peer.version = version_of(peer.program, version_option, work);
  return peer;
}

/// The last number that a pattern finds.
std::optional<double> last_number(const std::string& log, const std::regex& pattern) {
  std::optional<double> number;
  for (std::sregex_iterator i(log.begin(), log.end(), pattern), end; i != end; ++i) {
    number = std::strtod((*i)[1].str().c_str(), nullptr);
  }
  return number;
}

}  // namespace

std::vector<Peer> find_peers(const std::filesystem::path& work) {
  return {make_peer(PeerKind::Gmsh, "Gmsh", {"gmsh"}, "--version", work),
          make_peer(PeerKind::Bamg, "BAMG", {"ffbamg", "bamg"}, "-h", work),
          make_peer(PeerKind::Mmg2d, "Mmg2d", {"mmg2d_O3", "mmg2d"}, "-h", work),
          make_peer(PeerKind::Mmgs, "Mmgs", {"mmgs_O3", "mmgs"}, "-h", work),
          make_peer(PeerKind::Pmp, "pmp", {"pmp_remesh"}, "--version", work),
          make_peer(PeerKind::Cgal, "CGAL", {"cgal_remesh"}, "--version", work)};
}

std::filesystem::path find_program(const std::vector<std::string>& names, std::string_view path) {
  for (const std::string& name : names) {
    for (std::string_view rest = path; !rest.empty();) {
      const std::size_t colon = std::min(rest.find(':'), rest.size());
      const auto candidate = std::filesystem::path(rest.substr(0, colon)) / name;
      std::error_code error;
      const bool is_file = std::filesystem::is_regular_file(candidate, error);
      if (is_file && access(candidate.c_str(), X_OK) == 0) return candidate;
      rest.remove_prefix(std::min(colon + 1, rest.size()));
    }
  }
  return {};
}

std::optional<double> told_seconds(PeerKind kind, const std::string& log) {
  static const std::regex gmsh(R"(Done meshing 2D \(Wall [\d.e+-]+s, CPU ([\d.e+-]+)s\))");
  static const std::regex bamg(R"(Cpu time for meshing\s+:\s*([\d.e+-]+)s)");
  if (kind == PeerKind::Gmsh) return last_number(log, gmsh);
  if (kind == PeerKind::Bamg) return last_number(log, bamg);
  return std::nullopt;
}

}  // namespace surfmesh::compare
