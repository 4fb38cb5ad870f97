// SPDX-License-Identifier: BSD-3-Clause
#include "zsh_completion.hh"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "option_facts.hh"

namespace surfmesh {
namespace {

/// Put a backslash before each of these letters.
std::string escaped(std::string_view text, std::string_view letters) {
  std::string result;
  for (const char c : text) {
    if (letters.find(c) != letters.npos) result += '\\';
    result += c;
  }
  return result;
}

/// In single quotes of the shell.
std::string in_quotes(const std::string& text) {
  return '\'' + CLI::detail::find_and_replace(text, "'", "'\\''") + '\'';
}

/// What completes a value: "(on off)", "_files -g '...'", or nothing.
std::string action(const OptionFacts& facts) {
  if (facts.has_folders) return "_files -/";
  if (facts.has_files) {
    std::string endings;
    for (const std::string& ending : facts.endings) {
      endings += endings.empty() ? "" : "|";
      endings += ending;
    }
    return endings.empty() ? "_files" : fmt::format("_files -g \"(#i)*.({})(-.)\"", endings);
  }
  if (facts.choices.empty()) return " ";
  std::string words;
  for (const std::string& choice : facts.choices) {
    words += words.empty() ? "" : " ";
    words += escaped(choice, ":");
  }
  return fmt::format("({})", words);
}

/// The completion of the value of an option or place, ":message:action".
std::string value_spec(const OptionFacts& facts) {
  const std::string& message = facts.placeholder.empty() ? facts.names.front() : facts.placeholder;
  return fmt::format(":{}:{}", escaped(message, ":"), action(facts));
}

/// The lines that _arguments takes for an option, one for each of its names, which exclude each
/// other.
std::string option_specs(const OptionFacts& facts) {
  std::string others;
  for (const std::string& name : facts.names) {
    others += others.empty() ? "" : " ";
    others += name;
  }
  std::string text;
  for (const std::string& name : facts.names) {
    std::string spec = fmt::format("({}){}", others, name);
    if (name == "--set") spec = fmt::format("*{}", name);
    // Values stand in the same word behind =, or in the next one.
    if (facts.use != ValueUse::None) spec += name.starts_with("--") ? "=" : "+";
    spec += fmt::format("[{}]", escaped(facts.text, "[]:\\"));
    if (facts.use == ValueUse::MayStandAlone) spec += ':';
    if (facts.use != ValueUse::None) spec += value_spec(facts);
    text += fmt::format("        {} \\\n", in_quotes(spec));
  }
  return text;
}

std::string arguments_of(const CLI::App& command) {
  std::string text;
  for (const OptionFacts& option : option_facts(command)) text += option_specs(option);
  int place = 0;
  for (const OptionFacts& facts : place_facts(command)) {
    OptionFacts named = facts;
    named.placeholder = facts.names.front();
    text += fmt::format("        {} \\\n",
                        in_quotes(fmt::format("{}:{}", ++place, value_spec(named).substr(1))));
  }
  return text + "        && return\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& program) {
  const std::string name = program.get_name();
  std::string descriptions, cases, own;
  for (const CLI::App* command : commands_of(program)) {
    const std::string& word = command->get_name();
    descriptions += fmt::format(
        "    {}\n",
        in_quotes(fmt::format("{}:{}", word, escaped(command->get_description(), ":\\"))));
    cases +=
        fmt::format("    {})\n      _arguments \\\n{}      ;;\n", word, arguments_of(*command));
  }
  for (const OptionFacts& option : option_facts(program)) own += option_specs(option);
  return fmt::format(
      "#compdef {0}\n"
      "# Completion of {0} for zsh, printed by `{0} completion zsh`.\n\n"
      "_{0}() {{\n"
      "  local -a commands=(\n{1}  )\n"
      "  local curcontext=\"$curcontext\" state line\n"
      "  typeset -A opt_args\n"
      "  _arguments -C \\\n{2}        '1: :->command' '*:: :->arguments' && return\n"
      "  if [[ $state == command ]]; then\n"
      "    _describe -t commands command commands\n"
      "    return\n"
      "  fi\n"
      "  case $line[1] in\n{3}  esac\n"
      "}}\n\n"
      "if [[ $funcstack[1] == _{0} ]]; then\n"
      "  _{0} \"$@\"\n"
      "else\n"
      "  compdef _{0} {0}\n"
      "fi\n",
      name, descriptions, own, cases);
}

}  // namespace surfmesh
