// SPDX-License-Identifier: BSD-3-Clause
#include "option_facts.hh"

#include <algorithm>
#include <cctype>
#include <regex>
#include <string_view>

#include "settings.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

void add_new(const std::string& word, std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

/// The endings of files that a text names, ".obj, .off or .om". Of CAD files it names some.
std::vector<std::string> endings_in(const std::string& text) {
  static const std::regex pattern(R"((?:^|[ (/,]|FILE)\.([a-z][a-z0-9]+))");
  std::vector<std::string> endings;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    add_new((*match)[1], endings);
    if (!has_cad_ending("a." + (*match)[1].str())) continue;
    for (const std::string_view ending : cad_endings()) {
      add_new(std::string(ending.substr(1)), endings);
    }
  }
  return endings;
}

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(mark, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// The words of "off|on|LENGTH"; what is in capitals stands for something else.
std::vector<std::string> choices_in(const std::string& placeholder, const CLI::App& command) {
  std::vector<std::string> choices;
  if (placeholder == "COMMAND" && command.get_parent()) {
    for (const CLI::App* other : commands_of(*command.get_parent())) {
      choices.push_back(other->get_name());
    }
    return choices;
  }
  if (placeholder == "key=value") {
    for (const std::string_view name : option_names()) choices.push_back(std::string(name) + '=');
    return choices;
  }
  for (const std::string& part : split(placeholder, '|')) {
    const bool is_word = std::all_of(part.begin(), part.end(), [](char c) {
      return std::islower(static_cast<unsigned char>(c)) != 0 ||
             std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    });
    if (!part.empty() && is_word) choices.push_back(part);
  }
  return choices;
}

bool is_place(const CLI::Option* option) { return option->get_positional(); }

/// A place of this name in any command, "INPUT", or null.
const CLI::Option* find_place(const std::string& name, const CLI::App& command) {
  if (!command.get_parent()) return nullptr;
  for (const CLI::App* other : commands_of(*command.get_parent())) {
    for (const CLI::Option* place : other->get_options(is_place)) {
      if (place->get_name(true) == name) return place;
    }
  }
  return nullptr;
}

/// Where the value is a file, which is told by "FILE", by endings, or by a place of the same name.
void add_files(const CLI::Option& option, const CLI::App& command, OptionFacts& facts) {
  const std::string& value = facts.placeholder;
  facts.has_folders = value == "FOLDER";
  if (facts.has_folders || !facts.choices.empty()) return;
  facts.endings = endings_in(value + ' ' + facts.text);
  const CLI::Option* same = find_place(value, command);
  if (same && facts.endings.empty()) facts.endings = endings_in(same->get_description());
  facts.has_files = value.starts_with("FILE") || same || is_place(&option);
  if (!facts.has_files) facts.endings.clear();
}

/// "off|NUMBER" and "0.25" of "off|NUMBER=0.25", as add_flags makes it.
void add_placeholder(const CLI::Option& option, OptionFacts& facts) {
  const std::string& shown = option.get_option_text();
  if (shown.empty()) {
    facts.placeholder = option.get_type_name();
    facts.default_value = option.get_default_str();
    return;
  }
  const std::size_t mark = shown.find('=');
  facts.placeholder = shown.substr(0, mark);
  if (mark != shown.npos) facts.default_value = shown.substr(mark + 1);
}

OptionFacts facts_of(const CLI::Option& option, const CLI::App& command) {
  OptionFacts facts;
  facts.text = long_text(option);
  facts.group = option.get_group();
  facts.is_required = option.get_required();
  for (const CLI::Option* needed : option.get_needs()) facts.needs.push_back(needed->get_name());
  if (is_place(&option)) facts.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) facts.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) facts.names.push_back("--" + name);
  if (option.get_type_size() == 0) return facts;
  facts.use = may_stand_alone(option) ? ValueUse::MayStandAlone : ValueUse::Needed;
  add_placeholder(option, facts);
  facts.choices = choices_in(facts.placeholder, command);
  add_files(option, command, facts);
  return facts;
}

}  // namespace

std::vector<OptionFacts> option_facts(const CLI::App& command) {
  std::vector<OptionFacts> facts;
  for (const CLI::Option* option : command.get_options()) {
    if (!is_place(option)) facts.push_back(facts_of(*option, command));
  }
  return facts;
}

std::vector<OptionFacts> place_facts(const CLI::App& command) {
  std::vector<OptionFacts> facts;
  for (const CLI::Option* option : command.get_options(is_place)) {
    facts.push_back(facts_of(*option, command));
  }
  return facts;
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

const CLI::App* find_command(const CLI::App& program, const std::string& name) {
  const auto commands = commands_of(program);
  const auto found = std::find_if(commands.begin(), commands.end(), [&](const CLI::App* command) {
    return command->get_name() == name;
  });
  return found == commands.end() ? nullptr : *found;
}

}  // namespace surfmesh
