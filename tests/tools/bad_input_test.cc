// SPDX-License-Identifier: BSD-3-Clause
// What the program says of input that makes no sense: the whole line, with the place.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/program.hh"

namespace surfmesh {
namespace {

/// A file, and the line that it is answered with, after "surfmesh: error: ": the whole of it, or up
/// to figures that depend on how a place was searched for.
struct BadInput {
  std::string fact;  ///< name of the test
  std::string file;
  std::string text;
  std::string line;
};

void PrintTo(const BadInput& input, std::ostream* stream) { *stream << input.file; }

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kOff = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// A model of one patch p.
std::string patch(const std::string& surface, const std::string& domain = "",
                  const std::string& more = "", const std::string& in_root = "") {
  const std::string unit = R"("u": [0, 1], "v": [0, 1])";
  return R"({"patches": [{"name": "p", "surface": {)" + surface + R"(}, "domain": {)" +
         (domain.empty() ? unit : domain) + "}" + more + "}]" +
         (in_root.empty() ? "" : ", " + in_root) + "}";
}
std::string formula(const std::string& z) { return patch("\"z\": \"" + z + "\""); }

/// A model of the square p: [-1,1]² with these holes besides its sides, and contours a, b.
std::string square(const std::string& holes, const std::string& contours) {
  return R"({"patches": [{"name": "p", "surface": {"z": "0"},
             "domain": {"u": [-1, 1], "v": [-1, 1]},
             "loops": [["p:v0", "p:u1", "-p:v1", "-p:u0"])" +
         holes + R"(]}], "contours": [)" + contours + "]}";
}
std::string contour(const std::string& name, const std::string& u, const std::string& v) {
  return R"({"name": ")" + name + R"(", "range": [0, "2*pi"], "on": [{"patch": "p", "u": ")" + u +
         R"(", "v": ")" + v + "\"}]}";
}

const std::string kRubbish(
    "\x7f"
    "ELF\x02\x00\x01\xff\xfe\x80\x00\x13",
    12);

class BadInputs : public Program, public ::testing::WithParamInterface<BadInput> {};

TEST_P(BadInputs, AreToldWithTheirPlace) {
  const BadInput& input = GetParam();
  write_text(folder_ / input.file, input.text);
  EXPECT_EQ(run("mesh " + input.file + " -o out.obj"), 1);
  EXPECT_EQ(out_, "");
  EXPECT_TRUE(err_.starts_with("surfmesh: error: " + input.line)) << err_;
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1);
  EXPECT_EQ(folder_.count(), 1);
}

std::string fact_of(const ::testing::TestParamInfo<BadInput>& info) { return info.param.fact; }

INSTANTIATE_TEST_SUITE_P(
    Cage, BadInputs,
    ::testing::Values(
        BadInput{"IndexOutOfRange", "a.obj", kPoints + "f 1 2 3 5\n",
                 "a.obj:5: vertex index 5, but there are 4 vertices"},
        BadInput{"IndexZero", "a.obj", kPoints + "f 0 1 2\n",
                 "a.obj:5: vertex index 0, they count from 1"},
        BadInput{"IndexOverflows", "a.obj", kPoints + "f 1 2 18446744073709551617\n",
                 "a.obj:5: a vertex index is '18446744073709551617', which is too large"},
        BadInput{"OffIndexOutOfRange", "a.off", kOff + "3 0 1 4\n",
                 "a.off:7: vertex index 4 is not in 0 to 3"},
        BadInput{"NanCoordinate", "a.obj", "v 0 nan 0\n",
                 "a.obj:1: a coordinate is 'nan', which is not finite"},
        BadInput{"InfiniteCoordinate", "a.off", "OFF\n1 1 0\n0 0 inf\n",
                 "a.off:3: a coordinate is 'inf', which is not finite"},
        BadInput{"TwoDifferentVertices", "a.obj", kPoints + "f 1 2 2\n",
                 "a.obj: the file has no faces"},
        BadInput{"CutShort", "a.off", kOff, "a.off:7: the file ends after 0 of 1 faces"},
        BadInput{"CutShortInAVertex", "a.obj", "v 0 0 0\nv 1 0",
                 "a.obj:2: a vertex needs three coordinates"},
        BadInput{"RubbishObj", "a.obj", kRubbish, "a.obj:1: a NUL byte, this is not a text file"},
        BadInput{"RubbishOff", "a.off", kRubbish, "a.off:1: a NUL byte, this is not a text file"},
        BadInput{"Empty", "a.off", "", "a.off: the file is empty"},
        BadInput{"UnknownEnding", "a.vtu", kPoints,
                 "a.vtu: this is a mesh, no model; the ending of a cage is .obj, .off, .ply, .stl "
                 "or .om, that of a CAD file .step, .stp, "
                 ".iges, .igs or .brep, that of a model file .json"},
        BadInput{"PointsOnALine", "a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n",
                 "a.obj: the points of the cage lie on a line: its surface has no area"},
        BadInput{"EqualPoints", "a.obj", "v 1 0 0\nv 1 0 0\nv 1 0 0\nf 1 2 3\n",
                 "a.obj: the model's diagonal is 0: it has no extent"},
        BadInput{"TooLarge", "a.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n",
                 "a.obj: the model's diagonal is inf: it is too large"}),
    fact_of);

TEST_F(BadInputs, LoopCagesWithQuadsAreRefused) {
  write_text(folder_ / "a.obj", kPoints + "f 1 2 3\nf 1 2 3 4\n");
  EXPECT_EQ(run("mesh a.obj -o out.obj --scheme loop"), 1);
  EXPECT_EQ(
      err_,
      "surfmesh: error: a.obj: face 1 has 4 vertices: the Loop scheme knows triangles only\n");
}

TEST_F(BadInputs, FoldersThatDoNotExistAreNamed) {
  EXPECT_EQ(run("mesh no/a.obj -o out.obj"), 1);
  EXPECT_EQ(err_, "surfmesh: error: cannot read no/a.obj: it does not exist\n");
  EXPECT_EQ(run("mesh '" + own_model("cube.obj") + "' -o no/out.obj"), 1);
  EXPECT_EQ(err_, "surfmesh: error: cannot write no/out.obj: there is no folder no\n");
}

INSTANTIATE_TEST_SUITE_P(
    ModelFile, BadInputs,
    ::testing::Values(
        BadInput{"NotJson", "a.json", "solid a\n",
                 "a.json:1:1: syntax error while parsing value - invalid literal; last read: 's'"},
        BadInput{
            "Rubbish", "a.json", kRubbish,
            "a.json:1:1: syntax error while parsing value - invalid literal; last read: '\x7F'"},
        BadInput{"CutShort", "a.json", "{\"patches\": [\n",
                 "a.json:2:1: syntax error while parsing value - unexpected end of input; expected "
                 "'[', '{', or a literal"},
        BadInput{"UnknownKey", "a.json", patch("\"z\": \"0\", \"w\": \"0\""),
                 "a.json: /patches/0/surface/w: unknown key"},
        BadInput{"KeyElsewhere", "a.json", patch("\"z\": \"0\"", "", R"(, "hmin": 0.1)"),
                 "a.json: /patches/0/hmin: unknown key, hmin belongs in sizing"},
        BadInput{"FieldOfSizes", "a.json",
                 patch("\"z\": \"0\"", "", R"(, "sources": [{"field": {"size": "v-0.5"}}])"),
                 "a.json: /patches/0/sources/0: the size -0.5 that a field wants at (u,v) = ("},
        BadInput{"MoreThanItMayMake", "a.json",
                 patch("\"z\": \"0\"", "", "", R"("options": {"max_elements": 2})"),
                 "a.json: the sizes ask for about "},
        BadInput{"MisspeltKey", "a.json", R"({"pathces": []})",
                 "a.json: /pathces: unknown key, did you mean patches?"},
        BadInput{"MissingKey", "a.json", patch("\"x\": \"u\""),
                 "a.json: /patches/0/surface/z: this key is missing"},
        BadInput{"SizeZero", "a.json", patch("\"z\": \"0\"", "", "", R"("sizing": {"hmax": 0})"),
                 "a.json: /sizing/hmax: hmax = 0 is outside its range: "},
        BadInput{"SizeNegative", "a.json",
                 patch("\"z\": \"0\"", "", R"(, "sources": [{"everywhere": true, "size": -1}])"),
                 "a.json: /patches/0/sources/0/size: must be above 0"},
        BadInput{"SizeNan", "a.json", R"({"sizing": {"hmax": NaN}})",
                 "a.json:1:21: syntax error while parsing value - invalid literal; last read: "
                 "'\"hmax\": N'"},
        BadInput{"HminAboveHmax", "a.json",
                 patch("\"z\": \"0\"", "", "", R"("sizing": {"hmin": 2, "hmax": 1})"),
                 "a.json: /sizing/hmax: hmin = 2 must not be above hmax = 1"}),
    fact_of);

INSTANTIATE_TEST_SUITE_P(
    Surface, BadInputs,
    ::testing::Values(
        BadInput{"FormulaDoesNotParse", "a.json", formula("2*+u*"),
                 "a.json: /patches/0/surface/z: formula \"2*+u*\", column 6: expected a number, a "
                 "name or '(', found the end"},
        BadInput{
            "UnknownName", "a.json", formula("u+w"),
            "a.json: /patches/0/surface/z: formula \"u+w\", column 3: unknown name 'w'. Names: u v "
            "pi e"},
        BadInput{"UnknownFunction", "a.json", formula("sine(u)"),
                 "a.json: /patches/0/surface/z: formula \"sine(u)\", column 1: unknown function "
                 "'sine', did you mean sin? Functions: abs sign"},
        BadInput{"NamedFormula", "a.json", patch(R"("z": "r", "where": {"r": "1<u<2"})"),
                 "a.json: /patches/0/surface/where/r: formula \"1<u<2\", column 4: comparisons do "
                 "not follow each other: multiply them, (a<b)*(b<c)"},
        BadInput{"ModByZero", "a.json", formula("mod(u,0)"),
                 "a.json: /patches/0: patch p: the position of the surface at (u,v) = (0, 0) is "
                 "not finite: z"},
        BadInput{"NanInTheDomain", "a.json", formula("log(u-0.5)"),
                 "a.json: /patches/0: patch p: the position of the surface at (u,v) = (0, 0) is "
                 "not finite"},
        BadInput{"InfiniteDerivative", "a.json", formula("sqrt(u)"),
                 "a.json: /patches/0: patch p: the position or a derivative of the surface at "
                 "(u,v) = (0, "},
        BadInput{"PoleInTheDomain", "a.json", formula("1/(u-0.3721)"),
                 "a.json: /patches/0: patch p: its surface runs to infinity at (u,v) = (0.3721, "},
        BadInput{"EmptyDomain", "a.json", patch("\"z\": \"0\"", R"("u": [1, 1], "v": [0, 1])"),
                 "a.json: /patches/0/domain/u: the second value must be larger than the first"},
        BadInput{"ReversedDomain", "a.json", patch("\"z\": \"0\"", R"("u": [0, 1], "v": [1, 0])"),
                 "a.json: /patches/0/domain/v: the second value must be larger than the first"},
        BadInput{"Point", "a.json", patch(R"("x": "1", "y": "2", "z": "3")"),
                 "a.json: /patches/0: patch p: its surface is a point, without area"},
        BadInput{"Line", "a.json", patch(R"("x": "u", "y": "u", "z": "u")"),
                 "a.json: /patches/0: patch p: its surface is a line, without area"},
        BadInput{"TooLarge", "a.json", patch("\"z\": \"0\"", R"("u": [0, 1e300], "v": [0, 1])"),
                 "a.json: /patches/0: patch p: its surface is too large: the diagonal of its box "
                 "is inf"}),
    fact_of);

INSTANTIATE_TEST_SUITE_P(
    Loops, BadInputs,
    ::testing::Values(
        BadInput{"DoNotClose", "a.json",
                 patch("\"z\": \"0\"", "", R"(, "loops": [["p:v0", "p:u1", "-p:v1"]])"),
                 "a.json: /patches/0/loops/0: patch p: the loop does not close, the gap between "
                 "the end of p:v1 and the start of p:v0 is 1"},
        BadInput{"CrossThemselves", "a.json",
                 square(R"(, ["-a"])", contour("a", "0.5*cos(t+1)", "0.25*sin(2*t+2)")),
                 "a.json: /patches/0: patch p: loops cross: contours a and a at (u,v) = ("},
        BadInput{"CrossEachOther", "a.json",
                 square(R"(, ["-a"], ["-b"])", contour("a", "0.5*cos(t)", "0.5*sin(t)") + ", " +
                                                   contour("b", "0.3+0.5*cos(t)", "0.5*sin(t)")),
                 "a.json: /patches/0: patch p: loops cross: contours b and a at (u,v) = (0.150003, "
                 "-0.47697)"},
        BadInput{"TouchASide", "a.json",
                 square(R"(, ["-a"])", contour("a", "0.5+0.5*cos(t)", "0.5*sin(t)")),
                 "a.json: /patches/0: patch p: the boundary touches itself at (u,v) = (1, "},
        BadInput{"LeaveTheDomain", "a.json",
                 square(R"(, ["-a"])", contour("a", "0.7+0.5*cos(t)", "0.5*sin(t)")),
                 "a.json: /patches/0/loops/1: patch p: the loop leaves the domain: contour a at t "
                 "= 6.28319, (u,v) = (1.2, -1.22465e-16)"},
        BadInput{"AreAPoint", "a.json", square(R"(, ["-a"])", contour("a", "0.5", "0.5")),
                 "a.json: /patches/0/loops/1: patch p: the loop is a single point in space"},
        BadInput{"AreNotFinite", "a.json", square(R"(, ["-a"])", contour("a", "log(t-1)", "0")),
                 "a.json: /contours/0: contour a: the curve at t = 0 is not finite"}),
    fact_of);

// A warning was lost among others, and the mesh had a crack.
TEST_F(Program, TellsSidesThatNearlyMeetAndWhatJoinsThem) {
  write_text(folder_ / "a.json", R"({"patches": [
      {"name": "p", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}},
      {"name": "q", "surface": {"z": "0"}, "domain": {"u": [1.00001, 2], "v": [0, 1]}}]})");
  EXPECT_EQ(run("mesh a.json -o out.obj --quiet"), 3);
  EXPECT_EQ(err_,
            "surfmesh: not reached: a.json: contours p:u1 and q:u0 are not joined: the gap between "
            "them is 1e-05, more than 2.24e-09; joining = 2e-05 joins them\n");
  EXPECT_EQ(run("mesh a.json -o out.obj --quiet --joining 2e-5"), 0);
  EXPECT_EQ(err_, "");
}

// There were only warnings of flat triangles.
TEST_F(Program, TellsSidesThatAreShiftedAlongEachOtherAndWhatJoinsThem) {
  write_text(folder_ / "a.json", R"({"patches": [
      {"name": "p", "surface": {"z": "0"}, "domain": {"u": [0, 1], "v": [0, 1]}},
      {"name": "q", "surface": {"z": "0"}, "domain": {"u": [1, 2], "v": [1e-6, 1.000001]}}]})");
  EXPECT_EQ(run("mesh a.json -o out.obj --quiet"), 3);
  EXPECT_NE(err_.find("the contour p:u1#0 is left between them; joining = 2e-06 joins them\n"),
            std::string::npos)
      << err_;
  EXPECT_EQ(run("mesh a.json -o out.obj --quiet --joining 2e-6"), 0);
  EXPECT_EQ(err_, "");
}

// Half a millionth at a corner was joined with the side beside it, and the mesh was folded there.
TEST_F(Program, JoinsSidesWholeOrTellsThatTheyAreApart) {
  write_text(folder_ / "a.json", R"({"patches": [
      {"name": "l", "surface": {"z": "0.2*sin(3*u)*v"}, "domain": {"u": [0, 1], "v": [0, 1]}},
      {"name": "r", "surface": {"z": "0.2*sin(3*u)*v+1e-6"},
       "domain": {"u": [1, 2], "v": [0, 1]}}]})");
  for (const std::string joining : {"9e-7", "1e-6"}) {
    EXPECT_EQ(run("mesh a.json -o out.obj --quiet --joining " + joining), 3);
    EXPECT_NE(err_.find("l:u1 and r:u0 are not joined"), std::string::npos) << err_;
    EXPECT_NE(err_.find("joining = 2e-06 joins them\n"), std::string::npos) << err_;
    EXPECT_EQ(err_.find("flat"), std::string::npos) << err_;
  }
  EXPECT_EQ(run("mesh a.json -o out.obj --quiet --joining 2e-6"), 0);
  EXPECT_EQ(err_, "");
}

/// What can be meshed with a sensible reading is meshed, with a warning.
class OddInputs : public Program, public ::testing::WithParamInterface<BadInput> {};

TEST_P(OddInputs, AreMeshedWithAWarning) {
  const BadInput& input = GetParam();
  write_text(folder_ / input.file, input.text);
  EXPECT_EQ(run("mesh " + input.file + " -o out.obj --quiet --hmax 10% --hmin 0.0001%"), 0);
  EXPECT_TRUE(err_.starts_with("surfmesh: warning: " + input.line)) << err_;
  EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out.obj"));
}

INSTANTIATE_TEST_SUITE_P(
    Of, OddInputs,
    ::testing::Values(
        BadInput{"RepeatedVertices", "a.obj", kPoints + "f 1 2 2 3 4\n",
                 "a.obj: face 0 has the same vertex twice in a row; once is taken"},
        BadInput{"UnknownKeywords", "a.obj", kPoints + "f 1 2 3 4\nfoo\n",
                 "a.obj:6: unknown keyword 'foo' is ignored"},
        BadInput{"LinesTooMany", "a.off", kOff + "4 0 1 2 3\n3 0 1 2\n",
                 "a.off:8: the lines after the last face are ignored"},
        BadInput{
            "LoopsThatNearlyMeet", "a.json",
            square(R"(, ["-a"])", contour("a", "0.49999+0.5*cos(t)", "0.5*sin(t)")),
            "a.json: /patches/0: patch p: contours a and p:u1 nearly meet at (u,v) = (0.99999, "},
        BadInput{"LoopsTheWrongWayRound", "a.json",
                 square(R"(, ["a"])", contour("a", "0.5*cos(t)", "0.5*sin(t)")),
                 "a.json: /patches/0/loops/1: patch p: the loop runs the wrong way round; it is "
                 "turned"},
        BadInput{"ContoursThatNoLoopNames", "a.json",
                 square("", contour("a", "0.5*cos(t)", "0.5*sin(t)")),
                 "a.json: /contours/0: contour a: no loop names it, it is left out"}),
    fact_of);

}  // namespace
}  // namespace surfmesh
