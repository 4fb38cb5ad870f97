// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "formats/five_points.hh"
#include "support/errors.hh"
#include "support/notices.hh"
#include "surfmesh/formats/read_cage.hh"

namespace surfmesh {
namespace {

using Faces = std::vector<std::vector<int>>;

/// Five vertices on lines 1 to 5; what is added begins on line 6.

Cage obj_cage(const std::string& text) { return parse_obj(text, "a.obj"); }
std::string obj_error(const std::string& text) {
  return error_of([&] { obj_cage(text); });
}
/// The error of a text after the five vertices, without the code and the name of the file.
std::string obj_fault(const std::string& rest) {
  const std::string error = obj_error(kFive + rest);
  const std::string front = "invalid input: a.obj:";
  return error.starts_with(front) ? error.substr(front.size()) : error;
}

TEST(ReadObj, ReadsPointsToTheLastBit) {
  const Cage cage = obj_cage(
      "v 0.1 -2.5e-3 +7\nv 1 .5 3.\nv 4.9406564584124654e-324 -0 1.7976931348623157e308\nf 1 2 "
      "3\n");
  EXPECT_EQ(cage.points[0], Vec3(0.1, -2.5e-3, 7));
  EXPECT_EQ(cage.points[1], Vec3(1, 0.5, 3));
  EXPECT_EQ(cage.points[2].x(), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(cage.points[2].y()));
  EXPECT_EQ(cage.points[2].z(), std::numeric_limits<double>::max());
}

TEST(ReadObj, TakesNumbersBelowTheLeastDoubleAsZero) {
  const Cage cage =
      obj_cage("v 1e-400 0." + std::string(400, '0') + "1 -1e-999\n" + kFive + "f 1 2 3");
  EXPECT_EQ(cage.points[0], Vec3(0, 0, 0));
}

TEST(ReadObj, IgnoresColoursAndDividesByWeights) {
  const Cage cage = obj_cage("v 1 2 3 1\nv 1 2 4 0.5 0.5 0.5\nv 1 2 5 1 0.5 0.5 0.5\nf 1 2 3\n");
  EXPECT_EQ(cage.points, (std::vector<Vec3>{{1, 2, 3}, {1, 2, 4}, {1, 2, 5}}));
  EXPECT_TRUE(texts_of(cage.notices).empty());
  const Cage weighted = obj_cage("v 1 2 3 4\nv 1 2 4 2 0.5 0.5 0.5\nv 1 2 5\nf 1 2 3\n");
  EXPECT_EQ(weighted.points, (std::vector<Vec3>{{0.25, 0.5, 0.75}, {0.5, 1, 2}, {1, 2, 5}}));
  EXPECT_EQ(texts_of(weighted.notices),
            std::vector<std::string>{
                "a.obj:1: coordinates are divided by the weight after them (and 1 more)"});
  EXPECT_EQ(obj_fault("v 1 2 3 0\n"), "6: the weight of a vertex is 0");
  EXPECT_EQ(obj_fault("v 1e300 0 0 1e-300\n"), "6: the weight of a vertex is too small");
  EXPECT_EQ(texts_of(obj_cage(kFive + "v 1 2 3 4 5\nf 1 2 3\n").notices),
            std::vector<std::string>{"a.obj:6: values after the coordinates are ignored"});
}

TEST(ReadObj, LeavesOutFacesOfOneOrTwoVertices) {
  const Cage cage = obj_cage(kFive +
                             "g a\nf 1 2\nf 1 2 3\ng b\nf\nf 1 2 1 3\nf 1 3 4\n"
                             "t hole 2/0/0 0 4\n");
  EXPECT_EQ(cage.faces, (Faces{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cage.holes, std::vector<int>{1}) << "the first face of the file is left out";
  ASSERT_EQ(cage.groups.size(), 2u);
  EXPECT_EQ(cage.groups[1].faces, std::vector<int>{1});
  EXPECT_EQ(texts_of(cage.notices),
            std::vector<std::string>{"a.obj:7: a face without three different vertices, or without "
                                     "an inside, is left out (and 2 more)"});
}

TEST(ReadObj, ReadsAllFormsOfCorners) {
  const Cage cage =
      obj_cage(kFive + "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//2 3//3\nf 1/1/1 2/-2/2 3/3/3\n");
  EXPECT_EQ(cage.faces, Faces(4, {0, 1, 2}));
}

TEST(ReadObj, CountsNegativeIndicesBackwardsFromTheFace) {
  const Cage cage = obj_cage("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1//-1 -4/1 -2\n");
  EXPECT_EQ(cage.faces, (Faces{{0, 1, 2}, {3, 0, 2}}));
}

TEST(ReadObj, AllowsFacesBeforeTheirVertices) {
  EXPECT_EQ(obj_cage("f 1 2 3\n" + kFive).faces, (Faces{{0, 1, 2}}));
}

TEST(ReadObj, ReadsPolygons) {
  EXPECT_EQ(obj_cage(kFive + "f 5 4 3 2 1\n").faces, (Faces{{4, 3, 2, 1, 0}}));
}

TEST(ReadObj, SkipsCommentsBlanksAndOtherLineEnds) {
  const std::string text =
      "\xEF\xBB\xBF# cage\r\n\r\n  v 0 0 0 # origin\r\n\tv 1 0 0\r\nv 0 1 0\r\nf 1 2 3";
  const Cage cage = obj_cage(text);
  EXPECT_EQ(cage.points.size(), 3u);
  EXPECT_EQ(cage.faces.size(), 1u);
  EXPECT_TRUE(texts_of(cage.notices).empty());
  EXPECT_EQ(obj_cage("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").faces.size(), 1u);
}

TEST(ReadObj, JoinsLinesAtBackslashes) {
  const Cage cage =
      obj_cage("v 0 0 \\\n0\nv 1 0\\\r\n 0\nv 0 1 0\nvt 1 \\\n 2\nf 1 \\\n\\\n2 3\\\n");
  EXPECT_EQ(cage.points.size(), 3u);
  EXPECT_EQ(cage.points[1], Vec3(1, 0, 0));
  EXPECT_EQ(cage.faces, (Faces{{0, 1, 2}}));
}

TEST(ReadObj, CountsJoinedLines) {
  EXPECT_EQ(obj_fault("f 1 \\\n 2 \\\n x\n"), "8: a vertex index is 'x', which is not an integer");
}

TEST(ReadObj, DoesNotJoinComments) {
  EXPECT_EQ(obj_cage("# C:\\models\\\n" + kFive + "f 1 2 3").points.size(), 5u);
}

TEST(ReadObj, IgnoresWhatACageDoesNotNeed) {
  const Cage cage = obj_cage("mtllib a.mtl\no body\nvt 0 0\nvn 0 0 1\nvp 1\n" + kFive +
                             "s off\nf 1 2 3\nl 1 2\np 1\n");
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(ReadObj, WarnsOfUnknownKeywordsOnce) {
  const Cage cage = obj_cage(kFive + "f 1 2 3\nfoo 1 2\nbar\nfoo\n");
  EXPECT_EQ(texts_of(cage.notices),
            std::vector<std::string>{"a.obj:7: unknown keyword 'foo' is ignored (and 2 more)"});
}

TEST(ReadObjGroups, AreInTheOrderOfTheirFirstFace) {
  const Cage cage = obj_cage("g unused\n" + kFive +
                             "f 1 2 3\ng b a\nf 1 2 4\ng a\nf 1 2 5\ng\nf 2 3 4\ng b\nf 1 3 4\n");
  ASSERT_EQ(cage.groups.size(), 4u);
  EXPECT_EQ(cage.groups[0].name, "unused");
  EXPECT_EQ(cage.groups[0].faces, std::vector<int>{0});
  EXPECT_EQ(cage.groups[1].name, "b");
  EXPECT_EQ(cage.groups[1].faces, (std::vector<int>{1, 4}));
  EXPECT_EQ(cage.groups[2].name, "a");
  EXPECT_EQ(cage.groups[2].faces, (std::vector<int>{1, 2}));
  EXPECT_EQ(cage.groups[3].name, "default");
  EXPECT_EQ(cage.groups[3].faces, std::vector<int>{3});
}

TEST(ReadObjGroups, AreObjectsToo) {
  const Cage cage = obj_cage(kFive + "o the lid\nf 1 2 3\no b\nusemtl red paint\nf 1 2 4\n");
  ASSERT_EQ(cage.groups.size(), 3u);
  EXPECT_EQ(cage.groups[0].name, "the lid");
  EXPECT_EQ(cage.groups[0].faces, std::vector<int>{0});
  EXPECT_EQ(cage.groups[1].name, "b");
  EXPECT_EQ(cage.groups[2].name, "red paint");
}

TEST(ReadObjGroups, AreNoneWithoutAName) {
  EXPECT_TRUE(obj_cage(kFive + "f 1 2 3").groups.empty());
}

TEST(ReadObjGroups, LeaveOutNamesWithoutFaces) {
  const Cage cage = obj_cage(kFive + "g a\ng b\nf 1 2 3\ng c\n");
  ASSERT_EQ(cage.groups.size(), 1u);
  EXPECT_EQ(cage.groups[0].name, "b");
}

TEST(ReadObjGroups, AreAlsoMadeByMaterials) {
  const Cage cage =
      obj_cage(kFive + "usemtl red\nf 1 2 3\ng wing\nf 1 2 4\nusemtl wing\nf 1 2 5\n");
  ASSERT_EQ(cage.groups.size(), 2u);
  EXPECT_EQ(cage.groups[0].name, "red");
  EXPECT_EQ(cage.groups[0].faces, (std::vector<int>{0, 1}));
  EXPECT_EQ(cage.groups[1].name, "wing");
  EXPECT_EQ(cage.groups[1].faces, (std::vector<int>{1, 2}));
}

TEST(ReadObjTags, AreReadWithIndicesFromZero) {
  const Cage cage = obj_cage(kFive +
                             "f 1 2 3 4\nf 1 2 5\nt crease 2/1/0 0 1 2.5\nt corner 1/1/0 4 10\n"
                             "t hole 1/0/0 1\nt interpolateboundary 1/0/0 1\n"
                             "t creasemethod 0/0/1 chaikin\nt smoothtriangles 0/0/1 smooth\n");
  ASSERT_EQ(cage.creases.size(), 1u);
  EXPECT_EQ(cage.creases[0].edge, (std::array<int, 2>{0, 1}));
  EXPECT_EQ(cage.creases[0].sharpness, 2.5);
  ASSERT_EQ(cage.corners.size(), 1u);
  EXPECT_EQ(cage.corners[0].vertex, 4);
  EXPECT_EQ(cage.corners[0].sharpness, 10);
  EXPECT_EQ(cage.holes, std::vector<int>{1});
  EXPECT_EQ(cage.boundary, BoundaryRule::EdgeAndCorner);
  EXPECT_TRUE(cage.is_chaikin);
  EXPECT_TRUE(cage.is_smooth_triangles);
  EXPECT_TRUE(texts_of(cage.notices).empty());
}

TEST(ReadObjTags, HaveTheDefaultsOfTheSuite) {
  const Cage cage = obj_cage(kFive + "f 1 2 3\nt creasemethod 0/0/1 normal\n");
  EXPECT_EQ(cage.boundary, BoundaryRule::EdgeOnly);
  EXPECT_FALSE(cage.is_chaikin);
  EXPECT_FALSE(cage.is_smooth_triangles);
}

TEST(ReadObjTags, MakeChainsOfCreases) {
  const Cage one = obj_cage(kFive + "f 1 2 3 4\nt crease 3/1/0 0 1 2 4\n");
  ASSERT_EQ(one.creases.size(), 2u);
  EXPECT_EQ(one.creases[1].edge, (std::array<int, 2>{1, 2}));
  EXPECT_EQ(one.creases[1].sharpness, 4);
  const Cage each =
      obj_cage(kFive + "f 1 2 3 4\nt crease 3/2/0 0 1 2 4 5\nt corner 2/2/0 0 1 6 7\n");
  EXPECT_EQ(each.creases[0].sharpness, 4);
  EXPECT_EQ(each.creases[1].sharpness, 5);
  EXPECT_EQ(each.corners[1].sharpness, 7);
}

TEST(ReadObjTags, WarnWhereTheyAreIgnored) {
  const Cage cage = obj_cage(kFive +
                             "f 1 2 3\nt vertexedit 1/1/1 x\nt facevaryinginterpolateboundary\n"
                             "t magic 1/0/0 7\nt crease 2/1/0 0 4 1\n");
  EXPECT_EQ(texts_of(cage.notices),
            (std::vector<std::string>{
                "a.obj:7: the tag vertexedit is ignored",
                "a.obj:8: the tag facevaryinginterpolateboundary is ignored",
                "a.obj:9: unknown tag 'magic' is ignored",
                "a.obj:10: crease: 0 and 4 (counted from 0) are not an edge of a face"}));
  EXPECT_TRUE(cage.creases.empty());
}

TEST(ReadObjTags, WarnOfValuesTooMany) {
  const Cage cage = obj_cage(kFive + "f 1 2 3\nt crease 2/1/0 0 1 3 4 5\n");
  EXPECT_EQ(cage.creases.size(), 1u);
  EXPECT_EQ(texts_of(cage.notices),
            std::vector<std::string>{
                "a.obj:7: a tag has more values than its counts tell, they are ignored"});
}

TEST(ReadObjTags, AreCheckedAtTheirLine) {
  const std::string face = "f 1 2 3\n";
  EXPECT_EQ(obj_fault(face + "t crease 2/1/0 0 9 1"),
            "7: vertex index 9, but there are 5 vertices");
  EXPECT_EQ(obj_fault(face + "t corner 1/1/0 -1 1"), "7: vertex index -1 of a tag is negative");
  EXPECT_EQ(obj_fault(face + "t hole 1/0/0 1"), "7: face index 1 of a hole, but there are 1 faces");
  EXPECT_EQ(obj_fault(face + "t crease 1/1/0 0 1"), "7: a crease needs two vertices");
  EXPECT_EQ(obj_fault(face + "t crease 2/0/0 0 1"),
            "7: a crease or corner has too few values of sharpness");
  EXPECT_EQ(obj_fault(face + "t crease 2/1/0 0 1 -2"), "7: a sharpness is negative");
  EXPECT_EQ(obj_fault(face + "t crease 2/1/0 0 1 nan"),
            "7: a value of a tag is 'nan', which is not finite");
  EXPECT_EQ(obj_fault(face + "t crease 2/1/0 0 1"),
            "7: a tag has fewer values than its counts tell");
  EXPECT_EQ(obj_fault(face + "t crease 2 0 1"), "7: the counts of a tag are '2', not like 2/1/0");
  EXPECT_EQ(obj_fault(face + "t creasemethod 0/0/1 other"),
            "7: the value of this tag is neither normal nor chaikin");
  EXPECT_EQ(obj_fault(face + "t interpolateboundary 1/0/0 3"),
            "7: interpolateboundary needs one value: 0 none, 1 edge and corner, 2 edge only");
}

TEST(ReadObjFaults, OfIndices) {
  EXPECT_EQ(obj_fault("f 1 2 0\n"), "6: vertex index 0, they count from 1");
  EXPECT_EQ(obj_fault("\nf 1 2 6\nf 1 2 3\n"), "7: vertex index 6, but there are 5 vertices");
  EXPECT_EQ(obj_fault("f 1 2 -6\n"), "6: vertex index -6, but 5 vertices before it");
  EXPECT_EQ(obj_fault("f 1 2 99999999999\n"),
            "6: a vertex index is '99999999999', which is too large");
  EXPECT_EQ(obj_fault("f 1 2 -2147483648\n"),
            "6: vertex index -2147483648, but 5 vertices before it");
  EXPECT_EQ(obj_fault("f 1 2 3.5\n"), "6: a vertex index is '3.5', which is not an integer");
  EXPECT_EQ(obj_fault("f 1 2 /3\n"), "6: a vertex index is '', which is not an integer");
  EXPECT_EQ(obj_fault("f 1 2 3/1/1/1\n"),
            "6: '/1/1/1' after a vertex index, which is not /vt, //vn or /vt/vn");
  EXPECT_EQ(obj_fault("f 1 2 3/a\n"),
            "6: '/a' after a vertex index, which is not /vt, //vn or /vt/vn");
}

TEST(ReadObjFaults, OfCoordinates) {
  EXPECT_EQ(obj_fault("v nan 0 0\n"), "6: a coordinate is 'nan', which is not finite");
  EXPECT_EQ(obj_fault("v 0 -inf 0\n"), "6: a coordinate is '-inf', which is not finite");
  EXPECT_EQ(obj_fault("v 0 1e400 0\n"), "6: a coordinate is '1e400', which is too large");
  EXPECT_EQ(obj_fault("v 0 0 1,5\n"), "6: a coordinate is '1,5', which is not a number");
  EXPECT_EQ(obj_fault("v 0 0 0x10\n"), "6: a coordinate is '0x10', which is not a number");
  EXPECT_EQ(obj_fault("v 0 0 +-1\n"), "6: a coordinate is '+-1', which is not a number");
  EXPECT_EQ(obj_fault("v 1 2\nf 1 2 3\n"), "6: a vertex needs three coordinates");
  EXPECT_EQ(obj_fault("f 1 2 3\nv 1 2"), "7: a vertex needs three coordinates");
}

TEST(ReadObjFaults, OfFaces) {
  EXPECT_EQ(obj_fault("f 1 2 3 1 4 5\n"), "6: a face has a vertex twice, not in a row");
}

TEST(ReadObjFaults, AreNotVerticesThatComeTwiceInARow) {
  const Cage cage = obj_cage(kFive + "f 1 1 2 3 3 3\nf 1 2 3 -5\n");
  EXPECT_EQ(cage.faces, (Faces{{0, 0, 1, 2, 2, 2}, {0, 1, 2, 0}}));
  EXPECT_EQ(texts_of(cage.notices), std::vector<std::string>{});
}

TEST(ReadObjFaults, OfTheFileAsAWhole) {
  EXPECT_EQ(obj_error(""), "invalid input: a.obj: the file is empty");
  EXPECT_EQ(obj_error(" \n# nothing\n"), "invalid input: a.obj: the file is empty");
  EXPECT_EQ(obj_error("o body\n"), "invalid input: a.obj: the file has no vertices");
  EXPECT_EQ(obj_error("f 1 2 3\n"), "invalid input: a.obj: the file has no vertices");
  EXPECT_EQ(obj_error(kFive), "invalid input: a.obj: the file has no faces");
}

TEST(ReadObjFaults, OfBinaryFiles) {
  using namespace std::string_literals;
  EXPECT_EQ(obj_error("v 0 0 0\nv\0 1"s),
            "invalid input: a.obj:2: a NUL byte, this is not a text file");
  EXPECT_EQ(obj_fault("v \x01\x02 0 0\n"), "6: a coordinate is '?\?', which is not a number");
}

TEST(ReadObjFaults, AreFoundWhereverTheTextIsCut) {
  const std::string text = kFive + "f 1 2 3\nf 1 3 4\nt crease 2/1/0 0 1 2\n";
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string error = obj_error(text.substr(0, size));
    EXPECT_TRUE(error == "no error" || error.starts_with("invalid input: a.obj:")) << error;
  }
}

}  // namespace
}  // namespace surfmesh
