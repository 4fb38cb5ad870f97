// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "progress.hh"
#include "settings.hh"

namespace surfmesh {

struct MeshCheck;

/// `surfmesh check`: tell what a mesh is like, what is wrong with it, and how it fits its model.
class CheckCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  MeshCheck measure(Progress& progress) const;
  int check(Progress& progress) const;

  std::string mesh_;
  std::string model_;  ///< empty for none
  Settings named_;     ///< by flags of their own
  Settings set_;       ///< by --set, which beats them
  Scheme scheme_ = Scheme::Auto;
  bool is_json_ = false;
  bool is_verbose_ = false;
};

}  // namespace surfmesh
