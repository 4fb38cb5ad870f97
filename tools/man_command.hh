// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// `surfmesh man`: print a manual page, or write all of them into a folder.
class ManCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  void write_all() const;

  const CLI::App* program_ = nullptr;
  std::string command_;  ///< empty for the page of the program
  std::string folder_;   ///< empty for none
};

}  // namespace surfmesh
