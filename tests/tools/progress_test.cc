// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>
#include <regex>
#include <string>

#include "support/program.hh"
#include "support/pseudo_terminal.hh"

namespace surfmesh {
namespace {

using testing::PseudoTerminal;
using testing::shown_lines;

/// Some seconds of work, until a test ends it.
constexpr const char* kLongRun = " -o out.obj --hmin 0.05% --hmax 0.05% --patches faces";

constexpr std::string_view kDrawing = "\r\x1b[J";

class ProgressOnTerminal : public Program {
 protected:
  std::string line(const std::string& options,
                   const std::string& environment = "TERM=xterm LC_ALL=C") {
    return "env " + environment + " sh -c \"cd " + folder_.path().string() +
           " && exec " SURFMESH_PROGRAM " " + options + "\"";
  }

  std::string long_run() { return "mesh " + own_model("knob.obj") + kLongRun; }

  /// The width of the longest drawing, in bytes: these are ASCII.
  static std::size_t widest(const std::string& output) {
    std::size_t most = 0;
    for (std::size_t at = output.find(kDrawing); at != output.npos;
         at = output.find(kDrawing, at + 1)) {
      const std::size_t start = at + kDrawing.size();
      most = std::max(most, output.find_first_of("\r\n", start) - start);
    }
    return most;
  }

  static long drawings(const std::string& output) {
    long count = 0;
    for (std::size_t at = output.find(kDrawing); at != output.npos;
         at = output.find(kDrawing, at + 1)) {
      ++count;
    }
    return count;
  }
};

TEST_F(ProgressOnTerminal, ShowsStageShareElementsAndTime) {
  PseudoTerminal terminal(line(long_run()), 80);
  static const std::regex drawing(R"(mesh \d+/\d+  \[#+\.+\] +\d+ %  \d+ elements  \d+\.\d s\r)");
  ASSERT_TRUE(terminal.wait_for("mesh ")) << terminal.output();
  ASSERT_TRUE(terminal.wait_for(" elements")) << terminal.output();
  ASSERT_TRUE(terminal.wait_for(" s\r", terminal.output().rfind(" elements")));
  EXPECT_TRUE(std::regex_search(terminal.output(), drawing)) << terminal.output();
  terminal.send(SIGTERM);
  EXPECT_EQ(terminal.wait(), 143);
}

TEST_F(ProgressOnTerminal, LeavesNothingBehindInTheEnd) {
  PseudoTerminal terminal(
      line("mesh " + own_model("knob.obj") + " -o out.obj --hmin 0.15% --hmax 0.15%"), 80);
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_GT(drawings(terminal.output()), 1);
  const auto lines = shown_lines(terminal.output());
  ASSERT_GT(lines.size(), 10u);
  EXPECT_TRUE(lines.front().starts_with("input     ")) << lines.front();
  for (const std::string& shown : lines) EXPECT_EQ(shown.find(" elements  "), shown.npos) << shown;
}

TEST_F(ProgressOnTerminal, LeavesNothingBehindAfterAnError) {
  // The mesh cannot be written: no file may be that large.
  PseudoTerminal terminal(
      "sh -c 'ulimit -f 100; exec " +
          line("mesh " + own_model("knob.obj") + " -o out.obj --hmin 0.15% --hmax 0.15%") + "'",
      80);
  EXPECT_EQ(terminal.wait(), 1);
  EXPECT_GT(drawings(terminal.output()), 1);
  const auto lines = shown_lines(terminal.output());
  ASSERT_EQ(lines.size(), 1u) << terminal.output();
  EXPECT_TRUE(lines.front().starts_with("surfmesh: error: ")) << lines.front();
}

TEST_F(ProgressOnTerminal, LeavesNothingBehindAfterASignal) {
  for (const int signals : {1, 2}) {
    PseudoTerminal terminal(line(long_run()), 80);
    ASSERT_TRUE(terminal.wait_for("mesh ")) << terminal.output();
    for (int i = 0; i < signals; ++i) terminal.send(SIGINT);
    EXPECT_EQ(terminal.wait(), 130);
    EXPECT_EQ(shown_lines(terminal.output()),
              std::vector<std::string>{"surfmesh: stopped by a signal"});
  }
}

TEST_F(ProgressOnTerminal, DrawsAtMostTenTimesASecond) {
  PseudoTerminal terminal(line(long_run()), 80);
  ASSERT_TRUE(terminal.wait_for(kDrawing));
  const auto start = std::chrono::steady_clock::now();
  const std::size_t before = terminal.output().size();
  for (int i = 0; i < 12; ++i) terminal.wait_for(kDrawing, terminal.output().size());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LE(drawings(terminal.output().substr(before)), 10 * seconds + 1);
  terminal.send(SIGTERM);
  terminal.wait();
}

TEST_F(ProgressOnTerminal, FitsATerminalThatIsMadeNarrower) {
  PseudoTerminal terminal(line(long_run()), 60);
  ASSERT_TRUE(terminal.wait_for("mesh ")) << terminal.output();
  ASSERT_TRUE(terminal.wait_for(kDrawing, terminal.output().size()));
  EXPECT_LT(widest(terminal.output()), 60u);
  EXPECT_GT(widest(terminal.output()), 40u);
  terminal.resize(25);
  // One drawing may be under way meanwhile.
  std::size_t from = 0;
  for (int i = 0; i < 3; ++i) {
    from = terminal.output().size();
    ASSERT_TRUE(terminal.wait_for(kDrawing, from));
  }
  ASSERT_TRUE(terminal.wait_for("\r", terminal.output().rfind(kDrawing) + kDrawing.size()));
  const std::size_t last = terminal.output().rfind(kDrawing, terminal.output().rfind('\r') - 1);
  EXPECT_LT(widest(terminal.output().substr(last)), 25u);
  terminal.send(SIGTERM);
  EXPECT_EQ(terminal.wait(), 143);
}

TEST_F(ProgressOnTerminal, TellsStagesInLinesOnADumbTerminal) {
  for (const char* environment : {"TERM=dumb", "-u TERM"}) {
    PseudoTerminal terminal(
        line("mesh " + own_model("torus.obj") + " -o out.obj --patches faces", environment), 80);
    EXPECT_EQ(terminal.wait(), 0);
    EXPECT_EQ(terminal.output().find('\x1b'), std::string::npos) << environment;
    const auto lines = shown_lines(terminal.output());
    ASSERT_GT(lines.size(), 7u);
    const std::vector<std::string> stages(lines.begin(), lines.begin() + 4);
    EXPECT_EQ(stages, (std::vector<std::string>{"surfmesh: read", "surfmesh: control (48)",
                                                "surfmesh: boundary (96)", "surfmesh: mesh (48)"}));
  }
}

TEST_F(ProgressOnTerminal, HasNoColours) {
  for (const char* environment : {"TERM=xterm", "TERM=xterm NO_COLOR=1"}) {
    PseudoTerminal terminal(line(long_run() + " --max-elements 30000", environment), 80);
    EXPECT_EQ(terminal.wait(), 1);
    EXPECT_FALSE(std::regex_search(terminal.output(), std::regex("\x1b\\[[0-9;]*m")));
  }
}

TEST_F(ProgressOnTerminal, IsNotShownWithQuiet) {
  PseudoTerminal terminal(
      line("mesh " + own_model("knob.obj") + " -o out.obj --quiet --hmin 0.4% --hmax 0.4%"), 80);
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_EQ(terminal.output(), "");
}

TEST_F(ProgressOnTerminal, IsNotShownWhereErrorsGoElsewhere) {
  PseudoTerminal terminal(
      line("mesh " + own_model("knob.obj") + " -o out.obj --hmin 0.15% --hmax 0.15% 2>errors"), 80);
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_EQ(terminal.output().find('\x1b'), std::string::npos);
  EXPECT_EQ(read_text(folder_ / "errors"), "");
}

TEST_F(ProgressOnTerminal, ShowsTheStagesOfACheck) {
  EXPECT_EQ(run("mesh " + own_model("knob.obj") + " -o a.om --quiet --hmin 0.6% --hmax 0.6%"), 0);
  PseudoTerminal terminal(line("check a.om --model " + own_model("knob.obj")), 80);
  EXPECT_TRUE(terminal.wait_for("compare  [")) << terminal.output();
  EXPECT_EQ(terminal.wait(), 0);
  EXPECT_TRUE(shown_lines(terminal.output()).front().starts_with("mesh      "));
}

TEST_F(ProgressOnTerminal, DrawsBlocksWhereTheLocaleHasThem) {
  for (const auto& [locale, has_blocks] :
       {std::pair("TERM=xterm LC_ALL=C.UTF-8", true), std::pair("TERM=xterm LC_ALL=C", false)}) {
    PseudoTerminal terminal(
        line("mesh " + own_model("knob.obj") + " -o out.obj --hmin 0.15% --hmax 0.15%", locale),
        80);
    EXPECT_EQ(terminal.wait(), 0);
    EXPECT_EQ(terminal.output().find("█") != std::string::npos, has_blocks) << locale;
    EXPECT_EQ(terminal.output().find("√2") != std::string::npos, has_blocks) << locale;
  }
  EXPECT_EQ(run("mesh " + own_model("knob.obj") + " -o out.obj", "LC_ALL=C.UTF-8"), 0);
  for (const char c : out_) EXPECT_GE(c, 0);  // no terminal, so ASCII
}

}  // namespace
}  // namespace surfmesh
