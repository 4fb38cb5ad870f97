// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cad/meshed.hh"

namespace surfmesh {
namespace {

struct SharedFile {
  std::string name;
  std::size_t patches = 0;
};

void PrintTo(const SharedFile& file, std::ostream* out) { *out << file.name; }

class SharedCadFiles : public ::testing::TestWithParam<SharedFile> {};

TEST_P(SharedCadFiles, AreMeshedClosed) {
  const auto path =
      std::filesystem::path(SURFMESH_SHARED_DIR) / "cases/cad" / (GetParam().name + ".step");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Model model = read_cad(path);
  check(model);
  EXPECT_EQ(model.patches.size(), GetParam().patches);
  const MeshResult result = mesh_model(model, {}, {});
  EXPECT_TRUE(testing::is_closed(result.mesh));
  EXPECT_LE(testing::corner_distance(model, result.mesh), testing::allowed_distance(model));
  EXPECT_FALSE(testing::has(result.report.notices, NoticeKind::TurnedTriangles));
  EXPECT_FALSE(testing::has(result.report.notices, NoticeKind::BrokenPromise));
}

INSTANTIATE_TEST_SUITE_P(All, SharedCadFiles,
                         ::testing::Values(SharedFile{"box_fillet", 26}, SharedFile{"cone", 2},
                                           SharedFile{"nurbs_sphere", 1}, SharedFile{"pinch", 10},
                                           SharedFile{"revolved_spline", 1},
                                           SharedFile{"touching", 12},
                                           SharedFile{"two_holes_touch", 12}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace surfmesh
