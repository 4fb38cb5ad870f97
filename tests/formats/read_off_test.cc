// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/errors.hh"
#include "support/notices.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

using Faces = std::vector<std::vector<int>>;

const std::string kFour = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";

Cage off_cage(const std::string& text) { return parse_off(text, "a.off"); }
std::string off_error(const std::string& text) {
  return error_of([&] { off_cage(text); });
}
std::string off_fault(const std::string& text) {
  const std::string error = off_error(text);
  const std::string front = "invalid input: a.off:";
  return error.starts_with(front) ? error.substr(front.size()) : error;
}

TEST(ReadOff, ReadsPointsAndPolygons) {
  const Cage cage = off_cage("OFF\n# a comment\n4 2 0\n\n" + kFour + "4 0 1 2 3 # all\n3 0 2 3\n");
  ASSERT_EQ(cage.points.size(), 4u);
  EXPECT_EQ(cage.points[3], Vec3(0, 1, 0.5));
  EXPECT_EQ(cage.faces, (Faces{{0, 1, 2, 3}, {0, 2, 3}}));
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(ReadOff, ReadsAllFormsOfTheHeader) {
  const std::string rest = "\n" + kFour + "3 0 1 2\n";
  for (const char* header :
       {"OFF\n4 1 0", "OFF 4 1 5", "4 1 0", "4 1", "OFF\r\n4 1 0\r", "OFF4 1 0"}) {
    EXPECT_EQ(off_cage(header + rest).faces.size(), 1u) << header;
  }
}

TEST(ReadOff, IgnoresColumnsThatTheHeaderTells) {
  for (const char* header : {"COFF", "NOFF", "STOFF", "CNOFF", "NCOFF", "STCNOFF"}) {
    const Cage cage =
        off_cage(header + std::string("\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n"
                                      "3 0 1 2\n"));
    EXPECT_EQ(cage.points[2], Vec3(0, 1, 0)) << header;
    EXPECT_TRUE(texts_of(cage.notices).empty()) << header;
  }
}

TEST(ReadOff, DividesByTheFourthCoordinate) {
  const Cage cage = off_cage("4OFF\n3 1 0\n0 0 0 2\n1 0 0 0.5\n2 6 0 4\n3 0 1 2\n");
  EXPECT_EQ(cage.points[1], Vec3(2, 0, 0));
  EXPECT_EQ(cage.points[2], Vec3(0.5, 1.5, 0));
  EXPECT_EQ(texts_of(cage.notices),
            std::vector<std::string>{
                "a.off:3: coordinates are divided by the weight after them (and 2 more)"});
  EXPECT_EQ(off_fault("4OFF\n1 0 0\n1 2 3 0\n"), "3: the weight of a vertex is 0");
}

TEST(ReadOff, ReadsLinesThatEndAnywhere) {
  const std::string points = "0 0 0 1 0 0 1 1 0 0 1 0.5";
  const std::string faces = "4 0 1 2 3 3 0 2 3";
  for (const std::string& text :
       {"OFF 4 2 0 " + points + " " + faces, "OFF\n4 2 0\n" + points + "\n4 0 1 2 3\n3 0 2 3",
        "OFF\n4 2 0\n" + kFour + faces}) {
    const Cage cage = off_cage(text);
    EXPECT_EQ(cage.points[3], Vec3(0, 1, 0.5)) << text;
    EXPECT_EQ(cage.faces, (Faces{{0, 1, 2, 3}, {0, 2, 3}})) << text;
  }
  // With a value too few or too many, the fault is that of a file of lines.
  for (const char* more : {"\n3 0 1\n", "\n3 0 1 2 3\n"}) {
    EXPECT_EQ(off_fault("OFF\n4 1 0\n" + points + more), "5: the file ends after 2 of 4 vertices");
  }
}

TEST(ReadOff, LeavesOutFacesOfOneOrTwoVertices) {
  const Cage cage = off_cage("OFF\n4 4 0\n" + kFour + "2 0 1\n3 0 1 2\n1 3\n3 0 2 0\n");
  EXPECT_EQ(cage.faces, (Faces{{0, 1, 2}}));
  EXPECT_EQ(texts_of(cage.notices),
            std::vector<std::string>{"a.off:7: a face without three different vertices, or without "
                                     "an inside, is left out (and 2 more)"});
}

TEST(ReadOff, LeavesOutFacesWhoseBorderRunsThereAndBack) {
  // A tip in the middle, a tip at an end, tips on tips.
  for (const char* face : {"4 0 1 0 2", "4 1 0 2 0", "6 0 1 2 3 2 1", "6 2 1 0 1 2 3"}) {
    const Cage cage = off_cage("OFF\n4 2 0\n" + kFour + "3 0 1 2\n" + face + "\n");
    EXPECT_EQ(cage.faces.size(), 1u) << face;
  }
  EXPECT_EQ(off_fault("OFF\n4 1 0\n" + kFour + "5 0 1 2 0 3\n"),
            "7: a face has a vertex twice, not in a row");
}

TEST(ReadOff, WarnsOfColumnsThatTheHeaderDoesNotTell) {
  const Cage cage = off_cage("OFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n");
  EXPECT_EQ(
      texts_of(cage.notices),
      std::vector<std::string>{"a.off:3: values after the coordinates are ignored (and 2 more)"});
}

TEST(ReadOff, IgnoresColoursOfFaces) {
  const Cage cage = off_cage("OFF\n4 2 0\n" + kFour + "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n");
  EXPECT_EQ(cage.faces.size(), 2u);
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(ReadOff, WarnsOfLinesAfterTheLastFace) {
  EXPECT_EQ(texts_of(off_cage("OFF\n4 1 0\n" + kFour + "3 0 1 2\n3 0 2 3\n").notices),
            std::vector<std::string>{"a.off:8: the lines after the last face are ignored"});
}

TEST(ReadOffFaults, OfTheHeader) {
  EXPECT_EQ(off_fault("XOFF\n4 1 0\n"),
            "1: the header 'XOFF' is none of OFF, STOFF, COFF, NOFF, 4OFF");
  EXPECT_EQ(off_fault("OFF BINARY\n4 1 0\n"), "1: binary OFF files are not read");
  EXPECT_EQ(off_fault("ply\n4 1 0\n"),
            "1: the count of vertices is 'ply', which is not an integer");
  EXPECT_EQ(off_fault("OFF\n4\n"), "2: the count of faces is '', which is not an integer");
  EXPECT_EQ(off_fault("OFF\n-4 1 0\n"), "2: a count is negative");
  EXPECT_EQ(off_fault("OFF\n99999999999 1 0\n"),
            "2: the count of vertices is '99999999999', which is too large");
}

TEST(ReadOffFaults, OfFilesCutShort) {
  EXPECT_EQ(off_fault("OFF\n"), "2: the file ends before the counts");
  EXPECT_EQ(off_fault("OFF\n4 1 0\n0 0 0\n1 0 0"), "4: the file ends after 2 of 4 vertices");
  EXPECT_EQ(off_fault("OFF\n4 2 0\n" + kFour + "3 0 1 2"), "7: the file ends after 1 of 2 faces");
  EXPECT_EQ(off_fault("OFF\n4 1 0\n" + kFour + "4 0 1 2"), "7: a face has 3 of 4 vertices");
  EXPECT_EQ(off_fault("OFF\n2000000000 2000000000 0\n0 0 0"),
            "3: the file ends after 1 of 2000000000 vertices");
}

TEST(ReadOffFaults, OfVertices) {
  EXPECT_EQ(off_fault("OFF\n3 1 0\n0 0\n"), "3: a vertex needs three coordinates");
  EXPECT_EQ(off_fault("OFF\n3 1 0\n0 0 nan\n"), "3: a coordinate is 'nan', which is not finite");
  EXPECT_EQ(off_fault("OFF\n3 1 0\n0 0 0 red\n"),
            "3: a value after the coordinates is 'red', which is not a number");
}

TEST(ReadOffFaults, OfFaces) {
  const std::string front = "OFF\n4 1 0\n" + kFour;
  EXPECT_EQ(off_fault(front + "3 0 1 4\n"), "7: vertex index 4 is not in 0 to 3");
  EXPECT_EQ(off_fault(front + "3 0 1 -1\n"), "7: vertex index -1 is not in 0 to 3");
  EXPECT_EQ(off_fault(front + "-3 0 1 2\n"), "7: the vertex count of a face is negative");
  EXPECT_EQ(off_fault(front + "5 0 1 2 0 3\n"), "7: a face has a vertex twice, not in a row");
  EXPECT_EQ(off_fault(front + "2000000000 0 1\n"), "7: a face has 2 of 2000000000 vertices");
  EXPECT_EQ(off_fault(front + "x 0 1\n"),
            "7: the vertex count of a face is 'x', which is not an integer");
}

TEST(ReadOffFaults, OfTheFileAsAWhole) {
  using namespace std::string_literals;
  EXPECT_EQ(off_error(""), "invalid input: a.off: the file is empty");
  EXPECT_EQ(off_error("OFF\n0 0 0\n"), "invalid input: a.off: the file has no vertices");
  EXPECT_EQ(off_error("OFF\n4 0 0\n" + kFour), "invalid input: a.off: the file has no faces");
  EXPECT_EQ(off_error("OFF\n\0\0"s), "invalid input: a.off:2: a NUL byte, this is not a text file");
}

}  // namespace
}  // namespace surfmesh
