// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_folder.hh"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/mesh_pieces.hh"
#include "support/thread_exchange.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/exchange/serial_exchange.hh"
#include "surfmesh/formats/grid_file.hh"

namespace surfmesh {
namespace {

namespace fs = std::filesystem;

/// Give a folder all pieces of a strip, each from the rank of its number modulo the size.
void fill(PieceFolder& folder, Exchange& exchange, int count) {
  const std::vector<MeshPiece> pieces = testing::strip_in_pieces(12, count);
  folder.begin({.pieces = count, .patches = 2});
  for (int p = exchange.rank(); p < count; p += exchange.size()) {
    folder.write(p, pieces[static_cast<std::size_t>(p)]);
  }
  folder.finish();
}

void write_strip(const fs::path& path, int count) {
  SerialExchange exchange;
  PieceFolder folder(path, exchange);
  fill(folder, exchange, count);
  folder.commit(nullptr);
}

std::set<std::string> files_of(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(PieceFolder, HoldsPiecesOfAllRanks) {
  const TestFolder folder;
  testing::run_ranks(3, [&](Exchange& exchange) {
    PieceFolder pieces(folder / "mesh", exchange);
    fill(pieces, exchange, 4);
    pieces.commit(nullptr);
  });
  EXPECT_EQ(files_of(folder.path()), std::set<std::string>{"mesh"});
  EXPECT_EQ(files_of(folder / "mesh"),
            (std::set<std::string>{"mesh.pvtu", "mesh_0000.vtu", "mesh_0001.vtu", "mesh_0002.vtu",
                                   "mesh_0003.vtu"}));
  const MeshPiece third = testing::strip_in_pieces(12, 4)[2];
  EXPECT_EQ(read_grid(folder / "mesh/mesh_0002.vtu").points, third.points);
  EXPECT_NE(read_text(folder / "mesh/mesh.pvtu").find("<Piece Source=\"mesh_0003.vtu\"/>"),
            std::string::npos);
}

TEST(PieceFolder, ReplacesAnOlderOutputAsAWhole) {
  const TestFolder folder;
  write_strip(folder / "mesh", 4);
  write_strip(folder / "mesh/", 2);
  EXPECT_EQ(files_of(folder.path()), std::set<std::string>{"mesh"});
  EXPECT_EQ(files_of(folder / "mesh"),
            (std::set<std::string>{"mesh.pvtu", "mesh_0000.vtu", "mesh_0001.vtu"}));
}

TEST(PieceFolder, LeavesNothingWithoutACommitAndKeepsAnOlderOutput) {
  const TestFolder folder;
  write_strip(folder / "mesh", 2);
  const std::string before = read_text(folder / "mesh/mesh_0000.vtu");
  testing::run_ranks(3, [&](Exchange& exchange) {
    PieceFolder pieces(folder / "mesh", exchange);
    fill(pieces, exchange, 6);
    EXPECT_EQ(folder.count(), 2);
    sum_all(exchange, 0);
  });
  EXPECT_EQ(files_of(folder.path()), std::set<std::string>{"mesh"});
  EXPECT_EQ(files_of(folder / "mesh").size(), 3u);
  EXPECT_EQ(read_text(folder / "mesh/mesh_0000.vtu"), before);
}

TEST(PieceFolder, AppearsWithAnotherFile) {
  const TestFolder folder;
  testing::run_ranks(2, [&](Exchange& exchange) {
    PieceFolder pieces(folder / "mesh", exchange);
    fill(pieces, exchange, 2);
    if (exchange.rank() != 0) return pieces.commit(nullptr);
    OutputFile report(folder / "report");
    report.write("all is well");
    pieces.commit(&report);
  });
  EXPECT_EQ(files_of(folder.path()), (std::set<std::string>{"mesh", "report"}));
}

TEST(PieceFolder, ComesBackWhereTheOtherFileCannotBeWritten) {
  const TestFolder folder;
  write_strip(folder / "mesh", 2);
  SerialExchange exchange;
  {
    PieceFolder pieces(folder / "mesh", exchange);
    fill(pieces, exchange, 6);
    OutputFile report(folder / "report");
    fs::create_directory(folder / "report");
    EXPECT_THROW(pieces.commit(&report), AgreedError);
  }
  EXPECT_EQ(files_of(folder.path()), (std::set<std::string>{"mesh", "report"}));
  EXPECT_EQ(files_of(folder / "mesh").size(), 3u);
}

TEST(PieceFolder, ReplacesNoFolderWithOtherFiles) {
  const TestFolder folder;
  write_strip(folder / "mesh", 2);
  write_text(folder / "mesh/notes.txt", "mine");
  const std::string path = (folder / "mesh").string();
  EXPECT_EQ(error_of([&] { write_strip(path, 2); }),
            "io: cannot write " + path + ": it is replaced as a whole, and has notes.txt in it");
  EXPECT_EQ(read_text(folder / "mesh/notes.txt"), "mine");
}

TEST(PieceFolder, ReplacesNoFolderThatGetsOtherFilesMeanwhile) {
  const TestFolder folder;
  write_strip(folder / "mesh", 2);
  const std::string before = read_text(folder / "mesh/mesh_0000.vtu");
  {
    SerialExchange exchange;
    PieceFolder pieces(folder / "mesh", exchange);
    fill(pieces, exchange, 6);
    write_text(folder / "mesh/notes.txt", "mine");
    EXPECT_EQ(error_of([&] { pieces.commit(nullptr); }),
              "io: cannot write " + (folder / "mesh").string() +
                  ": it is replaced as a whole, and has notes.txt in it");
  }
  EXPECT_EQ(files_of(folder.path()), std::set<std::string>{"mesh"});
  EXPECT_EQ(files_of(folder / "mesh").size(), 4u);
  EXPECT_EQ(read_text(folder / "mesh/notes.txt"), "mine");
  EXPECT_EQ(read_text(folder / "mesh/mesh_0000.vtu"), before);
}

TEST(PieceFolder, TellsWhereNoFolderCanBe) {
  const TestFolder folder;
  write_text(folder / "file", "");
  const std::string root = folder.path().string();
  EXPECT_EQ(error_of([&] { write_strip(root + "/file", 1); }),
            "io: cannot write " + root + "/file: it is no folder");
  EXPECT_EQ(error_of([&] { write_strip(root + "/none/mesh", 1); }),
            "io: cannot write " + root + "/none/mesh: there is no folder " + root + "/none");
  EXPECT_EQ(error_of([&] { write_strip(root + "/caf\xE9", 1); }),
            "io: cannot write " + root +
                "/caf\xE9: its name is not UTF-8, as the .pvtu file in it has to be");
  EXPECT_EQ(folder.count(), 1);
}

TEST(PieceFolder, TellsAllRanksOfAnErrorOfTheFirst) {
  const TestFolder folder;
  for (const std::exception_ptr& error : testing::errors_of_ranks(3, [&](Exchange& exchange) {
         PieceFolder pieces(folder / "none/mesh", exchange);
         fill(pieces, exchange, 3);
       })) {
    ASSERT_TRUE(error);
    EXPECT_THROW(std::rethrow_exception(error), AgreedError);
  }
}

}  // namespace
}  // namespace surfmesh
