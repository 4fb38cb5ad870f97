// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "exit_status.hh"
#include "mesh_arguments.hh"
#include "progress.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/pipeline/text_style.hh"
#include "verbosity.hh"

namespace surfmesh {

struct Report;

/// Tell on stderr why a command ends without its result: an error, or a signal that stopped it.
/// Returns an exit status.
int tell_failure(const std::exception& error, Progress& progress);

/// Print notices on stderr, the first few of each kind or all of them.
void print_notices(const Notices& notices, Verbosity verbosity = {});

/// How a summary is printed on stdout: with block characters only on a terminal that has them.
TextStyle text_style(bool is_verbose);

/// `surfmesh mesh`: read a cage or a model file, mesh it, write the mesh and the report.
class MeshCommand {
 public:
  MeshCommand() = default;

  /// With arguments that were parsed elsewhere.
  explicit MeshCommand(MeshArguments arguments) : arguments_(std::move(arguments)) {}

  /// Add the subcommand and its options to the program. The object must outlive the parsing.
  void add_to(CLI::App& app) { arguments_.add_to(app); }

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  int finish(const Report& report, const std::string& summary, Progress& progress) const;

  MeshArguments arguments_;
};

/// What an error says, with the path of the input in front if it does not tell a place there.
inline std::string text_at_input(const std::string& path, const Error& error) {
  const std::string text = error.what();
  const bool has_place = text.starts_with(path + ":");
  return has_place || error.code() == ErrorCode::Cancelled ? text : path + ": " + text;
}

/// Run `body`. Errors that do not tell a place in the input get its path in front.
template <class Body>
auto at_input(const std::string& path, Body body) {
  try {
    return body();
  } catch (const Error& error) {
    throw Error(error.code(), text_at_input(path, error));
  }
}

}  // namespace surfmesh
