// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "progress.hh"
#include "settings.hh"

namespace surfmesh {

struct PageContents;

/// `surfmesh view`: write a page that shows a mesh in a browser.
class ViewCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  void add_files(CLI::App& command);
  void check_usage() const;
  bool asks_for_meshing() const;
  bool is_model() const;
  void tell_choice() const;
  Settings settings() const;

  int view(Progress& progress) const;
  int view_model(const std::string& script, Progress& progress) const;
  int finish(const PageContents& contents, const std::string& script, Progress& progress) const;
  int view_mesh(const std::string& script, Progress& progress) const;

  std::string input_;
  std::string output_;
  std::string model_;  ///< of a mesh; empty for none
  Settings named_;     ///< by flags of their own
  Settings set_;       ///< by --set, which beats them
  Scheme scheme_ = Scheme::Auto;
  bool is_meshed_ = false;  ///< the mesh is a cage
  bool is_quiet_ = false;
  bool is_verbose_ = false;
};

}  // namespace surfmesh
