// SPDX-License-Identifier: BSD-3-Clause
#include "man_command.hh"

#include <fmt/format.h>

#include <filesystem>

#include "exit_status.hh"
#include "man_page.hh"
#include "mesh_command.hh"
#include "option_facts.hh"
#include "outputs.hh"
#include "standard_output.hh"

namespace surfmesh {
namespace {

constexpr const char* kManFooter =
    "Examples:\n"
    "  {0} man mesh | man -l -    show the page of a command\n"
    "  {0} man --folder man1      write {0}.1, {0}-mesh.1 and the others\n";

}  // namespace

void ManCommand::add_to(CLI::App& app) {
  program_ = &app;
  CLI::App* command =
      app.add_subcommand("man", "Print a manual page of surfmesh or one of its commands.");
  command->footer(fmt::format(kManFooter, app.get_name()));
  CLI::Option* page =
      command->add_option("COMMAND", command_, "the command; without it, the page of surfmesh")
          ->type_name("COMMAND")
          ->check([this](const std::string& name) {
            return find_command(*program_, name) ? std::string()
                                                 : fmt::format("there is no command {}", name);
          });
  command->add_option("--folder", folder_, "write all pages into this folder")
      ->type_name("FOLDER")
      ->excludes(page);
}

/// All pages appear, or none.
void ManCommand::write_all() const {
  const std::filesystem::path folder(folder_);
  Outputs outputs;
  outputs.add(folder / fmt::format("{}.1", program_->get_name())).write(man_page(*program_));
  for (const CLI::App* command : commands_of(*program_)) {
    outputs.add(folder / fmt::format("{}-{}.1", program_->get_name(), command->get_name()))
        .write(man_page(*command));
  }
  outputs.commit(kDone);
}

int ManCommand::run() const {
  catch_signals();
  Progress progress(false);
  try {
    if (!folder_.empty()) {
      write_all();
    } else {
      print(man_page(command_.empty() ? *program_ : *find_command(*program_, command_)));
    }
    return kDone;
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
