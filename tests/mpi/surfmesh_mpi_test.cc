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
#include "surfmesh/core/version.hh"
#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

using Milliseconds = std::chrono::milliseconds;

const std::string kPython = "/usr/bin/python3";
constexpr const char* kNoVtk = "no VTK here; tools/setup.sh --readers installs it";

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

  bool has_vtk() { return shell(kPython + " -c 'import vtkmodules.vtkIOXML, numpy'") == 0; }

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

/// Compares the cells of a.vtu with those of all pieces in mesh/, by the positions of their
/// corners.
constexpr const char* kCompareByVtk = R"(
from collections import Counter
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
from vtkmodules.util.numpy_support import vtk_to_numpy

def cells(reader, name):
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    patches = vtk_to_numpy(grid.GetCellData().GetArray("patch"))
    return Counter((patch, points[corners[begin:end]].tobytes())
                   for patch, begin, end in zip(patches, offsets, offsets[1:]))

whole = cells(vtkXMLUnstructuredGridReader(), "a.vtu")
together = cells(vtkXMLPUnstructuredGridReader(), "mesh/mesh.pvtu")
print(sum(whole.values()), "cells,", "equal" if whole == together else "different")
)";

TEST_F(MpiProgram, WritesPiecesThatVtkReadsAsTheMeshOfOneProcess) {
  if (!has_vtk()) GTEST_SKIP() << kNoVtk;
  write_text(folder_ / "compare.py", kCompareByVtk);
  for (const std::string more : {"", " --quads on"}) {
    const std::string arguments =
        "mesh '" + own_model("knob.obj") + "' --hmax 2% --tile 1000" + more;
    ASSERT_EQ(run(arguments + " --across off -o a.vtu"), 0) << err_;
    ASSERT_EQ(run_ranks(3, arguments + " --pieces mesh --piece-count 5"), 0) << err_;
    EXPECT_EQ(shell(kPython + " compare.py"), 0) << err_;
    EXPECT_TRUE(out_.ends_with(" cells, equal\n")) << out_;
    EXPECT_GT(std::stoi(out_), 1000);
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

TEST_F(MpiProgram, EstimatesHowPiecesAreDealtOutInADryRun) {
  const std::string dry = "mesh '" + own_model("cube.obj") + "' --dry-run --deal runs ";
  EXPECT_EQ(run_ranks(3, dry + "--piece-count 2"), 0) << err_;
  EXPECT_TRUE(says("pieces    2 on 3 ranks; ")) << out_;
  EXPECT_EQ(run_ranks(3, dry + "--piece-count 2 --ranks 4"), 0) << err_;
  EXPECT_TRUE(says("pieces    2 on 4 ranks; ")) << out_;
}

TEST_F(MpiProgram, SaysWhatItCanWriteAndWithWhatItRuns) {
  EXPECT_EQ(run_ranks(1, "mesh --help"), 0) << err_;
  EXPECT_NE(out_.find("of all pieces: .obj .ply"), std::string::npos) << out_;
  EXPECT_EQ(out_.find(".om keeps everything"), std::string::npos) << out_;
  EXPECT_NE(out_.find("  mpirun -n 4 surfmesh-mpi mesh "), std::string::npos) << out_;
  for (const char* flag : {"  --pieces FOLDER", "  --tile "}) {
    EXPECT_NE(out_.find(flag), std::string::npos) << flag << out_;
  }
  EXPECT_EQ(run_ranks(2, "--version"), 0) << err_;
  EXPECT_TRUE(out_.starts_with("surfmesh " SURFMESH_VERSION " with ")) << out_;
  EXPECT_EQ(out_.find('\n'), out_.size() - 1) << "printed twice: " << out_;
}

TEST_F(MpiProgram, WarnsOfElementsThatWereToCrossContours) {
  const std::string line = "mesh '" + own_model("cube.obj") + "' --pieces mesh --quiet";
  EXPECT_EQ(run_ranks(2, line), 0) << err_;
  EXPECT_EQ(err_, "");
  EXPECT_EQ(run_ranks(2, line + " --set across=on"), 0) << err_;
  EXPECT_EQ(err_, "surfmesh: warning: across = on of the command line has no effect in pieces\n");
}

TEST_F(MpiProgram, PrintsNoSignsOfATerminalThatIsNotThere) {
  setenv("LC_ALL", "C.UTF-8", 1);
  EXPECT_EQ(run_ranks(2, "mesh '" + own_model("cube.obj") + "' -o a.obj --hmax 5%"), 0) << err_;
  unsetenv("LC_ALL");
  for (const char c : out_ + err_) EXPECT_GE(c, 0) << out_ << err_;
}

TEST_F(MpiProgram, IsNamedWhereRanksRunTheOtherOne) {
  const std::string line = "'" SURFMESH_PROGRAM "' mesh '" + own_model("cube.obj") + "' --dry-run";
  EXPECT_EQ(shell("'" SURFMESH_MPIEXEC "' -n 3 " + line), 0) << err_;
  const std::string text = "warning: mpirun has started 3 processes";
  const std::size_t at = err_.find(text);
  EXPECT_NE(at, std::string::npos) << err_;
  EXPECT_EQ(err_.find(text, at + 1), std::string::npos) << err_;
  EXPECT_EQ(shell(line), 0) << err_;
  EXPECT_EQ(err_.find("mpirun"), std::string::npos) << err_;
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
      {cube + "-o a.obj --normals", 1, "leave out --normals, --uv and --texture"},
      {cube + "-o a.obj --piece-count 2", 2, "--piece-count requires --pieces"},
      {cube + "-o a.obj --ranks 2", 2, "--ranks requires --dry-run"},
      {cube + "-o none/a.obj", 1, "there is no folder none"},
      {cube + "--pieces mesh --max-elements 10", 1, "max_elements"},
      {cube + "--pieces mesh.vtu", 1, "mesh.vtu: --pieces takes the name of a folder"},
      {cube + "--pieces none/mesh", 1, "error: cannot write none/mesh: there is no folder"},
      {cube + "--pieces mesh --across off", 2, "there is no option --across"},
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

  /// Nameless files in which ranks keep what belongs into a file of all.
  int count_spools() const {
    int count = 0;
    for (const pid_t rank : ranks()) {
      std::error_code ignored;
      for (const auto& open :
           fs::directory_iterator("/proc/" + std::to_string(rank) + "/fd", ignored)) {
        const std::string target = fs::read_symlink(open.path(), ignored).string();
        const bool is_spool = target.find(".surfmesh-spool-") != std::string::npos;
        if (is_spool && target.ends_with(" (deleted)")) ++count;
      }
    }
    return count;
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

class EndedRanks : public MpiProgram {
 protected:
  /// Ranks stand still as soon as the run is under way. One of them gets a signal, then all go on.
  /// Returns  false if the signal came when all was done but to put it in place
  template <class IsUnderWay>
  bool end_rank(const RunningRanks& running, std::size_t rank, int number,
                IsUnderWay is_under_way) {
    while (!is_under_way() && !running.has_ended()) std::this_thread::sleep_for(Milliseconds(1));
    running.signal_ranks(SIGSTOP);
    const bool is_in_time = is_under_way();
    running.signal_rank(rank, number);
    running.signal_ranks(SIGCONT);
    const int status = running.wait();
    const std::string log = read_text(folder_ / "log");
    fs::remove(folder_ / "log");
    EXPECT_TRUE(!is_in_time || status == 0 || status == 128 + number) << status << '\n' << log;
    return is_in_time && status != 0;
  }

  /// Runs until a signal comes in time.
  static constexpr int kMostRuns = 10;
};

TEST_F(EndedRanks, LeaveNoPiecesAndKeepAnOlderOutput) {
  const std::string wave =
      "mesh '" + own_model("wave.json") + "' --threads 1 --pieces mesh --hmax ";
  const auto is_under_way = [this] { return has_piece(folder_.path()); };
  for (const int number : {SIGKILL, SIGTERM}) {
    bool has_ended = false;
    for (int i = 0; i < kMostRuns && !has_ended; ++i) {
      ASSERT_EQ(run_ranks(2, wave + "3%"), 0) << err_;
      const std::string older = read_text(folder_ / "mesh/mesh_0000.vtu");
      const RunningRanks running(
          folder_.path(), command(3, wave + "0.3% --hmin 0.3% --piece-count 30 --tile 5000"));
      has_ended = end_rank(running, 1, number, is_under_way);
      EXPECT_EQ(files(), std::set<std::string>{"mesh"}) << number;
      EXPECT_EQ(read_text(folder_ / "mesh/mesh_0000.vtu") == older, has_ended);
    }
    EXPECT_TRUE(has_ended) << number;
  }
}

/// Here the first rank ends: it is the one that made the temporary file of all.
TEST_F(EndedRanks, LeaveNothingOfASingleFileAndKeepAnOlderOne) {
  const std::string wave =
      "mesh '" + own_model("wave.json") + "' --threads 1 --tile 5000 -o mesh.obj --hmax ";
  for (const int number : {SIGKILL, SIGTERM}) {
    bool has_ended = false;
    for (int i = 0; i < kMostRuns && !has_ended; ++i) {
      ASSERT_EQ(run_ranks(2, wave + "3%"), 0) << err_;
      const std::string older = read_text(folder_ / "mesh.obj");
      const RunningRanks running(folder_.path(), command(3, wave + "0.3% --hmin 0.3%"));
      const auto is_under_way = [&] {
        return fs::exists(folder_ / ".surfmesh-0.tmp") && running.count_spools() == 6;
      };
      has_ended = end_rank(running, 0, number, is_under_way);
      EXPECT_EQ(files(), std::set<std::string>{"mesh.obj"}) << number;
      EXPECT_EQ(read_text(folder_ / "mesh.obj") == older, has_ended);
    }
    EXPECT_TRUE(has_ended) << number;
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
  if (!has_vtk()) GTEST_SKIP() << kNoVtk;
  const std::string begin = "```python\n";
  const std::size_t at = document.find(begin) + begin.size();
  write_text(folder_ / "read.py", document.substr(at, document.find("```", at) - at));
  EXPECT_EQ(shell(kPython + " read.py"), 0) << err_;
  EXPECT_NE(out_.find("vertices shared with piece 3"), std::string::npos) << out_;
}

}  // namespace
}  // namespace surfmesh
