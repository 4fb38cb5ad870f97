// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <vector>

namespace surfmesh {

/// The command line of the program: what it accepts, and what its commands do. Help, completion and
/// manual pages are made from the same definition.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  CLI::App& app() { return app_; }

  /// Do what the command that was parsed says. Returns an exit status.
  int run() const;

 private:
  struct Entry {
    const CLI::App* app;
    std::function<int()> run;
  };

  /// Add a command, an object with add_to(app) and run().
  template <class Command>
  void add() {
    const auto command = std::make_shared<Command>();
    command->add_to(app_);
    entries_.push_back({app_.get_subcommands({}).back(), [command] { return command->run(); }});
  }

  CLI::App app_;
  std::vector<Entry> entries_;
};

}  // namespace surfmesh
