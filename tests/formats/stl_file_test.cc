// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/stl_file.hh"

#include <gtest/gtest.h>

#include <cctype>
#include <limits>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "support/folders.hh"
#include "support/meshes.hh"
#include "support/notices.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

const std::string kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\n"
    "endfacet\n";
const std::string kOther =
    "FACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 1 1 0\n  VERTEX 0 1 0\n  VERTEX -0 0 0\n ENDLOOP\n"
    "ENDFACET\n";

std::string stl_error(const std::string& bytes) {
  return error_of([&] { parse_stl(bytes, "a.stl"); });
}

TEST(StlFile, IsReadFromTextAndWelded) {
  const MeshArraysFile file =
      parse_stl("solid a b\n" + kFacet + kOther + "endsolid a b\n", "a.stl");
  EXPECT_EQ(file.mesh.points.size(), 4u);
  EXPECT_EQ(file.mesh.faces.size(), 2u);
  EXPECT_TRUE(file.mesh.patches.empty());
}

TEST(StlFile, ReadsWhatOthersWrite) {
  const auto in_capitals = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
  };
  std::string parted = "solid\n" + kFacet + "end solid\n";
  for (const char* word : {"endloop", "endfacet"}) {
    parted.replace(parted.find(word), 3, "end ");
  }
  for (const std::string& text : {"\n\n  solid a\n" + kFacet + "endsolid\n",
                                  in_capitals("solid a\n" + kFacet + "endsolid a\n"), parted,
                                  "\tSolid\r\n" + kFacet + "endsolid"}) {
    EXPECT_EQ(parse_stl(text, "a.stl").mesh.faces.size(), 1u) << text;
  }
}

TEST(StlFile, MakesPatchesOfSeveralSolids) {
  const MeshArraysFile file =
      parse_stl("solid a\n" + kFacet + "endsolid a\nsolid\n" + kOther + "endsolid\n", "a.stl");
  EXPECT_EQ(file.mesh.patches, (std::vector<int>{0, 1}));
  EXPECT_EQ(file.mesh.names.patches, (std::vector<std::string>{"a", ""}));
}

TEST(StlFile, LeavesOutTrianglesWithEqualCorners) {
  const TestFolder folder;
  std::string flat = kFacet;
  flat.replace(flat.find("1 1 0"), 5, "1 0 0");
  write_text(folder / "a.stl", "solid\n" + kFacet + flat + "endsolid\n");
  const MeshFile read = read_mesh(folder / "a.stl");
  EXPECT_EQ(read.mesh.n_faces(), 1u);
  ASSERT_EQ(texts_of(read.notices).size(), 1u);
  EXPECT_NE(texts_of(read.notices)[0].find(
                "1 triangles with two equal corners are left out, the first is "
                "number 1"),
            std::string::npos)
      << texts_of(read.notices)[0];
}

TEST(StlFile, ReadsBackWhatSinglePrecisionHolds) {
  const TestFolder folder;
  const PolyMesh mesh = testing::octahedron();
  write_mesh(mesh, folder / "a.stl");
  EXPECT_EQ(std::filesystem::file_size(folder / "a.stl"), 84u + 8 * 50);
  const MeshFile read = read_mesh(folder / "a.stl");
  testing::expect_valid(read.mesh);
  EXPECT_EQ(read.mesh.n_vertices(), 6u);
  EXPECT_EQ(read.mesh.n_edges(), 12u);
  EXPECT_EQ(to_eigen(read.mesh.point(VertexHandle(0))), Vec3(1, 0, 0));
}

TEST(StlFile, SplitsQuadsAtTheirShorterDiagonal) {
  const TestFolder folder;
  PolyMesh mesh = testing::mesh_of({{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {2, -1, 0}}, {{0, 3, 2, 1}});
  write_mesh(mesh, folder / "a.stl");
  const MeshArraysFile file = parse_stl(read_text(folder / "a.stl"), "a.stl");
  ASSERT_EQ(file.mesh.faces.size(), 2u);
  for (std::size_t f = 0; f < 2; ++f) {
    double shortest = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto point = [&](std::size_t i) {
        return file.mesh.points[static_cast<std::size_t>(file.mesh.faces[f][i % 3])];
      };
      shortest = std::min(shortest, (point(k) - point(k + 1)).norm());
    }
    EXPECT_EQ(shortest, 2);
  }
}

TEST(StlFile, IsBinaryByItsSizeWhateverItsHeader) {
  const TestFolder folder;
  write_mesh(testing::octahedron(), folder / "a.stl");
  std::string bytes = read_text(folder / "a.stl");
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(parse_stl(bytes, "a.stl").mesh.faces.size(), 8u);
}

TEST(StlFile, IsRefusedWhereverItIsCut) {
  const TestFolder folder;
  write_mesh(testing::octahedron(), folder / "a.stl");
  const std::string bytes = read_text(folder / "a.stl");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(stl_error(bytes.substr(0, size)), "no error") << size;
  }
  EXPECT_NE(stl_error(bytes.substr(0, 200)).find("after 2 of 8 triangles (byte 200)"),
            std::string::npos)
      << stl_error(bytes.substr(0, 200));
}

TEST(StlFile, TellsFaults) {
  EXPECT_EQ(stl_error(""), "invalid input: a.stl: the file is empty");
  EXPECT_EQ(stl_error("solid\nfacet\nouter loop\nvertex 0 0\n"),
            "invalid input: a.stl:4: a vertex needs three coordinates");
  EXPECT_EQ(stl_error("solid\nfacet\nouter loop\nvertex 0 0 inf\n"),
            "invalid input: a.stl:4: a coordinate is 'inf', which is not finite");
  EXPECT_EQ(stl_error("solid\n" + kFacet), "invalid input: a.stl:9: the file ends before endsolid");
  EXPECT_EQ(stl_error("solid\nvertex 0 0 0\n"),
            "invalid input: a.stl:2: 'vertex' is not what comes next in an STL file");
  const TestFolder folder;
  write_mesh(testing::octahedron(), folder / "a.stl");
  std::string bytes = read_text(folder / "a.stl");
  bytes.replace(84 + 12, 4, "\xff\xff\xff\xff");
  EXPECT_NE(stl_error(bytes).find("a.stl: byte 96: a coordinate is"), std::string::npos);
}

TEST(StlFile, CannotHoldLargeNumbers) {
  const TestFolder folder;
  PolyMesh mesh = testing::octahedron();
  mesh.set_point(VertexHandle(2), {1e39, 0, 0});
  EXPECT_EQ(error_of([&] { write_mesh(mesh, folder / "a.stl"); }),
            "geometry: the position of vertex 2 is (1e+39, 0, 0), too large for .stl");
}

}  // namespace
}  // namespace surfmesh
