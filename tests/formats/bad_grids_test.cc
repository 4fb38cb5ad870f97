// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "formats/grid_texts.hh"
#include "support/errors.hh"
#include "surfmesh/formats/medit_reader.hh"
#include "surfmesh/formats/msh_reader.hh"
#include "surfmesh/formats/vtu_reader.hh"

namespace surfmesh {
namespace {

/// A text in which one word was replaced by another, and what is told of it.
struct BadText {
  std::string word;
  std::string replacement;
  std::string message;
};

using Parser = GridFile (*)(std::string, const std::string&);

void expect_messages(const std::string& good, Parser parse, const std::vector<BadText>& all) {
  for (const BadText& bad : all) {
    std::string text = good;
    const std::size_t at = text.find(bad.word);
    ASSERT_NE(at, std::string::npos) << bad.word;
    text.replace(at, bad.word.size(), bad.replacement);
    EXPECT_EQ(error_of([&] { parse(text, "a"); }), "invalid input: a:" + bad.message);
  }
}

TEST(BadMsh, IsToldWithItsLine) {
  expect_messages(
      kMsh22, parse_msh_grid,
      {{"$MeshFormat", "solid", "1: 'solid' stands where a section begins"},
       {"$MeshFormat", "$Nodes", "1: no Gmsh file, for it does not begin with $MeshFormat"},
       {"2.2 0", "4.0 0",
        "2: version '4.0' of Gmsh's files is not read; `gmsh -save -format msh41` writes 4.1"},
       {"$EndPhysicalNames", "$EndNames", "12: '$EndNames' stands where $PhysicalNames ends"},
       {"\n8\n", "\n-8\n", "14: the number of nodes is -8, below 0"},
       {"\n8\n", "\n123456789012\n",
        "14: the number of nodes is 123456789012, but the file has only 290 bytes after it"},
       {"20 1 0 0", "20 1 nan 0", "16: a coordinate is nan, which is not finite"},
       {"20 1 0 0", "20 1 x 0", "16: a coordinate is 'x', which is not a number"},
       {"20 1 0 0", "10 1 0 0", " two nodes have the same number"},
       {"5 9 2", "5 99 2", "30: the type 99 of an element is not known"},
       {"10 20 30 40", "10 20 31 40", "28: an element has the node 31, which is not there"},
       {"50 1e-3", "51 1e-3", "43: a value is that of the node 51, which is not there"},
       {"50 1e-3\n$EndNodeData\n", "",
        "43: the file ends before the number of a node, it is cut "
        "short"}});
}

TEST(BadMsh, IsToldWithItsLineInVersion4) {
  expect_messages(
      kMsh41, parse_msh_grid,
      {{"2 5 1 7", "2 5 1 700",
        "22: the number of nodes of a block is 700, but the file has only 321 bytes after it"},
       {"2 6 9 1", "1 6 9 1", "46: elements of a block are not of the dimension of its entity"}});
}

TEST(BadMedit, IsToldWithItsLine) {
  expect_messages(
      kMedit, parse_medit_grid,
      {{"MeshVersionFormatted 2", "MeshVersionFormatted 7", "1: version 7 is not one from 1 to 4"},
       {"MeshVersionFormatted", "Mesh",
        "1: no medit file, for it does not begin with "
        "MeshVersionFormatted"},
       {"Dimension 3", "Dimension 4", "2: the dimension is not 2 or 3"},
       {"Dimension 3", "", "4: no Dimension stands before this"},
       {"2 5 3 9", "2 6 3 9", "21: vertex 6, but there are 5 vertices, from 1"},
       {"1 2 3 4 5", "1 2 3 4 five", "18: a reference is 'five', which is no integer"},
       {"Vertices", "Points", "13: Edges stand before Vertices"}});
  GridFile grid = parse_medit_grid(kMedit, "a.mesh");
  grid.points.pop_back();
  EXPECT_EQ(error_of([&] { add_medit_values(kSol, "a.sol", grid); }),
            "invalid input: a.sol:4: values at 5 vertices, but the mesh has 4");
}

TEST(BadVtu, IsToldWithItsLine) {
  expect_messages(
      kVtu, parse_vtu_grid,
      {{"UnstructuredGrid\" version", "PolyData\" version",
        "2: a file of the type 'PolyData' is no UnstructuredGrid"},
       {"byte_order", "compressor=\"vtkLZ4DataCompressor\" byte_order",
        "2: 'vtkLZ4DataCompressor' is not read, only vtkZLibDataCompressor or none"},
       {"NumberOfCells=\"4\"", "NumberOfCells=\"5\"", "5: 5 cells with 4 offsets and 4 types"},
       {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\"",
        "5: NumberOfPoints is '-5', which is no number from 0"},
       {"1 1 0  0 1 0", "1 1 0  0 inf 0", "15: point 3, from 0, is not finite"},
       {"1 1 0  0 1 0", "1 1 0  0 1",
        "15: array '' has 14 numbers, but there are 5 points with 3 "
        "each"},
       {"1 4 2  0", "1 5 2  0", "5: cell 2, from 0, has the vertex 5, but there are 5 points"},
       {"2 6 9 13", "2 6 5 13", "5: cell 2, from 0, ends at 5 of 13 vertices"},
       {"3 8 5 10", "3 8 9 10", "5: cell 2, from 0, has 3 vertices, too few for the type 9"},
       {"</Cells>", "", "24: the XML is broken: mismatched tag"},
       {"0.25 1 2", "0.25 one 2", "7: array 'h': 'one' is not a number"},
       {"<?xml version=\"1.0\"?>", "<!DOCTYPE a [<!ENTITY b \"c\">]>",
        "1: a document type is not read"}});
}

/// Each byte of a file by itself, and several at once, become others, or the file ends there.
void mutate(const std::string& good, Parser parse) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t count) { return random() % count; };
  int errors = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= below(3); ++k) {
      bytes[below(bytes.size())] = static_cast<char>(below(2) == 0 ? below(256) : '0' + below(10));
    }
    if (below(8) == 0) bytes.resize(below(bytes.size()));
    try {
      const GridFile grid = parse(bytes, "a");
      for (const int vertex : grid.faces.vertices()) {
        ASSERT_LT(static_cast<std::size_t>(vertex), grid.points.size());
      }
    } catch (const Error& error) {
      ++errors;
      EXPECT_EQ(error.code(), ErrorCode::InvalidInput) << error.what();
    }
  }
  EXPECT_GT(errors, 300);
}

TEST(BadGrids, NeitherCrashNorHang) {
  mutate(kMsh22, parse_msh_grid);
  mutate(kMsh41, parse_msh_grid);
  mutate(kMedit, parse_medit_grid);
  mutate(kVtu, parse_vtu_grid);
  mutate(kSol, [](std::string bytes, const std::string& name) {
    GridFile grid = parse_medit_grid(kMedit, "a.mesh");
    add_medit_values(std::move(bytes), name, grid);
    return grid;
  });
}

TEST(BadGrids, NeitherCrashNorHangInBinary) {
  Bytes medit(std::endian::little);
  medit.all<std::int32_t>(1, 2, 3, 20, 3, 4, 116).add(std::int32_t{3});
  for (int v = 0; v < 3; ++v) medit.all<double>(v == 1, v == 2, 0).add(std::int32_t{0});
  medit.all<std::int32_t>(6, 144, 1, 1, 2, 3, 8, 54, 0);
  ASSERT_EQ(parse_medit_grid(medit.done(), "a").faces.size(), 1u);
  mutate(medit.done(), parse_medit_grid);
  Bytes msh(std::endian::big);
  msh.text("$MeshFormat\n2.2 1 8\n").add(std::int32_t{1}).text("\n$EndMeshFormat\n$Nodes\n3\n");
  for (int v = 0; v < 3; ++v) msh.add(v + 1).all<double>(v == 1, v == 2, 0);
  msh.text("\n$EndNodes\n$Elements\n1\n").all<std::int32_t>(2, 1, 2, 1, 77, 3, 1, 2, 3);
  msh.text("\n$EndElements\n");
  ASSERT_EQ(parse_msh_grid(msh.done(), "a").faces.size(), 1u);
  mutate(msh.done(), parse_msh_grid);
}

/// Base64 of arrays that zlib has compressed, made by Python's zlib, and appended raw arrays.
TEST(BadGrids, NeitherCrashNorHangInVtuArrays) {
  std::string text = kVtu;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("byte_order", "compressor=\"vtkZLibDataCompressor\" byte_order");
  replace("format=\"ascii\">3 8 5 10</DataArray>",
          "format=\"binary\">AQAAAAQAAAAAAAAADAAAAA==eJxj5mDlAgAAPAAb</DataArray>");
  EXPECT_EQ(parse_vtu_grid(text, "a").faces.size(), 2u);
  mutate(text, parse_vtu_grid);
  Bytes raw(std::endian::little);
  raw.add(std::int32_t{4}).text("\x03\x08\x05\x0A");
  std::string appended = kVtu;
  const std::string types = "format=\"ascii\">3 8 5 10</DataArray>";
  appended.replace(appended.find(types), types.size(), "format=\"appended\" offset=\"0\"/>");
  const std::string end = "</VTKFile>";
  appended.replace(appended.find(end), end.size(),
                   "<AppendedData encoding=\"raw\">_" + raw.done() + "</AppendedData></VTKFile>");
  EXPECT_EQ(parse_vtu_grid(appended, "a").faces.size(), 2u);
  mutate(appended, parse_vtu_grid);
}

}  // namespace
}  // namespace surfmesh
