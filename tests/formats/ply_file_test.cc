// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/ply_file.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

const std::string kText =
    "ply\nformat ascii 1.0\ncomment patch 1 the wing\nobj_info x\n"
    "element vertex 4\nproperty float x\nproperty uchar red\nproperty double y\nproperty int z\n"
    "element face 2\nproperty list uchar int vertex_index\nproperty short patch\n"
    "property list int float weights\nelement edge 1\nproperty int a\nend_header\n"
    "0 9 0 0\n1 9 0 0\n1 9 1.5 0\n0 9 1 -2\n4 0 1 2 3 1 0\n3 0 1 2 -1 2 0.5 nan\n7\n";

std::string ply_error(const std::string& bytes) {
  return error_of([&] { parse_ply(bytes, "a.ply"); });
}

/// The text with its first `what` replaced.
std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(PlyFile, IsReadFromText) {
  const MeshArraysFile file = parse_ply(kText, "a.ply");
  ASSERT_EQ(file.mesh.points.size(), 4u);
  EXPECT_EQ(file.mesh.points[2], Vec3(1, 1.5, 0));
  EXPECT_EQ(file.mesh.points[3], Vec3(0, 1, -2));
  ASSERT_EQ(file.mesh.faces.size(), 2u);
  EXPECT_EQ(file.mesh.faces[0].size(), 4u);
  EXPECT_EQ(file.mesh.patches, (std::vector<int>{1, -1}));
  EXPECT_EQ(file.mesh.names.patches, (std::vector<std::string>{"", "the wing"}));
  EXPECT_TRUE(texts_of(file.notices).empty());
}

template <class Number>
void append(std::string& bytes, Number value, bool is_swapped) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (is_swapped) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// One triangle with coordinates, counts and indices of the given types.
template <class Coordinate, class Count, class Index>
std::string triangle(const std::string& coordinate, const std::string& count,
                     const std::string& index, std::endian order) {
  const bool is_swapped = order != std::endian::native;
  std::string bytes = std::string("ply\nformat binary_") +
                      (order == std::endian::little ? "little" : "big") +
                      "_endian 1.0\nelement vertex 3\n";
  for (const char* axis : {"x", "y", "z"}) bytes += "property " + coordinate + " " + axis + "\n";
  bytes += "element face 1\nproperty list " + count + " " + index + " vertex_indices\nend_header\n";
  for (int i = 0; i < 9; ++i) append(bytes, static_cast<Coordinate>(i * i % 7), is_swapped);
  append(bytes, Count{3}, is_swapped);
  for (const int i : {2, 0, 1}) append(bytes, static_cast<Index>(i), is_swapped);
  return bytes;
}

void expect_triangle(const std::string& bytes) {
  const MeshArraysFile file = parse_ply(bytes, "a.ply");
  ASSERT_EQ(file.mesh.points.size(), 3u);
  EXPECT_EQ(file.mesh.points[1], Vec3(2, 2, 4));
  ASSERT_EQ(file.mesh.faces.size(), 1u);
  EXPECT_EQ(file.mesh.faces[0][0], 2);
  EXPECT_TRUE(file.mesh.patches.empty());
}

TEST(PlyFile, IsReadFromBytesOfAnyTypeAndOrder) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expect_triangle(triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", order));
    expect_triangle(
        triangle<double, std::int32_t, std::uint32_t>("float64", "int32", "uint", order));
    expect_triangle(
        triangle<std::int16_t, std::uint16_t, std::int8_t>("short", "uint16", "char", order));
    expect_triangle(
        triangle<std::uint8_t, std::int8_t, std::uint16_t>("uint8", "int8", "ushort", order));
  }
}

/// What was written before there were groups: binary, with the patch as a value of each face.
TEST(PlyFile, IsReadAsItWasWrittenBefore) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment surfmesh\ncomment patch 0 x\n"
      "comment patch 1 the wing\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
      "property int patch\nend_header\n";
  for (int i = 0; i < 9; ++i) append(bytes, i / 3.0, false);
  append(bytes, std::uint8_t{3}, false);
  for (const int i : {2, 0, 1, 1}) append(bytes, i, false);
  const MeshArrays mesh = parse_ply(bytes, "a.ply").mesh;
  EXPECT_EQ(mesh.points.at(2), Vec3(2, 7 / 3.0, 8 / 3.0));
  EXPECT_EQ(mesh.patches, std::vector<int>{1});
  EXPECT_EQ(mesh.names, (MeshNames{{"x", "the wing"}, {}}));
}

TEST(PlyFile, IsRefusedWhereverItIsCut) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(2, 2);
  attach_result_properties(mesh);
  write_mesh(mesh, folder / "a.ply", {{"x"}, {}});
  const std::string bytes = read_text(folder / "a.ply");
  // Whether the last line has its end is no matter.
  for (std::size_t size = 0; size + 1 < bytes.size(); ++size) {
    EXPECT_NE(ply_error(bytes.substr(0, size)), "no error") << size;
  }
  const std::string binary =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", std::endian::little);
  for (std::size_t size = 0; size < binary.size(); ++size) {
    EXPECT_NE(ply_error(binary.substr(0, size)), "no error") << size;
  }
  EXPECT_NE(ply_error(binary.substr(0, binary.size() - 1)).find(": byte "), std::string::npos);
}

TEST(PlyFile, SurvivesEveryWrongByte) {
  const std::string good =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", std::endian::little);
  for (const std::string& bytes : {good, kText}) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      for (const char c : {'\0', '9', '\xff', '\n'}) {
        std::string bad = bytes;
        bad[i] = c;
        ply_error(bad);  // an error or none, but no crash
      }
    }
  }
}

TEST(PlyFile, TellsFaultsOfTheHeader) {
  EXPECT_EQ(ply_error(""), "invalid input: a.ply: the file is empty");
  EXPECT_EQ(ply_error("solid\n"),
            "invalid input: a.ply:1: this is not a PLY file, it does not begin with ply");
  EXPECT_EQ(ply_error(with(kText, "ascii", "ebcdic")),
            "invalid input: a.ply:2: the format 'ebcdic' is none of ascii, binary_little_endian, "
            "binary_big_endian");
  EXPECT_EQ(ply_error(with(kText, "format ascii 1.0\n", "")),
            "invalid input: a.ply:15: the header has no line with the format");
  EXPECT_EQ(ply_error(with(kText, "float x", "half x")),
            "invalid input: a.ply:6: 'half' is not a type of numbers");
  EXPECT_EQ(ply_error(with(kText, "vertex 4", "vertex -4")),
            "invalid input: a.ply:5: the count of an element is '-4'");
  EXPECT_EQ(ply_error(with(kText, "vertex 4", "vertex 99999999999")),
            "invalid input: a.ply:5: 99999999999 elements are more than can be read");
  EXPECT_NE(ply_error(with(kText, "double y", "double w")).find("x, y and z once each"),
            std::string::npos);
  EXPECT_NE(ply_error(with(kText, "vertex_index", "corners")).find("one list vertex_indices"),
            std::string::npos);
}

TEST(PlyFile, LeavesOutFacesOfTwoVertices) {
  const MeshArraysFile file = parse_ply(with(kText, "4 0 1 2 3", "2 0 1"), "a.ply");
  EXPECT_EQ(file.mesh.faces.size(), 1u);
  EXPECT_EQ(file.mesh.patches, std::vector<int>{-1});
  EXPECT_EQ(
      texts_of(file.notices),
      std::vector<std::string>{
          "a.ply:21: a face without three different vertices, or without an inside, is left out"});
}

TEST(PlyFile, TellsFaultsOfTheBody) {
  EXPECT_EQ(ply_error(with(kText, "1.5", "nan")),
            "invalid input: a.ply:19: a coordinate is 'nan', which is not finite");
  EXPECT_EQ(ply_error(with(kText, "4 0 1 2 3", "4 0 1 2 4")),
            "invalid input: a.ply:21: vertex index 4, but there are 4 vertices, from 0");
  EXPECT_EQ(ply_error(with(kText, "4 0 1 2 3 1 0", "4 0 1 2 3")),
            "invalid input: a.ply:21: a patch is missing");
  EXPECT_EQ(ply_error(with(kText, "7\n", "")),
            "invalid input: a.ply:23: the file ends after 0 of 1 elements 'edge'");
  std::string bytes =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", std::endian::little);
  const std::size_t end = bytes.size();
  bytes[end - 4] = 3;
  EXPECT_EQ(ply_error(bytes), "invalid input: a.ply: byte " + std::to_string(end - 13) +
                                  ": vertex index 3, but there are 3 vertices, from 0");
}

TEST(PlyFile, WarnsOfWhatComesAfterTheEnd) {
  EXPECT_EQ(texts_of(parse_ply(kText + "8\n", "a.ply").notices).size(), 1u);
  const std::string bytes =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", std::endian::little);
  EXPECT_EQ(texts_of(parse_ply(bytes + "xy", "a.ply").notices),
            std::vector<std::string>{"a.ply: 2 bytes after the last element are ignored"});
}

TEST(PlyFile, HoldsFacesOfManyCorners) {
  const TestFolder folder;
  PolyMesh mesh;
  std::vector<VertexHandle> corners;
  for (int i = 0; i < 300; ++i) {
    corners.push_back(mesh.add_vertex({std::cos(i * 0.02), std::sin(i * 0.02), 0}));
  }
  mesh.add_face(corners);
  write_mesh(mesh, folder / "a.ply");
  EXPECT_EQ(parse_ply(read_text(folder / "a.ply"), "a.ply").mesh.faces[0].size(), 300u);
}

}  // namespace
}  // namespace surfmesh
