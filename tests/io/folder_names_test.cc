// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/folder_names.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

TEST(FolderNames, AreThoseOfFilesAndFolders) {
  const TestFolder folder;
  EXPECT_TRUE(folder_names(folder.path()).empty());
  write_text(folder / "a", "");
  write_text(folder / ".b", "");
  std::filesystem::create_directory(folder / "c");
  std::vector<std::string> names = folder_names(folder.path());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{".b", "a", "c"}));
}

TEST(FolderNames, TellsThatThereIsNone) {
  const TestFolder folder;
  const std::string path = (folder / "none").string();
  EXPECT_EQ(error_of([&] { folder_names(path); }),
            "io: cannot read " + path + ": No such file or directory");
}

}  // namespace
}  // namespace surfmesh
