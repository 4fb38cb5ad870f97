// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

#include "command_line.hh"
#include "exit_status.hh"
#include "settings.hh"
#include "signals.hh"
#include "standard_output.hh"
#include "usage.hh"

namespace {

int tell_wrong_usage(const CLI::App& app, const std::string& fault) {
  std::fprintf(stderr, "surfmesh: error: %s\n%s tells more\n", fault.c_str(),
               surfmesh::help_line(app).c_str());
  return surfmesh::kWrongUsage;
}

/// CLI11 has many codes; the documentation has one for wrong usage.
int exit_status(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {  // --help, --version
    std::ostringstream text;
    app.exit(error, text);
    surfmesh::print(text.str());
    return surfmesh::kDone;
  }
  return tell_wrong_usage(app, surfmesh::usage_fault(app, error));
}

int run(int argc, char** argv) {
  surfmesh::CommandLine line;
  CLI::App& app = line.app();
  auto arguments = surfmesh::with_switch_values({argv + 1, argv + argc});
  if (const std::string fault = surfmesh::one_dash_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  if (const std::string fault = surfmesh::command_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  try {
    std::reverse(arguments.begin(), arguments.end());  // as the parser takes them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return exit_status(app, error);
  }
  return line.run();
}

}  // namespace

int main(int argc, char** argv) {
  surfmesh::keep_closed_streams_closed();
  surfmesh::take_errors_for_signals();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh: error: %s\n", error.what());
    return surfmesh::kFailed;
  }
}
