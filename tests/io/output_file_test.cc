// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/output_file.hh"

#include <gtest/gtest.h>

#include <array>

#include "support/errors.hh"
#include "support/folders.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

TEST(OutputFile, HoldsWhatWasWritten) {
  const TestFolder folder;
  const std::string text = std::string(1 << 20, 'x') + "\n\0y";
  write_file(folder / "a.txt", text);
  EXPECT_EQ(read_text(folder / "a.txt"), text);
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, TakesThePlaceOfTheOldFileOnCommitOnly) {
  const TestFolder folder;
  write_text(folder / "a.txt", "old");
  OutputFile file(folder / "a.txt");
  file.write("new");
  EXPECT_EQ(read_text(folder / "a.txt"), "old");
  file.commit();
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
  EXPECT_EQ(folder.count(), 1);
}

TEST(OutputFile, LeavesNothingBehindWithoutACommit) {
  const TestFolder folder;
  write_text(folder / "old.txt", "old");
  {
    OutputFile file(folder / "old.txt");
    file.write("new");
    OutputFile other(folder / "new.txt");
    other.write("new");
    EXPECT_EQ(folder.count(), 3);
  }
  EXPECT_EQ(folder.count(), 1);
  EXPECT_EQ(read_text(folder / "old.txt"), "old");
}

TEST(OutputFile, KeepsThePermissionsOfTheOldFile) {
  const TestFolder folder;
  write_text(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms(0640));
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms(0640));
}

TEST(OutputFile, FollowsLinks) {
  const TestFolder folder;
  write_text(folder / "a.txt", "old");
  fs::create_symlink("a.txt", folder / "link.txt");
  write_file(folder / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read_text(folder / "a.txt"), "new");
}

TEST(OutputFile, RefusesFolders) {
  const TestFolder folder;
  EXPECT_EQ(error_of([&] { write_file(folder.path(), ""); }),
            "io: cannot write " + folder.path().string() + ": it is a folder");
  const std::string path = (folder / "b/a.txt").string();
  EXPECT_EQ(error_of([&] { write_file(path, ""); }),
            "io: cannot write " + path + ": No such file or directory");
  EXPECT_EQ(error_of([] { write_file("", ""); }), "io: cannot write : it is a folder");
}

TEST(OutputFile, RefusesWriteProtectedFiles) {
  const TestFolder folder;
  write_text(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms(0444));
  const std::string path = (folder / "a.txt").string();
  EXPECT_EQ(error_of([&] { write_file(path, "new"); }),
            "io: cannot write " + path + ": it is write-protected");
  EXPECT_EQ(read_text(path), "old");
}

TEST(OutputFile, TellsThatADeviceIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(error_of([] { write_file("/dev/full", "text"); }),
            "io: cannot write /dev/full: No space left on device");
  EXPECT_FALSE(fs::is_regular_file("/dev/full"));
}

TEST(OutputFile, CommitsAllFilesOfARun) {
  const TestFolder folder;
  write_text(folder / "a.txt", "old");
  OutputFile a(folder / "a.txt"), b(folder / "b.txt");
  a.write("new a");
  b.write("new b");
  OutputFile::commit_all(std::array{&a, &b});
  EXPECT_EQ(read_text(folder / "a.txt"), "new a");
  EXPECT_EQ(read_text(folder / "b.txt"), "new b");
  EXPECT_EQ(folder.count(), 2);
}

TEST(OutputFile, CommitsNothingIfADeviceIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TestFolder folder;
  {
    OutputFile a(folder / "a.txt"), full("/dev/full");
    a.write("new");
    full.write("new");
    EXPECT_EQ(error_of([&] {
                OutputFile::commit_all(std::array{&a, &full});
              }),
              "io: cannot write /dev/full: No space left on device");
  }
  EXPECT_EQ(folder.count(), 0);
}

TEST(OutputFile, PutsOldFilesBackIfALaterOneCannotBeReplaced) {
  const TestFolder folder;
  write_text(folder / "old.txt", "old");
  {
    OutputFile old(folder / "old.txt"), made(folder / "made.txt"), last(folder / "last.txt");
    for (OutputFile* file : {&old, &made, &last}) file->write("new");
    fs::create_directory(folder / "last.txt");
    EXPECT_EQ(error_of([&] {
                OutputFile::commit_all(std::array{&old, &made, &last});
              }),
              "io: cannot write " + (folder / "last.txt").string() + ": Is a directory");
  }
  EXPECT_EQ(read_text(folder / "old.txt"), "old");
  EXPECT_FALSE(fs::exists(folder / "made.txt"));
  EXPECT_EQ(folder.count(), 2);
}

TEST(OutputFile, StepsOverTemporaryFilesOfOthers) {
  const TestFolder folder;
  write_text(folder / ".surfmesh-0.tmp", "other");
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(read_text(folder / ".surfmesh-0.tmp"), "other");
  EXPECT_EQ(folder.count(), 2);
}

}  // namespace
}  // namespace surfmesh
