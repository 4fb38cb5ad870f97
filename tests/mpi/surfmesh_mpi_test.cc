// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>
#include <tuple>
#include <vector>

#include "support/program.hh"
#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

using Milliseconds = std::chrono::milliseconds;

/// Runs the program as several ranks.
class MpiProgram : public Program {
 protected:
  /// Open MPI refuses root, and more ranks than cores, unless it is told.
  static void SetUpTestSuite() {
    for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe"}) {
      setenv(name, "1", 1);
    }
  }

  static std::string command(int ranks, const std::string& arguments) {
    return "'" SURFMESH_MPIEXEC "' -n " + std::to_string(ranks) + " '" SURFMESH_MPI_PROGRAM "' " +
           arguments;
  }

  int run_ranks(int ranks, const std::string& arguments) {
    return shell(command(ranks, arguments));
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
};

TEST_F(MpiProgram, WritesTheBytesOfOneProcessOnAnyNumberOfRanks) {
  for (const std::string file : {"a.obj", "a.ply"}) {
    const std::string arguments =
        "mesh '" + own_model("bracket.json") + "' --hmax 3% --tile 1000 -o " + file;
    EXPECT_EQ(run(arguments + " --across off"), 0) << err_;
    const std::string whole = read_text(folder_ / file);
    for (const int ranks : {1, 2, 3, 4}) {
      fs::remove(folder_ / file);
      EXPECT_EQ(run_ranks(ranks, arguments), 0) << err_;
      EXPECT_TRUE(read_text(folder_ / file) == whole) << file << ", ranks " << ranks;
    }
  }
}

/// The faces of a mesh as positions of their corners.
std::multiset<std::vector<double>> faces_of(const GridFile& grid) {
  std::multiset<std::vector<double>> faces;
  for (std::size_t f = 0; f < grid.faces.size(); ++f) {
    std::vector<double> corners = {static_cast<double>(grid.patches[f])};
    for (const int v : grid.faces[f]) {
      for (const double x : grid.points[static_cast<std::size_t>(v)]) corners.push_back(x);
    }
    faces.insert(corners);
  }
  return faces;
}

TEST_F(MpiProgram, WritesPiecesThatTogetherAreTheMeshOfOneProcess) {
  const std::string arguments = "mesh '" + own_model("knob.obj") + "' --hmax 3% --tile 1000 ";
  EXPECT_EQ(run(arguments + "--across off -o a.vtu"), 0) << err_;
  const auto whole = faces_of(read_grid(folder_ / "a.vtu"));
  for (const std::string more : {"", " --piece-count 7"}) {
    EXPECT_EQ(run_ranks(3, arguments + "--pieces mesh" + more), 0) << err_;
    std::multiset<std::vector<double>> together;
    for (const auto& entry : fs::directory_iterator(folder_ / "mesh")) {
      if (entry.path().extension() == ".vtu") together.merge(faces_of(read_grid(entry.path())));
    }
    EXPECT_EQ(together, whole) << more;
  }
}

TEST_F(MpiProgram, PrintsOnceAndWritesOneReport) {
  EXPECT_EQ(run_ranks(3, "mesh '" + own_model("cube.obj") + "' --pieces mesh --report r.json"), 0);
  EXPECT_EQ(files(), (std::set<std::string>{"mesh", "r.json"}));
  std::size_t count = 0;
  for (std::size_t at = 0; (at = out_.find("triangles, ", at)) != std::string::npos; ++at) ++count;
  EXPECT_EQ(count, 1u) << out_;
  EXPECT_NE(out_.find("pieces    3 on 3 ranks; "), std::string::npos) << out_;
}

TEST_F(MpiProgram, EstimatesForItsRanksInADryRun) {
  EXPECT_EQ(run_ranks(3, "mesh '" + own_model("cube.obj") + "' --dry-run"), 0) << err_;
  const std::string line = "pieces    3 on 3 ranks; ";
  const std::size_t at = out_.find(line);
  EXPECT_NE(at, std::string::npos) << out_;
  EXPECT_EQ(out_.find(line, at + 1), std::string::npos) << "told twice: " << out_;
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(MpiProgram, HasCompletionsAndManualPages) {
  EXPECT_EQ(run_ranks(2, "completion bash"), 0) << err_;
  write_text(folder_ / "completion", out_);
  EXPECT_EQ(shell("bash -n completion"), 0) << err_;
  write_text(folder_ / "ask",
             "source ./completion\nCOMP_WORDS=(surfmesh-mpi mesh --piece-c)\nCOMP_CWORD=2\n"
             "_surfmesh-mpi\necho \"${COMPREPLY[@]}\"\n");
  EXPECT_EQ(shell("bash ask"), 0) << err_;
  EXPECT_NE(out_.find("--piece-count"), std::string::npos) << out_ << err_;
  EXPECT_EQ(run_ranks(2, "man mesh"), 0) << err_;
  EXPECT_NE(out_.find(".TH SURFMESH\\-MPI\\-MESH 1"), std::string::npos) << out_.substr(0, 200);
  EXPECT_EQ(out_.find(".TH", out_.find(".TH") + 1), std::string::npos) << "printed twice";
}

TEST_F(MpiProgram, TellsOnceOfAnErrorAndLeavesNothing) {
  const std::string cube = "mesh '" + own_model("cube.obj") + "' ";
  const std::vector<std::tuple<std::string, int, std::string>> cases = {
      {"mesh none.obj -o a.obj", 1, "cannot read none.obj"},
      {cube, 2, "--output is required\nsurfmesh-mpi mesh --help tells more"},
      {cube + "-o a.stl", 1, "ranks can write .obj and .ply"},
      {cube + "-o a.obj --normals", 1, "normals, uv and texture have no place"},
      {cube + "-o none/a.obj", 1, "there is no folder none"},
      {cube + "--pieces mesh --max-elements 10", 1, "max_elements"},
  };
  for (const auto& [arguments, status, text] : cases) {
    EXPECT_EQ(run_ranks(3, arguments), status) << arguments;
    const std::size_t at = err_.find(text);
    EXPECT_NE(at, std::string::npos) << arguments << '\n' << err_;
    EXPECT_EQ(err_.find(text, at + 1), std::string::npos) << err_;
    EXPECT_EQ(folder_.count(), 0) << arguments;
  }
}

/// mpirun with its ranks, which may be stopped and killed one by one.
class RunningRanks {
 public:
  RunningRanks(const fs::path& folder, const std::string& line) : process_(fork()) {
    if (process_ != 0) return;
    const std::string text = "cd '" + folder.string() + "' && exec " + line + " >log 2>&1";
    execl("/bin/sh", "sh", "-c", text.c_str(), nullptr);
    _exit(127);
  }

  /// Returns the exit status.
  int wait() const {
    int status = 0;
    waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  bool has_ended() const {
    siginfo_t info = {};
    constexpr int kPeek = WEXITED | WNOHANG | WNOWAIT;
    return waitid(P_PID, static_cast<id_t>(process_), &info, kPeek) == 0 && info.si_pid != 0;
  }

  void signal_ranks(int number) const {
    for (const pid_t rank : ranks()) kill(rank, number);
  }

  void signal_rank(std::size_t rank, int number) const {
    const std::vector<pid_t> all = ranks();
    if (rank < all.size()) kill(all[rank], number);
  }

 private:
  std::vector<pid_t> ranks() const {
    const std::string task = "/proc/" + std::to_string(process_) + "/task";
    std::vector<pid_t> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(task, ignored)) {
      std::ifstream children(entry.path() / "children");
      for (pid_t child; children >> child;) found.push_back(child);
    }
    return found;
  }

  pid_t process_;
};

/// True if the temporary folder has a piece.
bool has_piece(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / ".surfmesh-0.tmp/mesh_0000.vtu", ignored);
}

/// Ranks stand still where some pieces are written. One of them gets a signal, then all go on.
TEST_F(MpiProgram, LeavesNothingAndKeepsAnOlderOutputWhereARankEnds) {
  const std::string wave =
      "mesh '" + own_model("wave.json") + "' --threads 1 --pieces mesh --hmax ";
  ASSERT_EQ(run_ranks(2, wave + "3%"), 0) << err_;
  const std::string older = read_text(folder_ / "mesh/mesh_0000.vtu");
  for (const int number : {SIGKILL, SIGTERM}) {
    const RunningRanks running(folder_.path(),
                               command(3, wave + "0.3% --hmin 0.3% --piece-count 30 --tile 5000"));
    while (!has_piece(folder_.path()) && !running.has_ended()) {
      std::this_thread::sleep_for(Milliseconds(1));
    }
    running.signal_ranks(SIGSTOP);
    EXPECT_TRUE(has_piece(folder_.path())) << "the run was over too soon";
    running.signal_rank(1, number);
    running.signal_ranks(SIGCONT);
    EXPECT_EQ(running.wait(), 128 + number) << read_text(folder_ / "log");
    fs::remove(folder_ / "log");
    EXPECT_EQ(files(), std::set<std::string>{"mesh"}) << number;
    EXPECT_EQ(read_text(folder_ / "mesh/mesh_0000.vtu"), older);
  }
}

/// The lines of the document that start ranks, and its program in Python.
TEST_F(MpiProgram, WorksAsItsDocumentShows) {
  fs::create_directory_symlink(fs::path(SURFMESH_SOURCE_DIR) / "models", folder_ / "models");
  const std::string document = read_text(fs::path(SURFMESH_SOURCE_DIR) / "libsurfmesh/CLUSTER.md");
  std::istringstream text(document);
  int count = 0;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("mpirun -n ")) continue;
    line = line.substr(std::string("mpirun").size(), line.find('#') - std::string("mpirun").size());
    const std::size_t at = line.find("surfmesh-mpi");
    line.replace(at, std::string("surfmesh-mpi").size(), "'" SURFMESH_MPI_PROGRAM "'");
#ifndef SURFMESH_HAS_METIS
    if (line.find("metis") != line.npos) continue;
#endif
    EXPECT_EQ(shell("'" SURFMESH_MPIEXEC "'" + line), 0) << line << '\n' << err_;
    ++count;
  }
  EXPECT_GE(count, 2);
  const std::string python = "/usr/bin/python3";
  if (shell(python + " -c 'import vtkmodules.vtkIOXML, numpy'") != 0) {
    GTEST_SKIP() << "no VTK here; tools/setup.sh --readers installs it";
  }
  const std::string begin = "```python\n";
  const std::size_t at = document.find(begin) + begin.size();
  write_text(folder_ / "read.py", document.substr(at, document.find("```", at) - at));
  EXPECT_EQ(shell(python + " read.py"), 0) << err_;
  EXPECT_NE(out_.find("vertices shared with piece 3"), std::string::npos) << out_;
}

}  // namespace
}  // namespace surfmesh
