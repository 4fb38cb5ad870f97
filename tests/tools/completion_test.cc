// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {
namespace {

using Words = std::set<std::string>;

class Completion : public Program {
 protected:
  void SetUp() override {
    for (const char* name : {"a.obj", "b.OM", "c.json", "d.step", "e.txt", "f g.ply", "h.igs"}) {
      write_text(folder_ / name, "");
    }
    std::filesystem::create_directory(folder_ / "parts");
  }
};

/// As in an interactive bash: the words of the line, parted at = as well, and the cursor in the
/// last one.
class BashCompletion : public Completion {
 protected:
  Words complete(const std::vector<std::string>& words) {
    std::string quoted;
    for (const std::string& word : words) quoted += " '" + word + "'";
    write_text(folder_ / "try.bash",
               fmt::format("source <('{}' completion bash)\n"
                           "COMP_WORDS=({})\nCOMP_CWORD={}\n_surfmesh\n"
                           "[[ ${{#COMPREPLY[@]}} = 0 ]] || printf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
                           SURFMESH_PROGRAM, quoted, words.size() - 1));
    EXPECT_EQ(shell("bash --norc try.bash"), 0) << err_;
    EXPECT_EQ(err_, "");
    std::filesystem::remove(folder_ / "try.bash");
    std::istringstream lines(out_);
    Words replies;
    for (std::string line; std::getline(lines, line);) replies.insert(line);
    return replies;
  }
};

TEST_F(BashCompletion, KnowsTheCommands) {
  EXPECT_EQ(complete({"surfmesh", "me"}), (Words{"mesh"}));
  EXPECT_EQ(complete({"surfmesh", "con"}), (Words{"control", "convert"}));
  const Words all = complete({"surfmesh", ""});
  for (const char* command : {"mesh", "check", "convert", "control", "completion", "man"}) {
    EXPECT_TRUE(all.contains(command)) << command;
  }
  EXPECT_TRUE(all.contains("--version"));
  EXPECT_EQ(complete({"surfmesh", "mess", ""}), Words());
}

TEST_F(BashCompletion, KnowsEveryOption) {
  const Words all = complete({"surfmesh", "mesh", "--"});
  for (const Option& option : option_table()) {
    std::string flag = "--" + std::string(option.name());
    std::replace(flag.begin(), flag.end(), '_', '-');
    EXPECT_TRUE(all.contains(flag)) << flag;
  }
  EXPECT_EQ(complete({"surfmesh", "mesh", "a.obj", "--quad-"}),
            (Words{"--quad-front", "--quad-method"}));
  EXPECT_EQ(complete({"surfmesh", "convert", "--no"}), (Words{"--normals"}));
  EXPECT_FALSE(complete({"surfmesh", "check", "--"}).contains("--quad-method"));
}

TEST_F(BashCompletion, KnowsTheChoicesOfOptions) {
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quad-method", ""}), (Words{"best", "frontal"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quad-method", "f"}), (Words{"frontal"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quad-method", "="}), (Words{"best", "frontal"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quad-method", "=", "b"}), (Words{"best"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quad-method=b"}), (Words{"--quad-method=best"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--curvature", ""}), (Words{"off"}));
  EXPECT_EQ(complete({"surfmesh", "check", "--scheme", "l"}), (Words{"loop"}));
  EXPECT_EQ(complete({"surfmesh", "completion", ""}), (Words{"bash", "zsh"}));
  EXPECT_TRUE(complete({"surfmesh", "man", "co"}).contains("convert"));
}

TEST_F(BashCompletion, TakesSwitchesWithAndWithoutAValue) {
  const Words both = complete({"surfmesh", "mesh", "--quads", ""});
  for (const char* word : {"on", "off", "a.obj"}) EXPECT_TRUE(both.contains(word)) << word;
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quads", "=", ""}), (Words{"off", "on"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quads", "on", "a"}), (Words{"a.obj"}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--quads", "--quad-m"}), (Words{"--quad-method"}));
}

TEST_F(BashCompletion, SetsOptionsByName) {
  EXPECT_EQ(complete({"surfmesh", "mesh", "--set", "quad"}),
            (Words{"quad_front=", "quad_method=", "quads="}));
  EXPECT_EQ(complete({"surfmesh", "mesh", "--set", "quad_method", "=", ""}),
            (Words{"best", "frontal"}));
}

TEST_F(BashCompletion, OffersFilesWhoseEndingsFit) {
  EXPECT_EQ(complete({"surfmesh", "mesh", ""}),
            (Words{"a.obj", "b.OM", "c.json", "d.step", "f g.ply", "h.igs", "parts"}));
  const Words meshes = {"a.obj", "b.OM", "f g.ply", "parts"};
  EXPECT_EQ(complete({"surfmesh", "check", ""}), meshes);
  EXPECT_EQ(complete({"surfmesh", "mesh", "a.obj", "-o", ""}), meshes);
  EXPECT_EQ(complete({"surfmesh", "mesh", "a.obj", "--output", "f"}), (Words{"f g.ply"}));
  EXPECT_EQ(complete({"surfmesh", "convert", "b.OM", ""}), meshes);
  EXPECT_EQ(complete({"surfmesh", "mesh", "a.obj", "--report", ""}), (Words{"c.json", "parts"}));
  EXPECT_EQ(complete({"surfmesh", "check", "a.obj", "--model", ""}),
            complete({"surfmesh", "mesh", ""}));
  EXPECT_EQ(complete({"surfmesh", "man", "--folder", ""}), (Words{"parts"}));
  EXPECT_EQ(complete({"surfmesh", "check", "a.obj", ""}), Words());
}

TEST_F(Completion, IsASoundScriptOfBash) {
  EXPECT_EQ(run("completion bash > script"), 0);
  EXPECT_EQ(shell("'" SURFMESH_PROGRAM "' completion bash | bash -n"), 0) << err_;
}

/// A zsh on a terminal of its own, in which a line is typed up to the tab key. What it completes is
/// printed by a function in the program's place.
class ZshCompletion : public Completion {
 protected:
  void SetUp() override {
    Completion::SetUp();
    if (shell("zsh -fc true") != 0) GTEST_SKIP() << "no program zsh";
    write_text(folder_ / "try.zsh", R"zsh(
zmodload zsh/zpty
zpty shell "TERM=dumb zsh -f -i"
tell() { zpty -w shell "$1" }
tell 'PS1= PS2=; unsetopt prompt_sp prompt_cr; setopt no_beep'
tell 'autoload -Uz compinit && compinit -D; bindkey "^I" complete-word'
tell "source <($1 completion zsh)"
tell 'surfmesh() { print -r -- "got"": $*" }'
zpty -w -n shell "$2"$'\t\n'
zpty -r -m shell output $'*got: *\n*'
print -r -- "$output"
zpty -d shell
)zsh");
  }

  /// The words of the line, as it was completed.
  std::string complete(const std::string& line) {
    EXPECT_EQ(shell("timeout 60 zsh -f try.zsh '" SURFMESH_PROGRAM "' '" + line + "'"), 0) << err_;
    const std::size_t start = out_.rfind("got: ");
    if (start == out_.npos) return out_;
    return out_.substr(start + 5, out_.find_first_of("\r\n", start) - start - 5);
  }
};

TEST_F(ZshCompletion, CompletesCommandsOptionsChoicesAndFiles) {
  for (const auto& [typed, completed] :
       {std::pair("surfmesh me", "mesh"), std::pair("surfmesh mesh --quad-m", "mesh --quad-method"),
        std::pair("surfmesh mesh --quad-method fr", "mesh --quad-method frontal"),
        std::pair("surfmesh mesh --quad-method=b", "mesh --quad-method=best"),
        std::pair("surfmesh mesh --set quad_m", "mesh --set quad_method="),
        std::pair("surfmesh mesh a", "mesh a.obj"), std::pair("surfmesh check b", "check b.OM"),
        std::pair("surfmesh mesh a.obj -o b", "mesh a.obj -o b.OM"),
        std::pair("surfmesh man conve", "man convert")}) {
    EXPECT_EQ(complete(typed), completed) << out_;
  }
}

TEST_F(Completion, RefusesOtherShells) {
  EXPECT_EQ(run("completion fish"), 2);
  EXPECT_TRUE(says("SHELL")) << err_;
  EXPECT_EQ(run("completion"), 2);
}

}  // namespace
}  // namespace surfmesh
