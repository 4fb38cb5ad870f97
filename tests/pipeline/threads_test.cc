// SPDX-License-Identifier: BSD-3-Clause
#include "cage/cages.hh"

// After cages, for Scheme::Loop of a later header would shadow the Loop of a model.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/models.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/pipeline/load_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

constexpr int kThreadCounts[] = {2, 8};

struct ThreadsCase {
  std::string name;
  std::string file;  ///< in the folder of models
  std::vector<std::pair<std::string, std::string>> settings;
};

void PrintTo(const ThreadsCase& example, std::ostream* out) { *out << example.name; }

/// The file of the mesh, and the report without clocks and the number of threads.
std::string output_of(const ThreadsCase& example, int threads) {
  const TestFolder folder;
  const std::string path = folder / "mesh.om";
  ModelInput input = load_model(std::string(SURFMESH_SOURCE_DIR "/models/") + example.file, {});
  for (const auto& [name, value] : example.settings) set_option(input.options, name, value);
  input.options.threads = threads;
  MeshResult result = mesh_model(input.model, input.sources, input.options);
  write_mesh(result.mesh, path);
  result.report.seconds = {};
  result.report.serial_seconds = 0;
  result.report.wall_seconds = 0;
  result.report.options.threads = 0;
  return read_text(path) + to_json(result.report);
}

class Threads : public ::testing::TestWithParam<ThreadsCase> {};

TEST_P(Threads, MakeTheSameFileInAnyNumber) {
  const std::string alone = output_of(GetParam(), 1);
  for (const int threads : kThreadCounts) {
    EXPECT_TRUE(output_of(GetParam(), threads) == alone) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Threads,
                         ::testing::ValuesIn(std::vector<ThreadsCase>{
                             {"BlocksOfACage", "knob.obj", {{"hmax", "3%"}}},
                             {"FacesOfACage", "torus.obj", {{"patches", "faces"}}},
                             {"CageWithinASag", "vault.obj", {{"sag", "0.2%"}}},
                             {"TrimmedPatches", "perforated.json", {}},
                             {"PartsThatJoin", "knob_on_plate.json", {}},
                             {"SourcesOfSizes", "sizes.json", {}},
                             {"Grids", "pipes.json", {{"control", "grid"}}}}),
                         [](const auto& test) { return test.param.name; });

/// A square at a place of a row.
testing::Shape flat_square(int place) {
  return make_callable_surface({0, 1, 0, 1}, [place](auto u, auto v) {
    return std::array{u + 2.0 * place, v, 0 * u};
  });
}

/// The same, but not a number in a disc within it.
testing::Shape bad_square(int place) {
  return make_callable_surface({0, 1, 0, 1}, [place](auto u, auto v) {
    const auto x = u - 0.5, y = v - 0.5;
    return std::array{u + 2.0 * place, v, 0 * sqrt(x * x + y * y - 0.04)};
  });
}

TEST(ThreadsError, IsThatOfTheFirstPatchThatHasOne) {
  std::vector<testing::Shape> squares;
  for (int i = 0; i < 12; ++i) squares.push_back(flat_square(i));
  Model model = testing::model_of(squares);
  for (int i = 3; i < 12; ++i) model.patches[static_cast<std::size_t>(i)].surface = bad_square(i);
  for (const int threads : {1, 2, 8}) {
    PipelineOptions options;
    options.threads = threads;
    const std::string error = error_of([&] { mesh_model(model, {}, options); });
    EXPECT_EQ(error.substr(0, 19), "geometry: patch p3:") << error;
  }
}

TEST(ThreadsError, IsTheLimitOnlyIfAllPatchesTogetherHaveTooManyElements) {
  const Model model = testing::torus_of(6);
  PipelineOptions options;
  options.across.is_on = false;  // it may collapse elements that were counted
  const std::size_t count = mesh_model(model, {}, options).mesh.n_faces();
  for (const int threads : {1, 2, 8}) {
    options.threads = threads;
    options.max_elements = count;
    EXPECT_EQ(mesh_model(model, {}, options).mesh.n_faces(), count);
    options.max_elements = count - 1;
    EXPECT_EQ(error_of([&] { mesh_model(model, {}, options); }).substr(0, 6), "limit:");
  }
}

TEST(ThreadsError, IsABadOptionWhereThereAreTooMany) {
  for (const int threads : {-1, 1000}) {
    PipelineOptions options;
    options.threads = threads;
    const std::string error = error_of([&] { mesh_model(testing::torus_of(2), {}, options); });
    EXPECT_EQ(error.substr(0, 15), "invalid option:") << error;
  }
}

/// Expects that it is called by one thread at a time, and that patches are counted upwards.
class Watch : public Observer {
 public:
  explicit Watch(int questions = -1) : questions_left_(questions) {}

  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    EXPECT_EQ(inside_++, 0);
    EXPECT_LE(done, total);
    if (stage == "mesh") {
      EXPECT_EQ(done, expected_++);
    }
    --inside_;
  }

  bool is_cancelled() override {
    EXPECT_EQ(inside_++, 0);
    --inside_;
    return questions_left_ >= 0 && questions_left_-- == 0;
  }

 private:
  std::atomic<int> inside_ = 0;
  int questions_left_;
  std::size_t expected_ = 0;
};

TEST(ThreadsObserver, IsCalledByOneAtATime) {
  Watch watch;
  PipelineOptions options;
  options.threads = 8;
  mesh_model(testing::torus_of(6), {}, options, &watch);
}

TEST(ThreadsObserver, CancelsByAnAnswerToAnyThread) {
  for (const int threads : {1, 2, 8}) {
    for (const int questions : {0, 3, 8, 11, 14, 17, 20}) {
      Watch watch(questions);
      PipelineOptions options;
      options.threads = threads;
      EXPECT_EQ(error_of([&] { mesh_model(testing::torus_of(6), {}, options, &watch); }),
                "cancelled: the run was cancelled")
          << threads << " threads, question " << questions;
    }
  }
}

TEST(ThreadsReport, HasTheClocksOfAllThreads) {
  PipelineOptions options;
  options.threads = 4;
  const auto seconds = mesh_model(testing::torus_of(6), {}, options).report.seconds;
  for (const Stage stage : {Stage::Control, Stage::Boundary, Stage::Triangulate, Stage::Refine,
                            Stage::Improve, Stage::Assemble}) {
    EXPECT_GT(seconds[stage], 0) << name(stage);
  }
}

}  // namespace
}  // namespace surfmesh
