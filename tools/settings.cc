// SPDX-License-Identifier: BSD-3-Clause
#include "settings.hh"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "cad.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kColumn = 32;
constexpr std::size_t kScreen = 100;

/// The text in lines that fit beside the column of the names, or have another width.
std::string wrapped(std::string text, std::size_t width = kScreen - kColumn) {
  std::size_t start = 0;
  while (text.size() - start > width) {
    const std::size_t blank = text.rfind(' ', start + width);
    if (blank == text.npos || blank <= start) break;
    text[blank] = '\n';
    start = blank + 1;
  }
  return text;
}

/// Shows the flags that are most used, or all, without a double blank line between groups.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(kColumn); }

  void hide(const CLI::Option* flag) { hidden_.insert(flag); }
  void show(const CLI::Option* flag) { hidden_.erase(flag); }
  void show_all() { hidden_.clear(); }

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, name, mode);
    // Groups of which nothing is shown leave blank lines, as many as there are.
    for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;)
      text.erase(at, 1);
    return text.ends_with("\n\n") ? text.substr(0, text.size() - 1) : text;
  }

  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> flags) const override {
    std::erase_if(flags, [this](const CLI::Option* flag) { return hidden_.contains(flag); });
    if (flags.empty()) return "";
    return CLI::Formatter::make_group(std::move(group), is_positional, std::move(flags));
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_desc(option);
    return text.find('\n') == text.npos ? wrapped(std::move(text)) : text;
  }

 private:
  std::set<const CLI::Option*> hidden_;
};

const char* heading(OptionGroup group) {
  switch (group) {
    case OptionGroup::Sizes:
      return "Sizes (lengths in model units, or with % of the model's diagonal)";
    case OptionGroup::ControlSpace:
      return "Control space (where the sizes are kept)";
    case OptionGroup::Meshing:
      return "Meshing";
    case OptionGroup::Cages:
      return "Cages and patches";
  }
  return "";
}

/// "--max-elements" for "max_elements".
std::string flag_of(const Option& option) {
  std::string name(option.name());
  for (char& c : name) c = c == '_' ? '-' : c;
  return "--" + name;
}

/// What stands for the value in the help: "LENGTH", "off|NUMBER", "mesh|grid".
std::string placeholder(const Option& option) {
  const auto* number = std::get_if<NumberAccess>(&option.access);
  std::string text;
  const auto add = [&text](std::string_view word) {
    text += text.empty() ? "" : "|";
    text += word;
  };
  if (!number) {
    for (const std::string_view word : option.words()) {
      if (word != "true" && word != "false") add(word);
    }
    add("LENGTH");
    return text;
  }
  for (const OptionWord& word : number->range->words) {
    if (word.use == WordUse::Shown) add(word.word);
  }
  if (number->range->has_numbers()) add(number->range->is_whole ? "N" : "NUMBER");
  return text;
}

/// With unit and range; choices stand beside the flag already.
std::string long_text(const Option& option) {
  const bool is_length = std::holds_alternative<LengthAccess>(option.access);
  if (!is_length && !std::get<NumberAccess>(option.access).range->has_numbers()) {
    return std::string(option.text);
  }
  const std::string unit = option.unit.empty() || is_length ? "" : fmt::format("{}: ", option.unit);
  return fmt::format("{} ({}{})", option.text, unit, option.range_text());
}

bool is_switch(const Option& option) {
  const auto* number = std::get_if<NumberAccess>(&option.access);
  return number && number->range->is_switch();
}

/// True for options that may stand alone, which is "on": switches, and lengths that know the word.
bool may_stand_alone(const Option& option) {
  const auto* length = std::get_if<LengthAccess>(&option.access);
  return is_switch(option) || (length && length->range->on > 0);
}

/// Such an option has a value, too: see with_switch_values.
CLI::Option* add_flag(CLI::App& command, Settings& settings, const Option& option) {
  const std::string name(option.name());
  CLI::Option* flag = command.add_option_function<std::string>(
      flag_of(option),
      [&settings, name](const std::string& value) { settings.emplace_back(name, value); },
      wrapped(std::string(option.text)));
  flag->option_text(
      fmt::format("{}={}", placeholder(option), option.value_text(PipelineOptions())));
  flag->group(heading(option.group));
  flag->check([name](const std::string& value) { return fault_of(name, value); });
  return flag;
}

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos || mark == 0) {
    throw CLI::ValidationError(fmt::format("'{}' is not key=value", text));
  }
  return {text.substr(0, mark), text.substr(mark + 1)};
}

/// True for what may be meant as the value of an option that may stand alone, not for options and
/// files.
bool is_value(const std::string& argument, const Option& option) {
  if (!is_switch(option)) return fault_of(std::string(option.name()), argument).empty();
  return !argument.starts_with('-') && argument.find_first_of("./") == std::string::npos;
}

void add_help_all(CLI::App& command, const std::shared_ptr<HelpFormatter>& formatter) {
  command.add_flag_callback(
      "--help-all",
      [&command, formatter] {
        formatter->show_all();
        for (const Option& option : option_table()) {
          CLI::Option* flag = command.get_option_no_throw(flag_of(option));
          if (flag) flag->description(wrapped(long_text(option)));
        }
        command.footer(fmt::format("{}\nFunctions of formulas (libsurfmesh/REFERENCE.md):\n{}\n",
                                   command.get_footer(), wrapped(formula_functions(), kScreen)));
        throw CLI::CallForHelp();
      },
      "show every option with its range and exit");
}

}  // namespace

void hide_in_short_help(CLI::App& command, const CLI::Option* flag) {
  std::dynamic_pointer_cast<HelpFormatter>(command.get_formatter())->hide(flag);
}

void show_in_short_help(CLI::App& command, const CLI::Option* flag) {
  std::dynamic_pointer_cast<HelpFormatter>(command.get_formatter())->show(flag);
}

const Option* table_option(const CLI::Option& flag) {
  for (const Option& option : option_table()) {
    // Another command may have a flag of that name for something else.
    if (flag.get_group() != heading(option.group)) continue;
    const std::string name = flag_of(option).substr(2);
    const auto& names = flag.get_lnames();
    if (std::find(names.begin(), names.end(), name) != names.end()) return &option;
  }
  return nullptr;
}

std::string long_text(const CLI::Option& flag) {
  const Option* option = table_option(flag);
  std::string text = option ? long_text(*option) : flag.get_description();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool may_stand_alone(const CLI::Option& flag) {
  const Option* option = table_option(flag);
  return option && may_stand_alone(*option);
}

void add_verbose(CLI::App& command, bool& is_verbose, const std::string& text) {
  command.add_flag("-v,--verbose", is_verbose, text);
}

std::string fault_of(const std::string& name, const std::string& value) {
  try {
    PipelineOptions scratch;
    set_option(scratch, name, value);
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<CLI::Option*> add_flags(CLI::App& command, Settings& settings,
                                    std::span<const OptionGroup> groups, ShortHelp short_help) {
  const auto formatter = std::make_shared<HelpFormatter>();
  command.formatter(formatter);
  add_help_all(command, formatter);
  std::vector<CLI::Option*> flags;
  for (const OptionGroup group : groups) {
    for (const Option& option : option_table()) {
      if (option.group != group) continue;
      flags.push_back(add_flag(command, settings, option));
      const bool is_shown = option.is_common && short_help == ShortHelp::MostUsed;
      if (!is_shown) formatter->hide(flags.back());
    }
  }
  return flags;
}

std::vector<std::string> with_switch_values(std::vector<std::string> arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto& table = option_table();
    const auto option = std::find_if(table.begin(), table.end(), [&](const Option& o) {
      return may_stand_alone(o) && flag_of(o) == arguments[i];
    });
    if (option == table.end()) continue;
    const bool has_value = i + 1 < arguments.size() && is_value(arguments[i + 1], *option);
    if (!has_value) arguments[i] += "=on";
  }
  return arguments;
}

LoadOptions load_options(Scheme scheme, const Settings& settings) {
  PipelineOptions options;
  for (const auto& [name, value] : settings) set_option(options, name, value);
  return {.cages = {.scheme = scheme,
                    .patches = options.patches,
                    .weld = options.weld,
                    .orient = options.orient,
                    .crease_angle = options.crease_angle,
                    .surface = options.surface,
                    .fit = options.fit},
          .joining = options.joining,
          .cad = {.sew = options.sew},
          .read_cad = cad_reader()};
}

void add_scheme(CLI::App& command, Scheme& scheme) {
  const std::map<std::string, Scheme> schemes = {{"auto", Scheme::Auto},
                                                 {"catmark", Scheme::CatmullClark},
                                                 {"loop", Scheme::Loop},
                                                 {"bilinear", Scheme::Bilinear}};
  command.add_option("--scheme", scheme, "subdivision scheme of a cage")
      ->transform(CLI::Transformer(schemes).description(""))
      ->type_name("catmark|loop|bilinear|auto")
      ->default_str("auto")
      ->group(heading(OptionGroup::Cages));
}

void add_set(CLI::App& command, Settings& settings, const std::string& text) {
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&settings](const std::vector<std::string>& texts) {
            for (const std::string& word : texts) settings.push_back(split_setting(word));
          },
          text)
      ->type_name("key=value")
      ->expected(1)
      ->take_all()
      ->check([](const std::string& word) {
        const auto [name, value] = split_setting(word);
        return fault_of(name, value);
      });
}

}  // namespace surfmesh
