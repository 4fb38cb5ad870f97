// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/piece_file.hh"

#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/folders.hh"
#include "support/mesh_pieces.hh"
#include "support/thread_exchange.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/exchange/agree_on_error.hh"
#include "surfmesh/exchange/serial_exchange.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

/// The mesh that pieces are of.
PolyMesh mesh_of(const std::vector<MeshPiece>& pieces) {
  std::vector<Vec3> points;
  for (const MeshPiece& piece : pieces) {
    for (std::size_t v = 0; v < piece.points.size(); ++v) {
      const auto id = static_cast<std::size_t>(piece.ids[v]);
      if (id >= points.size()) points.resize(id + 1);
      points[id] = piece.points[v];
    }
  }
  PolyMesh mesh;
  for (const Vec3& point : points) mesh.add_vertex(to_openmesh(point));
  const auto patch = attach(mesh, keys::face_patch, 0);
  for (const MeshPiece& piece : pieces) {
    for (std::size_t f = 0; f < piece.faces.size(); ++f) {
      std::vector<VertexHandle> vertices;
      for (const int v : piece.faces[f]) {
        vertices.emplace_back(static_cast<int>(piece.ids[static_cast<std::size_t>(v)]));
      }
      mesh.property(patch, mesh.add_face(vertices)) = piece.patches[f];
    }
  }
  return mesh;
}

void write_pieces(const std::filesystem::path& path, const std::vector<MeshPiece>& pieces,
                  Exchange& exchange) {
  const int count = static_cast<int>(pieces.size());
  PieceFile file(path, exchange);
  file.begin({.pieces = count, .patches = 2, .names = testing::kStripNames});
  for (int p = exchange.rank(); p < count; p += exchange.size()) {
    file.write(p, pieces[static_cast<std::size_t>(p)]);
  }
  file.finish();
  file.commit(nullptr);
}

TEST(PieceFile, HoldsTheBytesOfTheWholeMesh) {
  for (const char* name : {"a.obj", "a.ply"}) {
    const TestFolder folder;
    for (const int count : {1, 3, 5}) {
      const std::vector<MeshPiece> pieces = testing::strip_in_pieces(60, count);
      write_mesh(mesh_of(pieces), folder / name, testing::kStripNames);
      const std::string whole = read_text(folder / name);
      for (const int ranks : {1, 2, 4}) {
        std::filesystem::remove(folder / name);
        testing::run_ranks(
            ranks, [&](Exchange& exchange) { write_pieces(folder / name, pieces, exchange); });
        EXPECT_TRUE(read_text(folder / name) == whole)
            << name << " of " << count << " pieces on " << ranks << " ranks";
        EXPECT_EQ(folder.count(), 1);
      }
    }
  }
}

/// What does not fit into one block.
TEST(PieceFile, HoldsManyVertices) {
  const TestFolder folder;
  const std::vector<MeshPiece> pieces = testing::strip_in_pieces(60000, 3);
  write_mesh(mesh_of(pieces), folder / "a.obj", testing::kStripNames);
  const std::string whole = read_text(folder / "a.obj");
  ASSERT_GT(whole.size(), std::size_t{5} << 20);
  testing::run_ranks(2,
                     [&](Exchange& exchange) { write_pieces(folder / "a.obj", pieces, exchange); });
  EXPECT_TRUE(read_text(folder / "a.obj") == whole);
}

TEST(PieceFile, LeavesNothingWithoutACommitAndKeepsAnOlderFile) {
  const TestFolder folder;
  write_text(folder / "a.obj", "old");
  const std::vector<MeshPiece> pieces = testing::strip_in_pieces(12, 2);
  testing::run_ranks(2, [&](Exchange& exchange) {
    PieceFile file(folder / "a.obj", exchange);
    file.begin({.pieces = 2, .patches = 2});
    file.write(exchange.rank(), pieces[static_cast<std::size_t>(exchange.rank())]);
    file.finish();
  });
  EXPECT_EQ(read_text(folder / "a.obj"), "old");
  EXPECT_EQ(folder.count(), 1);
}

TEST(PieceFile, TellsWhatCannotBeWritten) {
  const TestFolder folder;
  SerialExchange exchange;
  const auto error = [&](const std::string& path, bool has_quads) {
    PieceFile file(path, exchange);
    return error_of([&] { file.begin({.pieces = 1, .patches = 1, .has_quads = has_quads}); });
  };
  EXPECT_EQ(error("a.stl", false),
            "invalid input: a.stl: only .obj and .ply can be written in pieces");
  EXPECT_EQ(error("a.ply", true),
            "invalid input: a.ply: quads can be written in pieces as .obj only");
  EXPECT_EQ(error((folder / "none/a.obj").string(), false),
            "io: cannot write " + (folder / "none/a.obj").string() + ": No such file or directory");
}

}  // namespace
}  // namespace surfmesh
