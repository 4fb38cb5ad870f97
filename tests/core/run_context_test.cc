// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/run_context.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/errors.hh"

namespace surfmesh {
namespace {

class Recorder : public Observer {
 public:
  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    told.push_back(std::string(stage) + " " + std::to_string(done) + "/" + std::to_string(total));
  }
  void at_work(std::size_t elements, int pass) override {
    told.push_back(std::to_string(elements) + " of pass " + std::to_string(pass));
  }
  bool is_cancelled() override { return cancels; }

  std::vector<std::string> told;
  bool cancels = false;
};

TEST(RunContext, PassesProgressOn) {
  Recorder recorder;
  const RunContext context(&recorder);
  context.tell("mesh", 1, 3);
  EXPECT_EQ(recorder.told, (std::vector<std::string>{"mesh 1/3", "0 of pass 0"}));
}

TEST(RunContext, TellsElementsWithThoseOfUnfinishedPatchesNowAndThen) {
  Recorder recorder;
  const RunContext context(&recorder);
  context.begin_mesh();
  context.add_elements(10);
  context.change_unfinished(5);
  for (int i = 0; i < 100; ++i) context.throw_if_cancelled();
  ASSERT_FALSE(recorder.told.empty());
  EXPECT_EQ(recorder.told.front(), "15 of pass 1");
  EXPECT_LT(recorder.told.size(), 100U);
}

TEST(RunContext, IsNeverCancelledWithoutAnObserver) {
  const RunContext context;
  context.tell("mesh", 0, 1);
  context.throw_if_cancelled();
  EXPECT_FALSE(context.was_cancelled());
}

TEST(RunContext, StaysCancelled) {
  Recorder recorder;
  const RunContext context(&recorder);
  recorder.cancels = true;
  EXPECT_EQ(error_of([&] { context.throw_if_cancelled(); }), "cancelled: the run was cancelled");
  recorder.cancels = false;
  EXPECT_TRUE(context.was_cancelled());
  EXPECT_EQ(error_of([&] { context.tell("mesh", 1, 1); }), "cancelled: the run was cancelled");
}

TEST(RunContext, CountsTheElementsThatAreLeft) {
  const RunContext context(nullptr, 10);
  EXPECT_EQ(context.elements_left(), 10U);
  context.add_elements(7);
  EXPECT_EQ(context.elements_left(), 3U);
  context.add_elements(3);  // exactly as many as allowed
  EXPECT_EQ(error_of([&] { context.elements_left(); }),
            "limit: more than max_elements = 10 triangles");
  EXPECT_EQ(error_of([&] { context.add_elements(1); }),
            "limit: more than max_elements = 10 triangles");
}

TEST(RunContext, AllowsEachMeshAllElements) {
  const RunContext context(nullptr, 10);
  context.add_elements(10);
  context.begin_mesh();
  EXPECT_EQ(context.elements_left(), 10U);
}

}  // namespace
}  // namespace surfmesh
