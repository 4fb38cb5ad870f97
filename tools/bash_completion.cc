// SPDX-License-Identifier: BSD-3-Clause
#include "bash_completion.hh"

#include <fmt/format.h>

#include <vector>

#include "option_facts.hh"

namespace surfmesh {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

/// What the script sets for a value: `words` to choose from, the `files` that fit ('*' for any, '/'
/// for folders, else endings), and whether a value `must` follow.
std::string assignments(const OptionFacts& facts) {
  std::string files;
  if (facts.has_folders) files = "/";
  if (facts.has_files) files = facts.endings.empty() ? "*" : joined(facts.endings, " ");
  return fmt::format("words='{}' files='{}' must={}", joined(facts.choices, " "), files,
                     facts.use == ValueUse::Needed ? 1 : 0);
}

/// The branches of a command: its options with values, and its places by their numbers.
std::string branches(const std::string& command, const CLI::App& app) {
  std::string text;
  for (const OptionFacts& option : option_facts(app)) {
    if (option.use == ValueUse::None) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      patterns.push_back(fmt::format("'{} {}'", command, name));
    }
    text += fmt::format("    {}) {} ;;\n", joined(patterns, " | "), assignments(option));
  }
  int place = 0;
  for (const OptionFacts& facts : place_facts(app)) {
    text += fmt::format("    '{} {}') {} ;;\n", command, ++place, assignments(facts));
  }
  return text;
}

std::string option_names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const OptionFacts& option : option_facts(app)) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return joined(names, " ");
}

/// What is the same for all programs. It walks the words before the cursor: which command there is,
/// how many of its places are taken, and which option waits for a value. Bash parts --option=value
/// into three words, unless the user has told it not to.
constexpr const char* kBody = R"sh(
_{0}_files() {
  local file ending
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if [[ -d $file || $files == '*' ]]; then
      COMPREPLY+=("$file")
      continue
    fi
    for ending in $files; do
      [[ ${file,,} == *."$ending" ]] && COMPREPLY+=("$file")
    done
  done < <(compgen -f -- "$1")
}

_{0}_reply() {
  local word
  while IFS= read -r word; do
    COMPREPLY+=("$2$word")
    [[ $word == *= ]] && compopt -o nospace 2>/dev/null
  done < <(compgen -W "$words" -- "$1")
  [[ -z $files ]] || _{0}_files "$1"
}

_{0}() {
  local current=${COMP_WORDS[COMP_CWORD]} command='' option='' setting='' given=0 place=1
  local i word words files must
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ -z $command ]]; then
      [[ $word == -* ]] || command=$word
    elif [[ $word == = ]]; then
      [[ -n $option ]] || option=--${setting//_/-}
      given=1
    elif [[ -n $option ]] && _{0}_value "$command" "$option" &&
      { ((must || given)) || [[ " $words " == *" $word "* ]]; }; then
      setting=
      [[ $option != --set ]] || setting=$word
      option= given=0
    elif [[ $word == -* ]]; then
      option= given=0
      [[ $word == *=* ]] || ! _{0}_value "$command" "$word" || option=$word
    else
      option= given=0
      ((++place))
    fi
  done
  if [[ -z $command ]]; then
    words="$(_{0}_commands) $(_{0}_options '')" files=
    _{0}_reply "$current" ''
    return
  fi
  if [[ $current == = ]]; then
    [[ -n $option ]] || option=--${setting//_/-}
    current= given=1
  fi
  if [[ $current == --*=* ]] && _{0}_value "$command" "${current%%=*}"; then
    _{0}_reply "${current#*=}" "${current%%=*}="
    return
  fi
  if [[ -n $option ]] && _{0}_value "$command" "$option"; then
    _{0}_reply "$current" ''
    ((must || given)) && return
  fi
  if [[ $current == -* ]]; then
    words=$(_{0}_options "$command") files=
    _{0}_reply "$current" ''
  elif _{0}_value "$command" "$place"; then
    _{0}_reply "$current" ''
  fi
}

complete -F _{0} {0}
)sh";

}  // namespace

std::string bash_completion(const CLI::App& program) {
  const std::string name = program.get_name();
  std::vector<std::string> commands;
  std::string options = fmt::format("    '') echo '{}' ;;\n", option_names_of(program));
  std::string values;
  for (const CLI::App* command : commands_of(program)) {
    commands.push_back(command->get_name());
    options +=
        fmt::format("    {}) echo '{}' ;;\n", command->get_name(), option_names_of(*command));
    values += branches(command->get_name(), *command);
  }
  std::string text = fmt::format(
      "# Completion of {0} for bash, printed by `{0} completion bash`.\n\n"
      "_{0}_commands() {{ echo '{1}'; }}\n\n"
      "_{0}_options() {{\n  case $1 in\n{2}  esac\n}}\n\n"
      "_{0}_value() {{\n  words= files= must=0\n  case \"$1 $2\" in\n{3}"
      "    *) return 1 ;;\n  esac\n}}\n",
      name, joined(commands, " "), options, values);
  std::string body = kBody;
  return text + CLI::detail::find_and_replace(body, "{0}", name);
}

}  // namespace surfmesh
