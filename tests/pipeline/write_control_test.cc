// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/write_control.hh"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/analytic.hh"
#include "support/control_nodes.hh"
#include "support/errors.hh"
#include "surfmesh/io/input_file.hh"

namespace surfmesh {
namespace {

/// The part of a file between the tags of one array.
std::string array_of(const std::string& text, const std::string& name) {
  const std::size_t start = text.find('\n', text.find("Name=\"" + name + "\"")) + 1;
  return text.substr(start, text.find("</DataArray>", start) - start);
}

class ControlFile : public ::testing::Test {
 protected:
  ControlFile()
      : surface_(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Domain{}),
        control_({}, nodes(), {.interpolation = Interpolation::Automatic}) {}

  static std::vector<ControlNode> nodes() {
    auto list = testing::grid({}, 2, [](Uv) { return size_tensor(0.5, 0.25, 0); });
    list[0].inner = isotropic(0.1);
    list[0].radius = 0.3;
    return list;
  }

  std::string written(const char* name) const {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / name;
    write_control({{"square", &control_.mesh(), &surface_}}, path);
    const std::string text = read_file(path);
    std::filesystem::remove(path);
    return text;
  }

  test::PlanePatch surface_;
  ControlMesh control_;
};

TEST_F(ControlFile, HoldsTheNodesWithTheirSizes) {
  const std::string text = written("a.vtu");
  EXPECT_NE(text.find("NumberOfPoints=\"4\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_EQ(array_of(text, "points"), " 0 0 0\n 1 0 0\n 1 1 0\n 0 1 0\n");
  EXPECT_EQ(array_of(text, "sizes"), " 0.5 0.25\n 0.5 0.25\n 0.5 0.25\n 0.5 0.25\n");
  EXPECT_EQ(array_of(text, "radii"), " 0.3 0\n 0 0\n 0 0\n 0 0\n");
}

TEST_F(ControlFile, HoldsTensorsInSpace) {
  const std::string tensors = array_of(written("a.vtu"), "size");
  EXPECT_EQ(tensors.substr(0, tensors.find('\n')), " 0.5 0 0 0 0.25 0 0 0 0");
}

TEST_F(ControlFile, HoldsPatchAndClassOfTriangles) {
  const std::string text = written("a.vtu");
  EXPECT_EQ(array_of(text, "patch"), " 0 0\n");
  EXPECT_EQ(array_of(text, "class"), " 0 0\n");  // all nodes agree: V_s
  EXPECT_EQ(array_of(text, "offsets"), " 3 6\n");
  EXPECT_EQ(array_of(text, "types"), " 5 5\n");
}

TEST_F(ControlFile, IsAMeshOfTheGroupInObj) {
  const std::string text = written("a.obj");
  EXPECT_NE(text.find("v 1 1 0\n"), std::string::npos);
  EXPECT_NE(text.find("g square\nf "), std::string::npos);
}

TEST_F(ControlFile, RefusesOtherEndings) {
  const std::string error = error_of([&] { written("a.off"); });
  EXPECT_EQ(error.rfind(name(ErrorCode::InvalidInput), 0), 0U) << error;
  EXPECT_NE(error.find("a.off"), std::string::npos) << error;
}

}  // namespace
}  // namespace surfmesh
