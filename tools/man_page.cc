// SPDX-License-Identifier: BSD-3-Clause
#include "man_page.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "option_facts.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/formula/formula.hh"

namespace surfmesh {
namespace {

constexpr std::string_view kExamples = "Example";  // and "Examples"
constexpr std::string_view kExitStatus = "Exit status: ";

/// Text as roff prints it: hyphens that can be copied, and no letter that begins a request.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", plain(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", plain(text)); }

/// What the footer of a help tells, by its kinds of paragraphs.
struct Footer {
  std::vector<std::string> paragraphs;  ///< each in one line
  std::vector<std::string> examples;    ///< as they stand
  std::string exit_status;              ///< empty for none
};

bool is_end_of_word(const std::string& text) { return text.empty() || text.ends_with(' '); }

/// A line that begins with blanks goes on with the paragraph before it; below "Example:" it is one.
Footer parse_footer(const std::string& text) {
  Footer footer;
  std::string* paragraph = nullptr;
  bool is_example = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start == line.npos) continue;
    if (start == 0) {
      is_example = line.starts_with(kExamples);
      if (is_example) continue;
      const bool is_status = line.starts_with(kExitStatus);
      paragraph = is_status ? &footer.exit_status : &footer.paragraphs.emplace_back();
      *paragraph = is_status ? line.substr(kExitStatus.size()) : line;
    } else if (is_example || !paragraph) {
      footer.examples.push_back(line.substr(start));
    } else {
      *paragraph += (is_end_of_word(*paragraph) ? "" : " ") + line.substr(start);
    }
  }
  return footer;
}

/// Makes the text of a page.
class Page {
 public:
  void section(std::string_view name) { text_ += fmt::format(".SH {}\n", name); }
  void subsection(std::string_view name) { text_ += fmt::format(".SS {}\n", plain(name)); }
  void line(std::string_view text) { text_ += fmt::format("{}\n", plain(text)); }
  void raw(std::string_view text) { text_ += fmt::format("{}\n", text); }

  void item(std::string_view marked_up_name, std::string_view text) {
    text_ += fmt::format(".TP\n{}\n{}\n", marked_up_name, plain(text));
  }

  void as_it_stands(const std::vector<std::string>& lines) {
    text_ += ".nf\n";
    for (const std::string& one : lines) line(one);
    text_ += ".fi\n";
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string page_name(const CLI::App& app) {
  return app.get_parent() ? fmt::format("{}-{}", app.get_parent()->get_name(), app.get_name())
                          : app.get_name();
}

/// "mesh a cage" of "Mesh a cage.", as lists of pages have it.
std::string short_description(const CLI::App& app) {
  std::string text = app.get_description();
  if (text.ends_with('.')) text.pop_back();
  const bool is_word = text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0;
  if (is_word) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

std::string names_of(const OptionFacts& facts) {
  std::string text;
  for (const std::string& name : facts.names) {
    text += text.empty() ? "" : ", ";
    text += bold(name);
  }
  if (!facts.placeholder.empty() && facts.use != ValueUse::None) {
    const std::string value = italic(facts.placeholder);
    text += facts.use == ValueUse::MayStandAlone ? fmt::format(" [{}]", value)
                                                 : fmt::format(" {}", value);
  }
  return text;
}

std::string full_text(const OptionFacts& facts) {
  std::string text = facts.text;
  if (!facts.default_value.empty()) {
    text += fmt::format("{}Default: {}.", text.ends_with('.') ? " " : ". ", facts.default_value);
  }
  for (const std::string& needed : facts.needs) text += fmt::format(" Only with {}.", needed);
  return text;
}

void add_synopsis(const CLI::App& app, Page& page) {
  page.section("SYNOPSIS");
  if (!app.get_parent()) {
    page.raw(fmt::format("{} {} [{}]", bold(app.get_name()), italic("COMMAND"), italic("OPTIONS")));
    return;
  }
  std::string text = fmt::format("{} {} [{}]", bold(app.get_parent()->get_name()),
                                 bold(app.get_name()), italic("OPTIONS"));
  for (const OptionFacts& place : place_facts(app)) {
    const std::string shown = italic(place.names.front());
    text += place.is_required ? fmt::format(" {}", shown) : fmt::format(" [{}]", shown);
  }
  page.raw(text);
}

void add_options(const CLI::App& app, Page& page) {
  page.section("OPTIONS");
  for (const OptionFacts& place : place_facts(app)) {
    page.item(italic(place.names.front()), full_text(place));
  }
  const std::vector<OptionFacts> options = option_facts(app);
  for (const std::string& group : app.get_groups()) {
    bool is_begun = group == "Options";
    for (const OptionFacts& option : options) {
      if (option.group != group || option.group.empty()) continue;
      if (!is_begun) page.subsection(group);
      is_begun = true;
      page.item(names_of(option), full_text(option));
    }
  }
}

void add_commands(const CLI::App& app, Page& page) {
  const auto commands = commands_of(app);
  if (commands.empty()) return;
  page.section("COMMANDS");
  for (const CLI::App* command : commands) {
    page.item(bold(command->get_name()), command->get_description());
  }
}

/// "3" and "done, but ..." of "3 done, but ...". Statuses may be several: "130, 143 stopped".
std::pair<std::string, std::string> split_status(const std::string& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789, "), text.size());
  std::string status = text.substr(0, end);
  status.erase(status.find_last_not_of(' ') + 1);
  return {status, text.substr(end)};
}

/// The statuses are those of the program, whatever the command.
void add_exit_status(const CLI::App& app, Page& page) {
  const CLI::App& program = app.get_parent() ? *app.get_parent() : app;
  std::string rest = parse_footer(program.get_footer()).exit_status;
  if (rest.empty()) return;
  page.section("EXIT STATUS");
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("; "), rest.size());
    const auto [status, meaning] = split_status(rest.substr(0, end));
    page.item(bold(status), meaning);
    rest.erase(0, end + 2);
  }
}

void add_files(Page& page) {
  page.section("FILES");
  page.line("Below the folder that surfmesh is installed in:");
  page.item(italic("share/surfmesh/models"),
            "models to try, and surfmesh.schema.json, by which editors complete and check model "
            "files");
  page.item(italic("share/doc/surfmesh/libsurfmesh/REFERENCE.md"),
            "all of the command line, the model file and the rules of cages");
}

void add_see_also(const CLI::App& app, Page& page) {
  page.section("SEE ALSO");
  const CLI::App& program = app.get_parent() ? *app.get_parent() : app;
  std::vector<std::string> names;
  if (&program != &app) names.push_back(page_name(program));
  for (const CLI::App* command : commands_of(program)) {
    if (command != &app) names.push_back(page_name(*command));
  }
  std::string text;
  for (const std::string& name : names) {
    text += text.empty() ? "" : ", ";
    text += fmt::format("{}(1)", bold(name));
  }
  page.raw(text);
}

}  // namespace

std::string man_page(const CLI::App& app) {
  const std::string name = page_name(app);
  std::string title = name;
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const Footer footer = parse_footer(app.get_footer());
  Page page;
  page.raw(fmt::format(".TH {} 1 \"\" \"surfmesh {}\" \"User Commands\"", plain(title),
                       SURFMESH_VERSION));
  page.section("NAME");
  page.raw(fmt::format("{} \\- {}", plain(name), plain(short_description(app))));
  add_synopsis(app, page);
  page.section("DESCRIPTION");
  page.line(app.get_description());
  for (const std::string& paragraph : footer.paragraphs) {
    page.raw(".PP");
    page.line(paragraph);
  }
  add_commands(app, page);
  add_options(app, page);
  if (app.get_option_no_throw("--help-all")) {
    page.section("FORMULAS");
    page.line("Functions of formulas in model files:");
    page.raw(".PP");
    page.line(formula_functions());
  }
  if (!footer.examples.empty()) {
    page.section("EXAMPLES");
    page.as_it_stands(footer.examples);
  }
  add_exit_status(app, page);
  add_files(page);
  add_see_also(app, page);
  return page.take();
}

}  // namespace surfmesh
