// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// The order of the data flow: a folder includes only itself and those before it.
const std::array<std::string, 28> kFolders = {
    "core",     "io",         "exchange", "geometry", "formula",  "nurbs",      "model",
    "cage",     "metric",     "quality",  "delaunay", "boundary", "tiles",      "refine",
    "improve",  "patch_mesh", "quad",     "patch",    "control",  "sizes",      "sampling",
    "estimate", "assemble",   "across",   "pieces",   "formats",  "model_file", "pipeline"};

/// What lies in no folder, surfmesh.hh, stands above all of them.
std::optional<std::size_t> rank(const std::string& folder) {
  if (folder.empty()) return kFolders.size();
  const auto found = std::find(kFolders.begin(), kFolders.end(), folder);
  if (found == kFolders.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kFolders.begin());
}

/// Meshes are assembled where no control space is, although that folder stands below.
bool is_forbidden(const std::string& from, const std::string& folder) {
  return from == "assemble" &&
         (folder == "control" || folder == "sizes" || folder == "sampling" || folder == "estimate");
}

bool may_include(const std::string& from, const std::string& folder) {
  return rank(from) && rank(folder) && *rank(folder) <= *rank(from) && !is_forbidden(from, folder);
}

/// The folder of ours that a line includes, if it does; empty for what lies in none.
std::optional<std::string> included_folder(const std::string& line) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*["<]surfmesh/(?:([^/">]+)/)?)re");
  std::smatch match;
  if (!std::regex_search(line, match, pattern)) return std::nullopt;
  return match[1].str();
}

TEST(Layering, KnowsEveryFolder) {
  for (const auto& file : testing::library_sources()) {
    EXPECT_TRUE(rank(file.folder)) << file.path << " lies in no folder of the design";
  }
}

TEST(Layering, IncludesOnlyWhatComesBefore) {
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      const auto folder = included_folder(file.code[i]);
      EXPECT_TRUE(!folder || may_include(file.folder, *folder)) << place(file, i);
    }
  }
}

TEST(Layering, IncludesItsOwnHeadersByTheirWholePath) {
  static const std::regex quoted(R"re(^\s*#\s*include\s*"(?!surfmesh/))re");
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.code[i], quoted)) << place(file, i);
    }
  }
}

TEST(Layering, FollowsTheDataFlow) {
  EXPECT_TRUE(may_include("core", "core"));
  EXPECT_TRUE(may_include("pipeline", "formats"));
  EXPECT_FALSE(may_include("geometry", "metric"));
  EXPECT_FALSE(may_include("core", "elsewhere"));
  EXPECT_TRUE(may_include("", "pipeline"));
  EXPECT_FALSE(may_include("pipeline", ""));
}

/// A patch can be meshed where there is no control space: they see a metric field only.
TEST(Layering, KeepsTheControlSpaceFromTheMeshingStages) {
  for (const char* stage :
       {"boundary", "tiles", "refine", "improve", "patch_mesh", "patch", "assemble"}) {
    for (const char* folder : {"control", "sizes", "sampling"}) {
      EXPECT_FALSE(may_include(stage, folder)) << stage << ", " << folder;
    }
  }
}

TEST(Layering, SeesAnInclude) {
  EXPECT_EQ(included_folder("#include \"surfmesh/core/mesh.hh\""), "core");
  EXPECT_EQ(included_folder("#include <surfmesh/quad/front.hh>"), "quad");
  EXPECT_EQ(included_folder("#include <surfmesh/surfmesh.hh>"), "");
  EXPECT_EQ(included_folder("#include <vector>"), std::nullopt);
}

}  // namespace
}  // namespace surfmesh
