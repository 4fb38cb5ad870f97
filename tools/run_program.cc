// SPDX-License-Identifier: BSD-3-Clause
#include "run_program.hh"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>

#include "exit_status.hh"
#include "freed_blocks.hh"
#include "settings.hh"
#include "standard_output.hh"
#include "usage.hh"

namespace surfmesh {
namespace {

int tell_wrong_usage(const CLI::App& app, const std::string& fault) {
  tell(fmt::format("surfmesh: error: {}\n{} tells more\n", fault, help_line(app)));
  return kWrongUsage;
}

/// CLI11 has many codes; the documentation has one for wrong usage.
int exit_status(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {  // --help, --version
    std::ostringstream text;
    app.exit(error, text);
    print(text.str());
    return kDone;
  }
  return tell_wrong_usage(app, usage_fault(app, error));
}

}  // namespace

int run_program(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  keep_freed_blocks();
  auto arguments = with_switch_values({argv + 1, argv + argc});
  if (const std::string fault = one_dash_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  if (const std::string fault = command_fault(app, arguments); !fault.empty()) {
    return tell_wrong_usage(app, fault);
  }
  try {
    std::reverse(arguments.begin(), arguments.end());  // as the parser takes them
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return exit_status(app, error);
  }
  return run();
}

}  // namespace surfmesh
