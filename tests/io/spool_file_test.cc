// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/spool_file.hh"

#include <gtest/gtest.h>

#include <string>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

TEST(SpoolFile, HasNoName) {
  const TestFolder folder;
  SpoolFile spool(folder.path());
  spool.write("text");
  EXPECT_EQ(spool.size(), 4u);
  EXPECT_EQ(folder.count(), 0);
}

TEST(SpoolFile, CopiesPartsToPlacesOfAFile) {
  const TestFolder folder;
  SpoolFile spool(folder.path());
  spool.write("hello ");
  spool.write("world");
  write_text(folder / "a", "");
  FileAtOffsets file(folder / "a", "a");
  spool.copy(6, 5, file, 0);
  spool.copy(5, 1, file, 5);
  spool.copy(0, 5, file, 6);
  file.close();
  EXPECT_EQ(read_text(folder / "a"), "world hello");
}

/// More than is copied at once.
TEST(SpoolFile, CopiesMuch) {
  const TestFolder folder;
  std::string text;
  for (int i = 0; i < 400000; ++i) text += std::to_string(i) + ' ';
  SpoolFile spool(folder.path());
  spool.write(text);
  write_text(folder / "a", "ab");
  FileAtOffsets file(folder / "a", "a");
  spool.copy(0, text.size(), file, 2);
  file.close();
  EXPECT_TRUE(read_text(folder / "a") == "ab" + text);
}

TEST(SpoolFile, TellsWhereItHasTooFewBytes) {
  const TestFolder folder;
  SpoolFile spool(folder.path());
  spool.write("ab");
  write_text(folder / "a", "");
  FileAtOffsets file(folder / "a", "a");
  EXPECT_EQ(error_of([&] { spool.copy(0, 3, file, 0); }),
            "io: a temporary file in " + folder.path().string() + ": it became shorter");
}

TEST(SpoolFile, NeedsAFolder) {
  EXPECT_EQ(error_of([] { SpoolFile spool("/nowhere"); }),
            "io: a temporary file in /nowhere: No such file or directory");
}

TEST(FileAtOffsets, TellsWhereThereIsNone) {
  EXPECT_EQ(error_of([] { FileAtOffsets file("/nowhere/a", "the mesh"); }),
            "io: cannot write the mesh: No such file or directory");
}

}  // namespace
}  // namespace surfmesh
