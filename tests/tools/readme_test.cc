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

/// In order and in one folder: a line may use what those before it wrote.
#ifdef SURFMESH_HAS_CAD
constexpr bool kReadsCad = true;
#else
constexpr bool kReadsCad = false;
#endif

TEST_F(Readme, HasCommandLinesThatWork) {
  std::filesystem::create_directory_symlink(std::filesystem::path(SURFMESH_SOURCE_DIR) / "models",
                                            folder_ / "models");
  for (const char* document : {"README.md", "libsurfmesh/REFERENCE.md", "libsurfmesh/GALLERY.md"}) {
    const std::vector<std::string> lines = command_lines(document);
    EXPECT_GE(lines.size(), 8u);
    for (const std::string& line : lines) {
      if (!kReadsCad && line.find(" part.om") != line.npos) continue;
      if (!kReadsCad && line.find(".step") != line.npos) continue;
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
