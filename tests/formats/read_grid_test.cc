// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/grid_file.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "formats/grid_texts.hh"
#include "formats/named_example.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/medit_reader.hh"
#include "surfmesh/formats/msh_reader.hh"
#include "surfmesh/formats/vtu_reader.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

std::vector<int> face(const GridFile& grid, std::size_t f) {
  return {grid.faces[f].begin(), grid.faces[f].end()};
}

void expect_msh_example(const GridFile& grid) {
  ASSERT_EQ(grid.points.size(), 8u);
  EXPECT_EQ(grid.points[4], Vec3(2, 0.5, 0));
  ASSERT_EQ(grid.faces.size(), 2u);
  EXPECT_EQ(face(grid, 0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(face(grid, 1), (std::vector<int>{1, 4, 2}));
  EXPECT_EQ(grid.patches, (std::vector<int>{0, 1}));
  const std::vector<Group> groups = {{"one", {0}}, {"all of it", {0, 1}}};
  EXPECT_EQ(grid.names.groups, groups);
  EXPECT_EQ(grid.names.contours, std::vector<std::string>{"the rim"});
  EXPECT_EQ(grid.contours, (std::vector<int>{0, -1, -1, -1, -1, -1, -1}));
  ASSERT_EQ(grid.at_points.size(), 1u);
  const std::vector<double>& h = grid.at_points[0].numbers;
  ASSERT_EQ(h.size(), 8u);
  EXPECT_EQ(h[0], 0.5);
  EXPECT_EQ(h[1], 0.25);
  EXPECT_TRUE(std::isnan(h[2]));
  EXPECT_EQ(h[4], 1e-3);
}

TEST(ReadMsh, ReadsVersion22) { expect_msh_example(parse_msh_grid(kMsh22, "a.msh")); }

TEST(ReadMsh, ReadsVersion41) { expect_msh_example(parse_msh_grid(kMsh41, "a.msh")); }

TEST(ReadMsh, TellsWhatIsLeftOut) {
  const MeshArraysFile file = parse_msh(kMsh22, "a.msh");
  EXPECT_EQ(file.mesh.points.size(), 5u);
  EXPECT_EQ(file.unread, (std::vector<std::string>{"1 nodes on sides of elements of higher order",
                                                   "1 points that are elements", "values h",
                                                   "3 points of no face"}));
}

TEST(ReadMsh, MakesContoursOfTheMesh) {
  TestFolder folder;
  write_text(folder / "a.msh", kMsh41);
  const MeshFile file = mesh_from(parse_msh(kMsh41, "a.msh"), "a.msh");
  const auto contour_of = require(file.mesh, keys::edge_contour);
  int contours = 0;
  for (const auto edge : file.mesh.edges()) {
    if (file.mesh.property(contour_of, edge) < 0) continue;
    ++contours;
    EXPECT_EQ(file.mesh.calc_edge_midpoint(edge), OpenMesh::Vec3d(0.5, 0, 0));
  }
  EXPECT_EQ(contours, 1);
}

/// A tetrahedron and a triangle of an unnamed group.
std::string binary_msh22(std::endian order) {
  Bytes bytes(order);
  bytes.text("$MeshFormat\n2.2 1 8\n").add(std::int32_t{1}).text("\n$EndMeshFormat\n$Nodes\n4\n");
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    bytes.add(static_cast<std::int32_t>(i + 1));
    bytes.all<double>(points[i].x(), points[i].y(), points[i].z());
  }
  bytes.text("\n$EndNodes\n$Elements\n2\n");
  bytes.all<std::int32_t>(2, 1, 2, 1, 77, 3, 1, 2, 3);
  bytes.all<std::int32_t>(4, 1, 2, 2, 0, 1, 1, 2, 3, 4);
  bytes.text("\n$EndElements\n$NodeData\n1\n\"m\"\n1\n0\n3\n0\n3\n1\n");
  bytes.add(std::int32_t{2}).all<double>(1, 2, 3);
  return bytes.text("\n$EndNodeData\n").done();
}

std::string binary_msh41(std::endian order) {
  Bytes bytes(order);
  bytes.text("$MeshFormat\n4.1 1 8\n").add(std::int32_t{1}).text("\n$EndMeshFormat\n$Entities\n");
  bytes.all<std::int64_t>(0, 0, 1, 1);
  bytes.add(std::int32_t{3}).all<double>(0, 0, 0, 1, 1, 1).add(std::int64_t{1});
  bytes.add(std::int32_t{-77}).add(std::int64_t{0});
  bytes.add(std::int32_t{1}).all<double>(0, 0, 0, 1, 1, 1).all<std::int64_t>(0, 1);
  bytes.add(std::int32_t{3}).text("\n$EndEntities\n$Nodes\n");
  bytes.all<std::int64_t>(1, 4, 1, 4).all<std::int32_t>(3, 1, 0).all<std::int64_t>(4, 1, 2, 3, 4);
  bytes.all<double>(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1).text("\n$EndNodes\n$Elements\n");
  bytes.all<std::int64_t>(2, 2, 1, 2).all<std::int32_t>(2, 3, 2).all<std::int64_t>(1, 1, 1, 2, 3);
  bytes.all<std::int32_t>(3, 1, 4).all<std::int64_t>(1, 2, 1, 2, 3, 4);
  bytes.text("\n$EndElements\n$NodeData\n1\n\"m\"\n1\n0\n3\n0\n3\n1\n");
  bytes.add(std::int32_t{2}).all<double>(1, 2, 3);
  return bytes.text("\n$EndNodeData\n").done();
}

TEST(ReadMsh, ReadsBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const std::string& bytes : {binary_msh22(order), binary_msh41(order)}) {
      const GridFile grid = parse_msh_grid(bytes, "a.msh");
      ASSERT_EQ(grid.tetrahedra.size(), 1u);
      EXPECT_EQ(grid.tetrahedra[0], (std::array<int, 4>{0, 1, 2, 3}));
      EXPECT_EQ(face(grid, 0), (std::vector<int>{0, 1, 2}));
      EXPECT_EQ(grid.points[3], Vec3(0, 0, 1));
      EXPECT_EQ(grid.names.groups, (std::vector<Group>{{"physical 77", {0}}}));
      EXPECT_EQ(grid.at_points[0].components, 3);
      EXPECT_EQ(grid.at_points[0].numbers[5], 3);
    }
  }
}

TEST(ReadMsh, AveragesTheValuesOfElements) {
  std::string text = kMsh22;
  text = text.substr(0, text.find("$NodeData"));
  text +=
      "$ElementNodeData\n1\n\"e\"\n1\n0\n3\n0\n1\n2\n3 4 1 2 3 4\n5 3 4 6 9\n$EndElementNodeData\n";
  const GridFile grid = parse_msh_grid(text, "a.msh");
  ASSERT_EQ(grid.at_points.size(), 1u);
  const std::vector<double>& e = grid.at_points[0].numbers;
  EXPECT_EQ(std::vector<double>(e.begin(), e.begin() + 5), (std::vector<double>{1, 3, 6, 4, 6}));
  EXPECT_TRUE(std::isnan(e[5]));
}

/// Gmsh repeats elements that are in several groups.
TEST(ReadMsh, TakesTheFirstOfElementsWithOneNumber) {
  std::string text = kMsh22;
  text = text.substr(0, text.find("$NodeData"));
  const std::size_t four = text.find("\n4 ");
  ASSERT_NE(four, text.npos);
  text.replace(four, 3, "\n3 ");
  text += "$ElementNodeData\n1\n\"e\"\n1\n0\n3\n0\n1\n1\n5 3 4 6 9\n$EndElementNodeData\n";
  const GridFile grid = parse_msh_grid(text, "a.msh");
  ASSERT_EQ(grid.at_points.size(), 1u);
  EXPECT_EQ(std::count_if(grid.at_points[0].numbers.begin(), grid.at_points[0].numbers.end(),
                          [](double x) { return std::isfinite(x); }),
            3);
}

TEST(ReadMsh, LeavesOutViewsWithoutValues) {
  std::string text = kMsh22;
  text = text.substr(0, text.find("$NodeData"));
  text += "$NodeData\n1\n\"e\"\n1\n0\n3\n0\n1\n0\n$EndNodeData\n";
  const GridFile grid = parse_msh_grid(text, "a.msh");
  EXPECT_TRUE(grid.at_points.empty());
  EXPECT_NE(std::find(grid.unread.begin(), grid.unread.end(), "1 views without values"),
            grid.unread.end());
}

TEST(ReadGrid, TakesTextWithTextAndBinaryWithBinary) {
  const TestFolder folder;
  const PolyMesh mesh = named_example(0);
  for (const char* name : {"a.mesh", "a.meshb"}) {
    write_mesh(mesh, folder / name);
    OutputFile file(*companion_of(mesh, folder / name));
    write_companion(mesh, folder / name, file);
    file.commit();
  }
  std::ofstream(folder / "a.sol") << "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n"
                                  << mesh.n_vertices() << "\n1 1\n";
  {
    std::ofstream sol(folder / "a.sol", std::ios::app);
    for (std::size_t v = 0; v < mesh.n_vertices(); ++v) sol << "0.5\n";
  }
  EXPECT_EQ(read_grid(folder / "a.mesh").at_points[0].components, 1);
  EXPECT_EQ(read_grid(folder / "a.sol").at_points[0].components, 1);
  EXPECT_EQ(read_grid(folder / "a.meshb").at_points[0].components, 6);
  EXPECT_EQ(read_grid(folder / "a.solb").at_points[0].components, 6);
}

TEST(ReadMedit, ReadsText) {
  const GridFile grid = parse_medit_grid(kMedit, "a.mesh");
  ASSERT_EQ(grid.points.size(), 5u);
  EXPECT_EQ(face(grid, 0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(face(grid, 1), (std::vector<int>{1, 4, 2}));
  EXPECT_EQ(grid.patches, (std::vector<int>{0, 1}));
  EXPECT_EQ(grid.contours, (std::vector<int>{0, -1, -1, -1, -1, -1, -1}));
}

TEST(ReadMedit, ReadsTheSolBesideIt) {
  TestFolder folder;
  write_text(folder / "a.mesh", kMedit);
  write_text(folder / "a.sol", kSol);
  for (const char* name : {"a.mesh", "a.sol"}) {
    const GridFile grid = read_grid(folder / name);
    ASSERT_EQ(grid.at_points.size(), 2u) << name;
    EXPECT_EQ(grid.at_points[0].name, "sol1");
    EXPECT_EQ(grid.at_points[0].numbers, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
    EXPECT_EQ(grid.at_points[1].name, "sol3");
    // xx, xy, yy, xz, yz, zz become xx, yy, zz, xy, yz, xz.
    const std::vector<double>& m = grid.at_points[1].numbers;
    EXPECT_EQ(std::vector<double>(m.begin(), m.begin() + 6),
              (std::vector<double>{1, 3, 6, 2, 5, 4}));
    EXPECT_EQ(grid.unread,
              std::vector<std::string>{"vectors and unsymmetric tensors of a .sol file"});
  }
}

TEST(ReadMedit, ReadsTwoDimensions) {
  GridFile grid = parse_medit_grid(
      "MeshVersionFormatted 2\nDimension\n2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\nTriangles 1\n1 2 3 "
      "0\n",
      "a.mesh");
  EXPECT_TRUE(grid.patches.empty());
  EXPECT_EQ(grid.points[2], Vec3(0, 1, 0));
  add_medit_values("MeshVersionFormatted 2 Dimension 2 SolAtVertices 3 1 3 1 0 4 1 0 4 1 0 9",
                   "a.sol", grid);
  ASSERT_EQ(grid.at_points.size(), 1u);
  EXPECT_EQ(grid.at_points[0].name, "sol");
  EXPECT_TRUE(grid.at_points[0].is_plane_tensor);
  EXPECT_EQ(grid.at_points[0].numbers.back(), 9);
}

template <class Integer, class Place, class Number>
std::string binary_medit(std::endian order, int version, bool has_values) {
  Bytes bytes(order);
  const auto keyword = [&](int code, std::size_t size) {
    bytes.add(std::int32_t{code});
    bytes.add(static_cast<Place>(bytes.size() + sizeof(Place) + size));
  };
  bytes.all<std::int32_t>(1, version);
  keyword(3, sizeof(std::int32_t));
  bytes.add(std::int32_t{3});
  const std::size_t i = sizeof(Integer), n = sizeof(Number);
  if (has_values) {
    // Kinds of values have four bytes in all versions.
    keyword(62, i + 2 * sizeof(std::int32_t) + 3 * n);
    bytes.add(Integer{3}).template all<std::int32_t>(1, 1).template all<Number>(0.5, 0.25, 2);
  } else {
    keyword(4, i + 3 * (3 * n + i));
    bytes.add(Integer{3});
    for (int v = 0; v < 3; ++v) {
      bytes.template all<Number>(v == 1, v == 2, 0.5).add(Integer{0});
    }
    keyword(13, 2 * i);  // corners
    bytes.template all<Integer>(1, 1);
    keyword(6, 5 * i);
    bytes.template all<Integer>(1, 1, 2, 3, 8);
  }
  bytes.add(std::int32_t{54});
  return bytes.add(Place{0}).done();
}

TEST(ReadMedit, ReadsBinary) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto check = [](const std::string& mesh, const std::string& values) {
      GridFile grid = parse_medit_grid(mesh, "a.meshb");
      ASSERT_EQ(grid.points.size(), 3u);
      EXPECT_EQ(grid.points[1], Vec3(1, 0, 0.5));
      EXPECT_EQ(face(grid, 0), (std::vector<int>{0, 1, 2}));
      EXPECT_EQ(grid.patches, std::vector<int>{0});
      add_medit_values(values, "a.solb", grid);
      EXPECT_EQ(grid.at_points[0].numbers, (std::vector<double>{0.5, 0.25, 2}));
    };
    using I4 = std::int32_t;
    using I8 = std::int64_t;
    check(binary_medit<I4, I4, float>(order, 1, false),
          binary_medit<I4, I4, float>(order, 1, true));
    check(binary_medit<I4, I4, double>(order, 2, false),
          binary_medit<I4, I4, double>(order, 2, true));
    check(binary_medit<I4, I8, double>(order, 3, false),
          binary_medit<I4, I8, double>(order, 3, true));
    check(binary_medit<I8, I8, double>(order, 4, false),
          binary_medit<I8, I8, double>(order, 4, true));
  }
}

TEST(ReadVtu, ReadsText) {
  const GridFile grid = parse_vtu_grid(kVtu, "a.vtu");
  ASSERT_EQ(grid.points.size(), 5u);
  EXPECT_EQ(face(grid, 0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(face(grid, 1), (std::vector<int>{1, 4, 2}));
  EXPECT_EQ(grid.patches, (std::vector<int>{2, 1}));
  EXPECT_EQ(grid.tetrahedra.size(), 1u);
  ASSERT_EQ(grid.at_points.size(), 1u);
  EXPECT_EQ(grid.at_points[0].numbers[3], 2);
  EXPECT_TRUE(std::isnan(grid.at_points[0].numbers[4]));
}

TEST(ReadGrid, RefusesOtherEndings) {
  EXPECT_EQ(error_of([] { read_grid("a.stl"); }),
            "invalid input: a.stl: the ending of a mesh with values at its vertices is .msh, .vtu, "
            ".mesh, .meshb, .sol or .solb");
  TestFolder folder;
  write_text(folder / "a.sol", kSol);
  EXPECT_EQ(error_of([&] { read_grid(folder / "a.sol"); }),
            "io: " + (folder / "a.sol").string() +
                ": its mesh, a .mesh or .meshb of the same name, is not there");
}

}  // namespace
}  // namespace surfmesh
