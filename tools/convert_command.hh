// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "surfmesh/formats/output_options.hh"

namespace surfmesh {

/// `surfmesh convert`: read a mesh in one format and write it in another.
class ConvertCommand {
 public:
  /// Add the subcommand to the program. The object must outlive the parsing.
  void add_to(CLI::App& app);

  /// Do what the parsed arguments say. Returns an exit status; prints its errors itself.
  int run() const;

 private:
  int convert() const;

  std::string input_;
  std::string output_;
  OutputOptions options_;
  bool is_quiet_ = false;
  bool is_verbose_ = false;
};

}  // namespace surfmesh
