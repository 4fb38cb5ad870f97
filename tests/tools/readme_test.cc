// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// The lines in the code blocks of a document that call the program.
std::vector<std::string> command_lines(const std::string& document) {
  std::istringstream text(read_text(std::filesystem::path(SURFMESH_SOURCE_DIR) / document));
  std::vector<std::string> lines;
  bool is_code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) is_code = !is_code;
    if (is_code && line.starts_with("surfmesh ")) lines.push_back(line.substr(0, line.find('#')));
  }
  return lines;
}

using Readme = Program;

#ifdef SURFMESH_HAS_CAD
constexpr bool kReadsCad = true;
#else
constexpr bool kReadsCad = false;
#endif

/// True for a line that needs what was not built here: the reader of CAD files, or the script of
/// pages.
bool needs_more(const std::string& line) {
  const auto has = [&](const char* word) { return line.find(word) != line.npos; };
  static const bool makes_pages = std::filesystem::exists(
      std::filesystem::path(SURFMESH_SOURCE_DIR) / "tools/view/page/dist/viewer.js");
  return (!kReadsCad && (has(" part.om") || has(".step"))) ||
         (!makes_pages && has("surfmesh view "));
}

/// In order and in one folder: a line may use what those before it wrote.
TEST_F(Readme, HasCommandLinesThatWork) {
  std::filesystem::create_directory_symlink(std::filesystem::path(SURFMESH_SOURCE_DIR) / "models",
                                            folder_ / "models");
  for (const char* document :
       {"README.md", "libsurfmesh/REFERENCE.md", "libsurfmesh/GALLERY.md", "libsurfmesh/VIEW.md",
        "libsurfmesh/FORMATS.md", "libsurfmesh/CLUSTER.md"}) {
    const std::vector<std::string> lines = command_lines(document);
    EXPECT_GE(lines.size(), 1u) << document;
    for (const std::string& line : lines) {
      if (needs_more(line)) continue;
      EXPECT_EQ(shell("'" SURFMESH_PROGRAM "'" + line.substr(8)), 0) << line << '\n' << err_;
    }
  }
}

TEST(Reference, NamesEveryOption) {
  const std::string text =
      read_text(std::filesystem::path(SURFMESH_SOURCE_DIR) / "libsurfmesh/REFERENCE.md");
  for (const std::string_view name : option_names()) {
    const std::string quoted = '`' + std::string(name) + '`';
    std::string flag = "--" + std::string(name);
    std::replace(flag.begin(), flag.end(), '_', '-');
    EXPECT_TRUE(text.find(quoted) != text.npos || text.find(flag) != text.npos) << name;
  }
}

}  // namespace
}  // namespace surfmesh
