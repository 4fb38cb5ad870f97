// SPDX-License-Identifier: BSD-3-Clause
// Allocations that fail, at places spread over small runs: each is survived or becomes an Error
// that tells of it, and nothing is leaked or left behind.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <new>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "guest/failing_allocator.hh"
#include "support/folders.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/exchange/serial_exchange.hh"
#include "surfmesh/formats/piece_folder.hh"
#include "surfmesh/pipeline/check_mesh.hh"
#include "surfmesh/pipeline/mesh_pieces.hh"
#include "surfmesh/surfmesh.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

using Settings = std::vector<std::pair<std::string, std::string>>;

const std::vector<std::string> kEndings = {"om",  "obj",   "ply", "off", "stl", "vtu", "vtk",
                                           "msh", "meshb", "glb", "inp", "bdf", "mesh"};
const std::vector<std::string> kReadEndings = {"om",  "obj", "ply",  "off",  "stl",
                                               "vtu", "msh", "mesh", "meshb"};

/// What a program may ask of the library, with files in a folder.
struct Work {
  std::string name;
  std::function<void(const fs::path& folder)> run;
  std::function<void(const fs::path& folder)> prepare = [](const fs::path&) {};
  bool has_threads = false;
};

void PrintTo(const Work& work, std::ostream* out) { *out << work.name; }

const fs::path kModels = SURFMESH_SOURCE_DIR "/models";

/// A path, as the program makes it; the library has no part in that.
fs::path path_of(const fs::path& folder, const std::string& name) {
  return tell_out_of_memory([&] { return folder / name; }, [] { return "in the program"; });
}

ModelInput load(const std::string& file, const Settings& settings, int threads = 1) {
  ModelInput input = load_model(path_of(kModels, file));
  for (const auto& [name, value] : settings) set_option(input.options, name, value);
  input.options.threads = threads;
  return input;
}

MeshResult meshed(const std::string& file, const Settings& settings, int threads = 1) {
  const ModelInput input = load(file, settings, threads);
  return mesh_model(input.model, input.sources, input.options);
}

Work mesh_of(const std::string& name, const std::string& file, const Settings& settings,
             int threads = 1) {
  return {name,
          [=](const fs::path& folder) {
            const MeshResult result = meshed(file, settings, threads);
            write_mesh(result, path_of(folder, "mesh.obj"));
            write_file(path_of(folder, "report.json"), to_json(result.report));
          },
          [](const fs::path&) {}, threads != 1};
}

const Settings kSmallCube = {{"hmax", "40%"}, {"normals", "on"}, {"uv", "on"}};

Work all_formats() {
  return {"AllFormats", [](const fs::path& folder) {
            const MeshResult result = meshed("cube.obj", kSmallCube);
            for (const std::string& ending : kEndings)
              write_mesh(result, path_of(folder, "a." + ending));
          }};
}

void prepare_formats(const fs::path& folder) {
  const MeshResult result = meshed("cube.obj", kSmallCube);
  for (const std::string& ending : kReadEndings) write_mesh(result, path_of(folder, "a." + ending));
}

Work readers() {
  return {"Readers",
          [](const fs::path& folder) {
            for (const std::string& ending : kReadEndings)
              read_mesh(path_of(folder, "a." + ending));
          },
          prepare_formats};
}

/// Of one flat patch: surfaces are searched from many samples of each.
const std::string kChecked = "plate.json";
const Settings kNothing;

void check_files(const fs::path& folder) {
  const ModelInput input = load(kChecked, kNothing);
  for (const char* name : {"a.om", "a.obj"}) {
    MeshCheck check = check_mesh(read_mesh_arrays(path_of(folder, name)));
    MeshFile mesh = read_mesh(path_of(folder, name));
    check.stored = measure_stored_metric(mesh.mesh);
    add_fit(check, measure_fit(mesh, input));
    if (to_json(check).empty() || to_text(check).empty()) std::abort();
  }
}

Work checks() {
  return {"Checks",
          [](const fs::path& folder) { with_threads(1, [&folder] { check_files(folder); }); },
          [](const fs::path& folder) {
            const MeshResult result = meshed(kChecked, kNothing);
            for (const char* name : {"a.om", "a.obj"}) write_mesh(result, folder / name);
          }};
}

Work pieces() {
  const Settings settings = {{"tile", "100"}, {"hmax", "5%"}};
  return {"Pieces", [=](const fs::path& folder) {
            const ModelInput input = load("plate.json", settings);
            SerialExchange exchange;
            PieceFolder sink(path_of(folder, "pieces"), exchange);
            const Report report = mesh_pieces(input.model, input.sources, input.options,
                                              {.pieces = 3}, exchange, sink);
            sink.commit(nullptr);
            if (to_json(report).empty()) std::abort();
          }};
}

Work model_of_functions() {
  const auto half = [](double from, double to) {
    return make_callable_surface({from, to, 0, 1}, [](auto u, auto v) {
      return std::array{cos(u), sin(u), v};
    });
  };
  const std::vector<PatchInput> halves = {{"a", half(0, 3)}, {"b", half(3, 6)}};
  return {"ModelOfFunctions", [=](const fs::path& folder) {
            const Model model = model_from_patches(halves);
            PipelineOptions options;
            options.threads = 1;
            options.sizing.hmax = Length::percent(15);
            const MeshResult result = mesh_model(model, {}, options);
            write_mesh(result.mesh, path_of(folder, "a.obj"));
          }};
}

std::vector<Work> works() {
  return {
      all_formats(),
      readers(),
      checks(),
      pieces(),
      model_of_functions(),
      mesh_of("Quads", "plate.json", {{"quads", "on"}, {"hmax", "6%"}}),
      mesh_of("FrontalQuads", "perforated.json",
              {{"quads", "on"}, {"quad_method", "frontal"}, {"hmax", "8%"}}),
      mesh_of("Nurbs", "nurbs_sphere.json", {{"hmax", "15%"}}),
      mesh_of("Tiles", "wave.json", {{"tile", "100"}, {"hmax", "8%"}, {"hmin", "4%"}}),
      mesh_of("Sag", "icosahedron.off", {{"sag", "2%"}}),
      mesh_of("Background", "adapted.json", {{"hmin", "4%"}}),
      mesh_of("Sources", "sizes.json", {{"hmin", "3%"}}),
      mesh_of("ControlMesh", "wave.json", {{"control", "mesh"}, {"nodes", "25"}, {"hmin", "4%"}}),
      mesh_of("JoinedParts", "knob_on_plate.json", {{"hmin", "6%"}, {"hmax", "20%"}}),
      mesh_of("TwoThreads", "wave.json", {{"tile", "200"}, {"hmin", "3%"}}, 2)};
}

/// A number of the environment.
int number_of(const char* variable, int unless_set) {
  const char* text = std::getenv(variable);
  return text == nullptr ? unless_set : std::atoi(text);
}

/// How many allocations fail in each of the works.
int wanted_failures() { return number_of("SURFMESH_ALLOCATION_FAILURES", 20); }

/// The only one that fails, to look at one failure again; 0 for all.
int only_failure() { return number_of("SURFMESH_ALLOCATION_PLACE", 0); }

/// What comes of a run, in words; empty where it is as promised. Kept where no allocation is
/// needed.
std::array<char, 400> words;

void tell(const char* kind, const char* text) {
  std::strncpy(words.data(), kind, words.size() - 1);
  std::strncat(words.data(), text, words.size() - std::strlen(words.data()) - 1);
}

/// Memory that cannot be had is told as such, by the system where a file is opened.
bool tells_of_memory(const Error& error) {
  const bool has_word = std::strstr(error.what(), "memory") != nullptr;
  return has_word && (error.code() == ErrorCode::Limit || error.code() == ErrorCode::Io);
}

void run(const Work& work, const fs::path& folder) {
  words.fill('\0');
  try {
    work.run(folder);
  } catch (const Error& error) {
    if (!tells_of_memory(error)) tell("another error: ", error.what());
  } catch (const std::exception& error) {
    tell("no Error: ", error.what());
  } catch (...) {
    tell("no exception of std", "");
  }
  testing::never_fail();
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

class AllocationFailures : public ::testing::TestWithParam<Work> {
 protected:
  void SetUp() override {
    GetParam().prepare(folder_.path());
    // What is made once for the whole program: tables, the threads of oneTBB.
    for (int i = 0; i < 3; ++i) run(GetParam(), folder_.path());
    ASSERT_STREQ(words.data(), "");
    names_ = names_in(folder_.path());
  }

  /// Run once, and keep what is wrong.
  void run_once(const std::string& place) {
    const long before = testing::count_blocks();
    run(GetParam(), folder_.path());
    const long leaked = testing::count_blocks() - before;
    if (words[0] != '\0') ++faults_[words.data()].first;
    if (words[0] != '\0') faults_[words.data()].second = place;
    // Threads may end their work on a job after it was handed back.
    if (leaked != 0 && !GetParam().has_threads && !leaks_by_itself()) {
      auto& leak = faults_["leaked blocks: " + std::to_string(leaked)];
      ++leak.first;
      leak.second = place;
    }
    if (names_in(folder_.path()) != names_) {
      faults_["files are left"] = {1, place};
      names_ = names_in(folder_.path());
    }
  }

  /// OpenSubdiv leaks what it has allocated where memory runs out while it refines a cage.
  static bool leaks_by_itself() { return testing::was_refused_in("libosdCPU"); }

  void expect_no_faults() const {
    for (const auto& [text, count] : faults_) {
      ADD_FAILURE() << count.first << " times, last " << count.second << ": " << text;
    }
  }

  TestFolder folder_;
  std::set<std::string> names_;
  std::map<std::string, std::pair<int, std::string>> faults_;
};

TEST_P(AllocationFailures, AreErrorsAndLeaveNothing) {
  const long before = testing::count_allocations();
  run(GetParam(), folder_.path());
  const long all = testing::count_allocations() - before;
  const int places = only_failure() > 0 ? 1 : wanted_failures();
  const long blocks = testing::count_blocks(), refusals = testing::count_refusals();
  for (int i = 0; i < places; ++i) {
    const long number =
        only_failure() > 0 ? only_failure() : 1 + i * (all - 1) / std::max(1, places - 1);
    testing::fail_at(number);
    run_once("at " + std::to_string(number) + " of " + std::to_string(all));
  }
  expect_no_faults();
  const long failed = testing::count_refusals() - refusals;
  RecordProperty("allocations", std::to_string(all));
  RecordProperty("failures", std::to_string(failed));
  // Threads make allocations in another number each time.
  EXPECT_GE(failed, GetParam().has_threads ? places / 2 : places - places / 10);
  if (GetParam().has_threads) {
    EXPECT_LT(testing::count_blocks() - blocks, 200);
  }
}

TEST_P(AllocationFailures, AreToldWhereAllMemoryIsUsedUp) {
  const std::size_t before = testing::count_bytes();
  testing::watch_peak();
  run(GetParam(), folder_.path());
  const std::size_t most = testing::peak_bytes() - before;
  // An exception and its text have to go somewhere.
  constexpr std::size_t kLeast = 20'000;
  const int places = std::max(4, wanted_failures() / 4);
  for (int i = 0; i < places; ++i) {
    const std::size_t size =
        kLeast + static_cast<std::size_t>(i) * most / static_cast<std::size_t>(places);
    testing::fail_beyond(size);
    run_once(std::to_string(size) + " of " + std::to_string(most) + " bytes");
  }
  expect_no_faults();
}

INSTANTIATE_TEST_SUITE_P(Runs, AllocationFailures, ::testing::ValuesIn(works()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh
