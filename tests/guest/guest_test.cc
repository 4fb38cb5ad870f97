// SPDX-License-Identifier: BSD-3-Clause
// The library in somebody else's program: it leaves alone what belongs to all of that.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/surfmesh.hh"

extern char** environ;

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

struct Job {
  std::string model;
  std::vector<std::pair<std::string, std::string>> settings;
};

const std::vector<Job>& jobs() {
  static const std::vector<Job> all = {
      {"knob.obj", {{"hmax", "6%"}}},         {"wave.json", {{"hmin", "2%"}, {"tile", "500"}}},
      {"perforated.json", {{"quads", "on"}}}, {"nurbs_sphere.json", {{"sag", "1%"}}},
      {"sizes.json", {{"control", "grid"}}},  {"icosahedron.off", {{"surface", "interpolate"}}}};
  return all;
}

/// The mesh of a job as the bytes of a file in a folder.
std::string bytes_of(const Job& job, const fs::path& folder, int threads) {
  LoadOptions options;
  PipelineOptions given;
  for (const auto& [name, value] : job.settings) set_option(given, name, value);
  options.cages.surface = given.surface;
  ModelInput input = load_model(std::string(SURFMESH_SOURCE_DIR "/models/") + job.model, options);
  for (const auto& [name, value] : job.settings) set_option(input.options, name, value);
  input.options.threads = threads;
  write_mesh(mesh_model(input.model, input.sources, input.options), folder / "mesh.om");
  return read_text(folder / "mesh.om");
}

TEST(Guest, MeshesTheSameAfterAnythingElse) {
  const TestFolder folder;
  std::vector<std::string> first;
  for (const Job& job : jobs()) first.push_back(bytes_of(job, folder.path(), 1));
  for (std::size_t i = jobs().size(); i-- > 0;) {
    EXPECT_TRUE(bytes_of(jobs()[i], folder.path(), 2) == first[i]) << jobs()[i].model;
  }
}

TEST(Guest, MeshesTwoModelsAtOnce) {
  const TestFolder folder;
  std::vector<std::string> alone;
  for (const Job& job : jobs()) alone.push_back(bytes_of(job, folder.path(), 1));
  for (const int threads : {1, 3}) {
    for (std::size_t i = 0; i < jobs().size(); ++i) {
      std::array<std::string, 2> together;
      std::vector<std::thread> guests;
      for (std::size_t k = 0; k < 2; ++k) {
        guests.emplace_back([&, k] {
          const fs::path own = folder / ("own" + std::to_string(k));
          fs::create_directories(own);
          together[k] = bytes_of(jobs()[(i + k) % jobs().size()], own, threads);
        });
      }
      for (std::thread& guest : guests) guest.join();
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_TRUE(together[k] == alone[(i + k) % jobs().size()]) << i << ", " << k;
      }
    }
  }
}

/// Use much of the library, and have it fail where it may.
void visit(const fs::path& folder) {
  for (const Job& job : jobs()) bytes_of(job, folder, 2);
  const MeshFile mesh = read_mesh(folder / "mesh.om");
  for (const std::string ending : {"om", "obj", "ply", "off", "stl", "vtu", "msh", "mesh"}) {
    const fs::path path = folder / ("a." + ending);
    write_mesh(mesh.mesh, path, mesh.names);
    EXPECT_FALSE(to_text(check_mesh(read_mesh_arrays(path))).empty());
    const std::string text = read_text(path);
    const fs::path damaged = folder / ("b." + ending);
    write_text(damaged, text.substr(0, text.size() / 2));
    EXPECT_NE(error_of([&] { read_mesh(damaged); }), "no error") << ending;
    std::string changed = text;
    for (std::size_t i = 7; i < changed.size(); i += 101) changed[i] ^= '\x15';
    write_text(damaged, changed);
    error_of([&] { read_mesh(damaged); });
    EXPECT_NE(error_of([&] { write_mesh(mesh.mesh, "/dev/full/a." + ending); }), "no error");
  }
  EXPECT_NE(error_of([&] { load_model(folder / "none.obj"); }), "no error");
  write_text(folder / "bad.json",
             "{\"patches\": [{\"name\": \"a\", \"surface\": {\"z\": \"1/(u-0.5)\"}, "
             "\"domain\": {\"u\": [0, 1], \"v\": [0, 1]}}]}");
  EXPECT_NE(error_of([&] {
              const ModelInput input = load_model(folder / "bad.json");
              mesh_model(input.model, input.sources, input.options);
            }),
            "no error");
}

/// Where the standard output and error lead while this lives.
class Redirected {
 public:
  explicit Redirected(const fs::path& file) {
    const int target = open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      kept_[i] = dup(static_cast<int>(i) + 1);
      dup2(target, static_cast<int>(i) + 1);
    }
    close(target);
  }
  ~Redirected() {
    std::fflush(nullptr);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      dup2(kept_[i], static_cast<int>(i) + 1);
      close(kept_[i]);
    }
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  std::array<int, 2> kept_ = {};
};

TEST(Guest, PrintsNothing) {
  const TestFolder folder;
  {
    const Redirected redirected(folder / "printed");
    visit(folder.path());
  }
  EXPECT_EQ(read_text(folder / "printed"), "");
}

/// What belongs to the whole program, as text.
std::string house() {
  std::string text = fs::current_path().string() + '\n' + std::setlocale(LC_ALL, nullptr) + '\n';
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    std::uintptr_t handler = 0;
    static_assert(sizeof handler == sizeof action.sa_handler);
    std::memcpy(&handler, &action.sa_handler, sizeof handler);
    text += std::to_string(handler) + ' ';
  }
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  for (int number = 1; number < NSIG; ++number)
    text += std::to_string(sigismember(&blocked, number));
  const mode_t mask = umask(0);
  umask(mask);
  text += '\n' + std::to_string(mask) + ' ' + std::to_string(std::fegetround()) + ' ' +
          std::to_string(fegetexcept()) + '\n';
  for (char** variable = environ; *variable != nullptr; ++variable) {
    text.append(*variable).push_back('\n');
  }
  return text;
}

/// Descriptors that are open.
std::size_t count_open_files() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

TEST(Guest, LeavesTheHouseAsItWas) {
  const TestFolder folder;
  visit(folder.path());  // oneTBB may open files of the system, once
  const std::string before = house();
  const std::size_t files = count_open_files();
  visit(folder.path());
  EXPECT_EQ(house(), before);
  EXPECT_EQ(count_open_files(), files);
}

}  // namespace
}  // namespace surfmesh
