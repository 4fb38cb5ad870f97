// SPDX-License-Identifier: BSD-3-Clause
#include "completion_command.hh"

#include <fmt/format.h>

#include "bash_completion.hh"
#include "exit_status.hh"
#include "standard_output.hh"
#include "zsh_completion.hh"

namespace surfmesh {
namespace {

constexpr const char* kCompletionFooter =
    "For this shell alone:\n"
    "  source <({0} completion bash)\n"
    "An installed surfmesh has both scripts where the shells look for them.\n";

}  // namespace

void CompletionCommand::add_to(CLI::App& app) {
  program_ = &app;
  CLI::App* command = app.add_subcommand(
      "completion", "Print a script by which a shell completes command lines of surfmesh.");
  command->footer(fmt::format(kCompletionFooter, app.get_name()));
  command->add_option("SHELL", shell_, "the shell that reads it")
      ->required()
      ->option_text("bash|zsh")
      ->check(CLI::IsMember({"bash", "zsh"}));
}

int CompletionCommand::run() const {
  print(shell_ == "zsh" ? zsh_completion(*program_) : bash_completion(*program_));
  return kDone;
}

}  // namespace surfmesh
