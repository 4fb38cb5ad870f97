// SPDX-License-Identifier: BSD-3-Clause
#include "usage.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

/// The command that was asked for, or the program itself.
const CLI::App& innermost(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

/// ", did you mean <prefix>word?", or nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const char* prefix) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  const auto meant = nearest_word(word, words);
  return meant ? fmt::format(", did you mean {}{}?", prefix, *meant) : "";
}

std::string unknown_option(const CLI::App& command, const std::string& argument) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    const auto& names = option->get_lnames();
    known.insert(known.end(), names.begin(), names.end());
  }
  const std::string name = argument.substr(0, argument.find('='));
  const std::string letters = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  return fmt::format("there is no option {}{}", name, suggestion(letters, known, "--"));
}

std::string unknown_command(const CLI::App& app, const std::string& argument) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  return fmt::format("there is no command {}{}", argument, suggestion(argument, known, ""));
}

}  // namespace

std::string usage_fault(const CLI::App& app, const CLI::ParseError& error) {
  // The parser tells of these last, after anything that is missing because of them.
  const CLI::App& command = innermost(app);
  const std::vector<std::string> unknown = app.remaining(true);
  const auto option = std::find_if(unknown.begin(), unknown.end(), [](const std::string& argument) {
    return argument.size() > 1 && argument.front() == '-';
  });
  const bool has_no_command = &command == &app && !unknown.empty();
  if (has_no_command && !unknown.front().starts_with('-'))
    return unknown_command(app, unknown.front());
  if (option != unknown.end()) return unknown_option(command, *option);
  if (has_no_command) return unknown_command(app, unknown.front());
  const std::string fault = error.what();
  const std::size_t repeated = fault.find(": At Most 1 required");
  if (repeated != std::string::npos) return fault.substr(0, repeated) + ": it is given twice";
  return fault;
}

std::string one_dash_fault(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto wrong = std::find_if(arguments.begin(), arguments.end(), [](const std::string& word) {
    return word.size() > 2 && word[0] == '-' && word[1] != 'o' &&
           std::isalpha(static_cast<unsigned char>(word[1])) != 0;
  });
  if (wrong == arguments.end()) return {};
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == arguments.front()) return unknown_option(*command, *wrong);
  }
  return unknown_option(app, *wrong);
}

std::string command_fault(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return {};
  const auto commands = app.get_subcommands({});
  const bool is_known = std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) {
    return command->get_name() == arguments.front();
  });
  return is_known ? std::string() : unknown_command(app, arguments.front());
}

std::string help_line(const CLI::App& app) {
  const CLI::App& command = innermost(app);
  return &command == &app ? fmt::format("{} --help", app.get_name())
                          : fmt::format("{} {} --help", app.get_name(), command.get_name());
}

}  // namespace surfmesh
