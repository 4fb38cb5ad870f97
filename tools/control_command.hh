// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "progress.hh"
#include "settings.hh"

namespace surfmesh {

/// `surfmesh control`: write the control meshes of a model with their sizes, to look at.
class ControlCommand {
 public:
  /// Add the subcommand and its options to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  int write_control_meshes(Progress& progress) const;

  std::string input_;
  std::string output_;
  Settings named_;  ///< by flags of their own
  Settings set_;    ///< by --set, which beats them
  Scheme scheme_ = Scheme::Auto;
  bool is_quiet_ = false;
  bool is_verbose_ = false;
};

}  // namespace surfmesh
