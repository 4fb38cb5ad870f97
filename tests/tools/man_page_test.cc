// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {
namespace {

class ManPage : public Program {
 protected:
  bool has(const std::string& program) { return shell("command -v " + program) == 0; }

  /// A page as a reader sees it, in one line, without marks.
  std::string shown(const std::string& command) {
    EXPECT_EQ(run("man " + command), 0) << err_;
    const std::string page = out_;
    write_text(folder_ / "page.1", page);
    EXPECT_EQ(shell("MANWIDTH=5000 LC_ALL=C.UTF-8 man -l page.1 | col -bx"), 0) << err_;
    std::string text;
    for (const char c : out_) {
      const char blank = c == '\n' ? ' ' : c;
      if (blank != ' ' || !text.ends_with(' ')) text += blank;
    }
    return text;
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

/// The commands that the help of the program lists.
std::vector<std::string> commands_in(const std::string& help) {
  std::vector<std::string> commands;
  std::istringstream lines(help.substr(help.find("Subcommands:\n") + 13));
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] != ' ') commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

TEST_F(ManPage, IsThereForEachCommand) {
  EXPECT_EQ(run("--help"), 0);
  std::vector<std::string> expected = {"surfmesh.1"};
  for (const std::string& command : commands_in(out_)) {
    expected.push_back("surfmesh-" + command + ".1");
  }
  EXPECT_GE(expected.size(), 7u);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(run("man --folder ."), 0) << err_;
  EXPECT_EQ(files(), expected);
  const std::string page = read_text(folder_ / "surfmesh-mesh.1");
  EXPECT_EQ(run("man mesh"), 0);
  EXPECT_EQ(out_, page);
  EXPECT_TRUE(page.starts_with(".TH SURFMESH\\-MESH 1 \"\" \"surfmesh " SURFMESH_VERSION "\""));
}

TEST_F(ManPage, IsSoundRoff) {
  EXPECT_EQ(run("man --folder ."), 0) << err_;
  for (const std::string& file : files()) {
    if (has("groff")) {
      EXPECT_EQ(shell("groff -ww -Kutf8 -Tutf8 -man " + file + " >/dev/null"), 0);
      EXPECT_EQ(err_, "") << file;
    }
    if (has("mandoc")) {
      EXPECT_EQ(shell("mandoc -T lint -W error " + file), 0) << out_;
    }
  }
}

TEST_F(ManPage, HasTheSectionsOfAManual) {
  for (const std::string command : {"", "mesh", "check", "convert", "control"}) {
    EXPECT_EQ(run("man " + command), 0);
    std::size_t last = 0;
    for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLES",
                                "EXIT STATUS", "FILES", "SEE ALSO"}) {
      const std::size_t place = out_.find(std::string("\n.SH ") + section + "\n", last);
      ASSERT_NE(place, std::string::npos) << command << ' ' << section;
      last = place;
    }
  }
}

TEST_F(ManPage, ExplainsEveryOptionWithItsRangeAndDefault) {
  if (!has("man") || !has("col")) GTEST_SKIP() << "no program man or col";
  const std::string text = shown("mesh");
  for (const Option& option : option_table()) {
    std::string flag = "--" + std::string(option.name());
    std::replace(flag.begin(), flag.end(), '_', '-');
    const std::size_t place = text.find(' ' + flag + ' ');
    ASSERT_NE(place, std::string::npos) << flag;
    const std::string entry = text.substr(place, text.find(" --", place + 3) - place);
    EXPECT_NE(entry.find(std::string(option.text)), std::string::npos) << entry;
    EXPECT_NE(entry.find("Default: " + option.value_text({}) + '.'), std::string::npos) << entry;
  }
  EXPECT_NE(text.find("off, or a number from 1 to 1000000"), std::string::npos);
  EXPECT_NE(text.find(formula_functions()), std::string::npos);
  EXPECT_NE(text.find("-o, --output FILE "), std::string::npos);
  EXPECT_NE(text.find("--quads [on|off] quads in place of triangles"), std::string::npos);
}

TEST_F(ManPage, TellsCommandsExitStatusAndExamples) {
  if (!has("man") || !has("col")) GTEST_SKIP() << "no program man or col";
  const std::string text = shown("");
  for (const char* part :
       {"surfmesh - mesh multi-patch parametric surfaces", "surfmesh COMMAND [OPTIONS]",
        "convert Write a mesh in another format, chosen by the ending.",
        "surfmesh mesh cage.obj -o mesh.om mesh the limit surface of a cage",
        "2 wrong usage 3 done, but something asked for was not reached, or check found a fault "
        "130, 143 stopped by a signal",
        "surfmesh-check(1)"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  const std::string check = shown("check");
  for (const char* part : {"surfmesh check [OPTIONS] MESH", "Only with --model.",
                           "surfmesh check knob.om --model knob.obj --json", "surfmesh(1), "}) {
    EXPECT_NE(check.find(part), std::string::npos) << part;
  }
}

TEST_F(ManPage, RefusesWhatIsNotThere) {
  EXPECT_EQ(run("man mess"), 2);
  EXPECT_TRUE(says("there is no command mess")) << err_;
  EXPECT_EQ(run("man --folder none"), 1);
  EXPECT_TRUE(says("surfmesh: error: ")) << err_;
  EXPECT_EQ(folder_.count(), 0);
}

}  // namespace
}  // namespace surfmesh
