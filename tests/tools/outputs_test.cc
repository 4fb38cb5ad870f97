// SPDX-License-Identifier: BSD-3-Clause
// What the program writes: all of it or nothing, and never over what it reads.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/program.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

class OutputsProgram : public Program {
 protected:
  void SetUp() override {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  }

  /// Expect the status of an error, its text, and that no file was left but so many.
  void expect_error(int status, const std::string& text, long files = 0) {
    EXPECT_EQ(status, 1);
    EXPECT_TRUE(says("surfmesh: error: " + text)) << err_;
    EXPECT_EQ(folder_.count(), files);
  }

  /// Run `surfmesh <arguments>` with its standard output elsewhere.
  int run_into(const std::string& sink, const std::string& arguments) {
    std::string line = "{ '" SURFMESH_PROGRAM "' ";
    line.append(arguments).append(" >").append(sink).append("; }");
    return shell(line);
  }

  const std::string wave_ = "mesh '" + own_model("wave.json") + "' --quiet -o ";
};

TEST_F(OutputsProgram, LeavesNoMeshWithoutItsReport) {
  expect_error(run(wave_ + "a.obj --report /dev/full"),
               "cannot write /dev/full: No space left on device");
}

TEST_F(OutputsProgram, KeepsTheOldMeshWithoutItsReport) {
  write_text(folder_ / "a.obj", "old");
  expect_error(run(wave_ + "a.obj --report /dev/full"), "cannot write /dev/full", 1);
  EXPECT_EQ(read_text(folder_ / "a.obj"), "old");
}

TEST_F(OutputsProgram, TellsThatAFileIsTooLarge) {
  for (const std::string name : {"a.obj", "a.off", "a.ply", "a.stl", "a.om"}) {
    expect_error(run(wave_ + name, "ulimit -f 8;"), "cannot write " + name + ": File too large");
  }
}

TEST_F(OutputsProgram, LeavesNoOtherFileThatIsTooLarge) {
  const std::string control = "control '" + own_model("wave.json") + "' -o a.vtu";
  expect_error(run(control, "ulimit -f 8;"), "cannot write a.vtu");
  EXPECT_EQ(run(wave_ + "a.om"), 0) << err_;
  expect_error(run("convert a.om b.ply", "ulimit -f 8;"), "cannot write b.ply", 1);
}

TEST_F(OutputsProgram, FailsIfItsResultCannotBePrinted) {
  EXPECT_EQ(run(wave_ + "a.obj"), 0) << err_;
  for (const char* command :
       {"--help", "--version", "mesh --help-all", "check a.obj", "check a.obj --json"}) {
    for (const char* sink : {"/dev/full", "&-"}) {
      EXPECT_EQ(run_into(sink, command), 1) << command << " >" << sink;
      EXPECT_TRUE(says("error: cannot write to the standard output: ")) << err_;
    }
  }
}

TEST_F(OutputsProgram, TellsThatNobodyReads) {
  EXPECT_EQ(run(wave_ + "a.obj"), 0) << err_;
  // The reader has ended when the program begins to write.
  shell("{ { sleep 0.2; '" SURFMESH_PROGRAM
        "' check a.obj --json; echo $? >status; } | true; "
        "sleep 0.5; }");
  EXPECT_EQ(read_text(folder_ / "status"), "1\n");
  EXPECT_TRUE(says("error: cannot write to the standard output: Broken pipe")) << err_;
}

TEST_F(OutputsProgram, WarnsOfASummaryThatIsLost) {
  const std::string mesh = "mesh '" + own_model("wave.json") + "' -o a.om";
  const std::string control = "control '" + own_model("wave.json") + "' -o a.vtu";
  for (const std::string& command : {mesh, control, std::string("convert a.om a.ply")}) {
    EXPECT_EQ(run_into("/dev/full", command), 3) << command;
    EXPECT_TRUE(says("warning: the summary is lost: cannot write to the standard output: No "))
        << err_;
  }
  EXPECT_EQ(folder_.count(), 3);
}

TEST_F(OutputsProgram, KeepsItsFilesApartFromAClosedOutput) {
  EXPECT_EQ(run(wave_ + "a.obj"), 0) << err_;
  const std::string expected = read_text(folder_ / "a.obj");
  EXPECT_EQ(run_into("&- 2>&-", "mesh '" + own_model("wave.json") + "' -o a.obj"), 3);
  EXPECT_EQ(read_text(folder_ / "a.obj"), expected);
}

TEST_F(OutputsProgram, TellsHowFarItCameWithoutMemory) {
  // Where memory ends, in kB, depends on the machine: before the triangles, or among them.
  for (int limit = 140000; limit < 200000; limit += 5000) {
    const int status = run(wave_ + "a.obj --hmin 0.05% --hmax 0.05% --threads 1",
                           "ulimit -v " + std::to_string(limit) + ";");
    if (!says(" triangles of it\n")) {
      ASSERT_EQ(status, 1) << err_;
      continue;
    }
    expect_error(status, own_model("wave.json") + ": /patches/0: patch wave: out of memory at ");
    return;
  }
  FAIL() << err_;
}

TEST_F(OutputsProgram, DoesNotOverwriteWhatAModelNames) {
  fs::copy_file(own_model("cube.obj"), folder_ / "cube.obj");
  write_text(folder_ / "sizes.csv", "u,v,size\n0,0,0.2\n");
  write_text(folder_ / "model.json",
             R"({"patches": [{"name": "a", "surface": {"z": "0"}, "domain": {"u": [0, 1],
                 "v": [0, 1]}, "sources": [{"table": "sizes.csv"}]}],
                 "cages": [{"name": "b", "file": "cube.obj"}]})");
  fs::create_symlink("cube.obj", folder_ / "link.obj");
  const std::string kept = " is read for model.json, it is not overwritten";
  expect_error(run("mesh model.json -o cube.obj"), "cube.obj" + kept, 4);
  expect_error(run("mesh model.json -o ./link.obj"), "./link.obj" + kept, 4);
  expect_error(run("mesh model.json -o a.obj --report sizes.csv"), "sizes.csv" + kept, 4);
  expect_error(run("mesh model.json -o a.obj --report cube.obj"), "cube.obj" + kept, 4);
  expect_error(run("control model.json -o cube.obj"), "cube.obj" + kept, 4);
  EXPECT_EQ(read_text(folder_ / "cube.obj"), read_text(own_model("cube.obj")));
  EXPECT_EQ(run("mesh model.json -o a.obj --quiet"), 0) << err_;
}

}  // namespace
}  // namespace surfmesh
