// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace surfmesh {

/// `surfmesh completion`: print a script by which a shell completes command lines.
class CompletionCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status.
  int run() const;

 private:
  const CLI::App* program_ = nullptr;
  std::string shell_;
};

}  // namespace surfmesh
