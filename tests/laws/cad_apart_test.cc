// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "laws/sources.hh"

namespace surfmesh {
namespace {

/// OpenCASCADE's headers end in .hxx; ours that use them lie in surfmesh_cad.
bool includes_cad(const std::string& line) {
  static const std::regex pattern(
      R"re(^\s*#\s*include\s*["<](surfmesh_cad/|[^">]*\.[hlg]xx[">]))re");
  return std::regex_search(line, pattern);
}

TEST(CadApart, NothingOfTheLibraryIncludesIt) {
  for (const auto& file : testing::library_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(includes_cad(file.code[i])) << place(file, i);
    }
  }
}

/// Nor is OpenCASCADE in the header that applications include, for it may not be installed there.
TEST(CadApart, ItsPublicHeaderNamesNothingOfOpenCascade) {
  for (const auto& file : testing::library_sources_with_parts()) {
    if (file.path != "surfmesh_cad/read_cad.hh") continue;
    for (const std::string& line : file.code) EXPECT_FALSE(includes_cad(line)) << line;
  }
}

TEST(CadApart, TheLibraryLinksNothingOfIt) {
  static const std::regex pattern(R"(OpenCASCADE|\bTK[A-Z]|surfmesh_cad)");
  for (const char* name : {"CMakeLists.txt", "install.cmake"}) {
    std::ifstream stream(std::filesystem::path(SURFMESH_SOURCE_DIR) / "libsurfmesh" / name);
    const std::string text{std::istreambuf_iterator<char>(stream),
                           std::istreambuf_iterator<char>()};
    EXPECT_FALSE(text.empty());
    EXPECT_FALSE(std::regex_search(text, pattern)) << name;
  }
}

TEST(CadApart, SeesAnInclude) {
  EXPECT_TRUE(includes_cad("#include <TopoDS_Shape.hxx>"));
  EXPECT_TRUE(includes_cad("#include \"surfmesh_cad/read_cad.hh\""));
  EXPECT_FALSE(includes_cad("#include \"surfmesh/model/cad_input.hh\""));
}

}  // namespace
}  // namespace surfmesh
