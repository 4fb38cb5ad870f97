// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/errors.hh"
#include "support/notices.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

const std::filesystem::path kModels = std::filesystem::path(SURFMESH_SHARED_DIR) / "models";

/// Non-manifold on purpose, these have faces that are but an edge or a point.
bool has_broken_faces(const std::filesystem::path& path) {
  return path.stem() == "catmark_nonman_edges" || path.stem() == "loop_nonman_edges";
}

std::vector<std::filesystem::path> suite() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(kModels / "opensubdiv")) {
    if (entry.path().extension() == ".obj" && !has_broken_faces(entry.path())) {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// How many lines of a file begin with a word.
std::size_t count_lines(const std::filesystem::path& path, const std::string& word) {
  std::ifstream file(path);
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);) {
    count += (line + " ").starts_with(word + " ") ? 1 : 0;
  }
  return count;
}

class SharedCages : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kModels / "opensubdiv")) {
      GTEST_SKIP() << "no cages in " << kModels;
    }
  }
};

TEST_F(SharedCages, AreAllRead) {
  EXPECT_EQ(suite().size(), 63u);
  for (const auto& path : suite()) {
    const Cage cage = read_cage(path);
    EXPECT_EQ(cage.points.size(), count_lines(path, "v")) << path;
    EXPECT_EQ(cage.faces.size(), count_lines(path, "f")) << path;
    EXPECT_EQ(cage.creases.size(), count_lines(path, "t crease")) << path;
    EXPECT_EQ(cage.corners.size(), count_lines(path, "t corner")) << path;
  }
}

TEST_F(SharedCages, LeaveOutFacesWithoutThreeVertices) {
  const auto warning_of = [](const std::string& name) {
    const auto notices = read_cage(kModels / "opensubdiv" / (name + ".obj")).notices;
    const std::string text = notices.empty() ? "none" : notices[0].text;
    return text.substr(text.find(name));
  };
  const std::string reason =
      ": a face without three different vertices, or without an inside, is left out";
  EXPECT_EQ(warning_of("catmark_nonman_edges"), "catmark_nonman_edges.obj:215" + reason);
  EXPECT_EQ(warning_of("loop_nonman_edges"), "loop_nonman_edges.obj:192" + reason);
}

TEST_F(SharedCages, WarnOfNothingButTagsAndEdges) {
  for (const auto& path : suite()) {
    for (const std::string& warning : texts_of(read_cage(path).notices)) {
      EXPECT_TRUE(warning.find("the tag ") != std::string::npos ||
                  warning.find("are not an edge of a face") != std::string::npos)
          << warning;
    }
  }
}

TEST_F(SharedCages, HaveTheirTags) {
  const auto folder = kModels / "opensubdiv";
  EXPECT_EQ(read_cage(folder / "catmark_hole_test1.obj").holes, std::vector<int>{1});
  EXPECT_TRUE(read_cage(folder / "catmark_chaikin1.obj").is_chaikin);
  EXPECT_EQ(read_cage(folder / "catmark_edgeonly.obj").boundary, BoundaryRule::EdgeOnly);
  EXPECT_EQ(read_cage(folder / "catmark_edgecorner.obj").boundary, BoundaryRule::EdgeAndCorner);
  EXPECT_EQ(read_cage(folder / "catmark_cube_corner2.obj").corners.at(0).sharpness, 2.8);
}

TEST_F(SharedCages, SpotHasItsFaces) {
  const Cage cage = read_cage(kModels / "spot_control_mesh.obj");
  const auto count = [&](std::size_t size) {
    return std::count_if(cage.faces.begin(), cage.faces.end(),
                         [size](const auto& face) { return face.size() == size; });
  };
  EXPECT_EQ(cage.points.size(), 188u);
  EXPECT_EQ(count(3), 4);
  EXPECT_EQ(count(4), 160);
  EXPECT_EQ(count(5), 16);
}

}  // namespace
}  // namespace surfmesh
