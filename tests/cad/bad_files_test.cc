// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "cad/own_shapes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "surfmesh_cad/read_cad.hh"

namespace surfmesh {
namespace {

class BadCadFiles : public ::testing::Test {
 protected:
  /// The error of a file of some text.
  std::string error_of_text(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
    return error_of([&] { read_cad(folder_ / name); });
  }

  std::string text_of(const std::string& shape) const {
    return read_text(write_shape(testing::own_shape(shape), folder_.path()));
  }

  TestFolder folder_;
};

void expect_names(const std::string& error, const std::string& name, const std::string& reason) {
  EXPECT_NE(error.find(name), std::string::npos) << error;
  EXPECT_NE(error.find(reason), std::string::npos) << error;
}

TEST_F(BadCadFiles, AreNamedWhereTheyAreMissing) {
  expect_names(error_of([] { read_cad("nowhere.step"); }), "nowhere.step", "does not exist");
}

TEST_F(BadCadFiles, MayBeFolders) {
  std::filesystem::create_directory(folder_ / "part.step");
  expect_names(error_of([&] { read_cad(folder_ / "part.step"); }), "part.step", "a folder");
}

TEST_F(BadCadFiles, MayBeEmpty) {
  for (const char* name : {"a.step", "a.stp", "a.iges", "a.igs", "a.brep"}) {
    expect_names(error_of_text(name, ""), name, "empty");
  }
}

TEST_F(BadCadFiles, MayBeOfAnotherKind) {
  expect_names(error_of_text("a.step", "v 0 0 0\n"), "a.step", "no STEP file");
  expect_names(error_of_text("a.igs", "v 0 0 0\n"), "a.igs", "no IGES file");
  expect_names(error_of_text("a.brep", "v 0 0 0\n"), "a.brep", "no BREP file");
  expect_names(error_of_text("a.obj", "v 0 0 0\n"), "a.obj", "ending");
}

TEST_F(BadCadFiles, MayBeRandomBytes) {
  std::mt19937 random;
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(random());
  for (const char* name : {"a.step", "a.iges", "a.brep"}) {
    expect_names(error_of_text(name, bytes), name, "invalid input");
  }
}

TEST_F(BadCadFiles, MayBeCutOffAnywhere) {
  for (const char* shape : {"hole", "box_brep", "loose_hole"}) {
    const std::string ending = testing::own_shape(shape).ending;
    const std::string text = text_of(shape);
    for (std::size_t part = 1; part < 40; ++part) {
      const std::string error =
          error_of_text("cut" + ending, text.substr(0, text.size() * part / 40));
      expect_names(error, "cut" + ending, "invalid input");
    }
  }
}

/// Its end is there, but what is before it is not.
TEST_F(BadCadFiles, MayLackTheirMiddle) {
  const std::string text = text_of("hole");
  for (std::size_t part = 5; part < 35; part += 3) {
    const std::string broken =
        text.substr(0, text.size() * part / 40) + "\nENDSEC;\nEND-ISO-10303-21;\n";
    expect_names(error_of_text("broken.step", broken), "broken.step", "which is not in it");
  }
}

/// Entities refer to others of any kind: whatever comes of it, it is no crash.
TEST_F(BadCadFiles, MayReferToTheWrongEntities) {
  const std::string text = text_of("box");
  for (std::size_t at = text.find("(#"); at < text.size(); at = text.find('#', at + 1)) {
    const bool is_defined = text.find('=', at) < text.find_first_of(",)", at);
    if (is_defined) continue;
    const std::size_t end = text.find_first_of(",)", at);
    error_of_text("broken.step", text.substr(0, at) + "#20" + text.substr(end));
  }
}

/// STEP files of a box, damaged in one place.
class DamagedSteps : public BadCadFiles {
 protected:
  /// The error where `before` is replaced, where it first occurs, by `after`.
  std::string error_with(const std::string& before, const std::string& after) {
    std::string text = text_of("box");
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return error_of_text("broken.step", text.replace(at, before.size(), after));
  }

  /// The same, replacing the first entity of that name.
  std::string error_with_entity(const std::string& name, const std::string& entity) {
    const std::string text = text_of("box");
    const std::size_t at = text.find(name + "(");
    EXPECT_NE(at, std::string::npos) << name;
    return error_with(text.substr(at, text.find(';', at) - at), entity);
  }
};

/// OpenCASCADE 7.6 crashes at each of them.
TEST_F(DamagedSteps, MayHaveListsOfNothing) {
  for (const char* entity : {"CLOSED_SHELL('',())", "CONNECTED_FACE_SET('',( ))"}) {
    expect_names(error_with_entity("CLOSED_SHELL", entity), "broken.step", "has an empty list");
  }
  expect_names(error_with_entity("EDGE_LOOP", "EDGE_LOOP('',())"), "EDGE_LOOP", "an empty list");
  expect_names(error_with_entity("EDGE_LOOP", "POLY_LOOP('',(\n))"), "POLY_LOOP", "an empty list");
  expect_names(error_with_entity("DIRECTION", "DIRECTION('',())"), "DIRECTION", "an empty list");
  expect_names(error_with_entity("LINE",
                                 "B_SPLINE_CURVE_WITH_KNOTS('',1,(),.UNSPECIFIED.,.F.,.F.,(),(),"
                                 ".UNSPECIFIED.)"),
               "B_SPLINE_CURVE_WITH_KNOTS", "an empty list");
  expect_names(
      error_with_entity("ADVANCED_BREP_SHAPE_REPRESENTATION", "SHAPE_REPRESENTATION('',(),#15)"),
      "SHAPE_REPRESENTATION", "an empty list");
}

TEST_F(DamagedSteps, MayHaveListsOfCommentsOnly) {
  expect_names(error_with_entity("EDGE_LOOP", "EDGE_LOOP /* of */ ('',( /* none */ ))"),
               "EDGE_LOOP", "an empty list");
}

/// OpenCASCADE takes a face without bounds, and what comes after the end.
TEST_F(DamagedSteps, AreReadWhereThatIsNoFault) {
  const std::string text = text_of("box");
  const std::size_t bounds = text.find("ADVANCED_FACE("), surface = text.find("),#", bounds) + 2;
  const std::string face = text.substr(bounds, text.find(';', bounds) - bounds);
  const std::string without =
      "FACE_SURFACE('',()," + text.substr(surface, text.find(';', bounds) - surface);
  EXPECT_EQ(error_with(face, without).find("list"), std::string::npos);
  EXPECT_EQ(error_of_text("box.step", text + "\n#20 = VERTEX('it''s #21\n" + text), "no error");
}

TEST_F(DamagedSteps, MayHaveVerticesWithoutAPlace) {
  expect_names(error_with_entity("VERTEX_POINT", "VERTEX('')"), "VERTEX", "no place in space");
  expect_names(error_with_entity("CARTESIAN_POINT", "POINT ('')"), "POINT", "no place in space");
}

TEST_F(DamagedSteps, MayDefineAnEntityTwice) {
  expect_names(error_with("ENDSEC;\nEND-ISO", "#20 = DIRECTION('',(1.,0.,0.));\nENDSEC;\nEND-ISO"),
               "broken.step", "#20 is defined twice");
}

/// OpenCASCADE has these numbers as int, and goes on behind a broken statement with fewer entities.
TEST_F(DamagedSteps, MayHaveBrokenNumbers) {
  for (const char* number : {"2147483648", "99999999999999999999"}) {
    const std::string entity =
        fmt::format("#{} = DIRECTION('',(0.,1.));\nENDSEC;\nEND-ISO", number);
    expect_names(error_with("ENDSEC;\nEND-ISO", entity), "broken.step",
                 fmt::format("#{} is too large", number));
  }
  for (const char* number : {"#13 ", "#13 9 ", "#13 /* = */ #14 = "}) {
    expect_names(error_with("#13 = ", number), "broken.step", "#13 has no = behind it");
  }
  EXPECT_EQ(error_with("#13 = ", "#13 /* is */\n=").find("no ="), std::string::npos);
}

/// OpenCASCADE takes a quote that is not before a comma or a parenthesis for a part of a text.
TEST_F(DamagedSteps, MayReferToThemselvesBehindAnOddQuote) {
  const std::string text = text_of("box");
  const std::size_t at = text.find("ORIENTED_EDGE("), number = text.rfind('#', at);
  const std::string self = text.substr(number, text.find(' ', number) - number);
  const std::string whole = text.substr(number, text.find(';', number) - number);
  const std::string damaged = self + " = ORIENTED_EDGE('an edge's name',*,*," + self + ",.F.)";
  expect_names(error_with(whole, damaged), "broken.step", self + " refers to itself");
}

/// OpenCASCADE computes with NaN then: it crashes, or does not come to an end.
TEST_F(BadCadFiles, MayHaveNumbersThatOverflow) {
  const auto error_with = [&](const std::string& shape, const std::string& name,
                              const std::string& before, const std::string& after) {
    std::string text = text_of(shape);
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return error_of_text(name, text.replace(at, before.size(), after));
  };
  for (const char* number : {"1.E300", "-1.5E102", "01.E+999"}) {
    const std::string reason = fmt::format("{} is too large", number);
    expect_names(error_with("box", "a.step", "(0.,0.,1.)", fmt::format("(0.,0.,{})", number)),
                 "a.step", reason);
    expect_names(
        error_with("box_brep", "a.brep", "\n1 0 0 1 0", fmt::format("\n1 0 0 {} 0", number)),
        "a.brep", reason);
    const std::string place = fmt::format("Locations 1\n1\n0 0 0 {}\n0 0 0 0\n0 0 0 0\n", number);
    expect_names(error_with("box_brep", "a.brep", "Locations 0\n", place), "a.brep", reason);
  }
  expect_names(error_with("loose_box", "a.igs", "108,-1.,-0.,", "108,1.D+300,"), "a.igs",
               "line 106: 1.D+300 is too large");
  EXPECT_EQ(error_with("box", "a.step", "DIRECTION('',(0.,0.,1.)", "DIRECTION('',(1.E-999,0.,+1.)"),
            "no error");
}

/// Every number of a BREP file that refers to something is changed.
TEST_F(BadCadFiles, MayReferToNothing) {
  const std::string text = text_of("box_brep");
  const std::size_t shapes = text.find("TShapes");
  for (std::size_t i = shapes; i < text.size(); ++i) {
    if (text[i] < '1' || text[i] > '9') continue;
    std::string broken = text;
    broken[i] = static_cast<char>(text[i] == '9' ? '1' : text[i] + 1);
    error_of_text("broken.brep", broken);
    error_of_text("broken.brep", text.substr(0, i) + "99" + text.substr(i));
  }
}

TEST_F(BadCadFiles, MayHaveAFaceWithoutSurface) {
  std::string text = text_of("box_brep");
  const std::string face = "Fa\n0  1e-07 ";
  const std::size_t at = text.find(face);
  ASSERT_NE(at, std::string::npos);
  text[at + face.size()] = '0';
  write_text(folder_ / "part.brep", text);
  const Model model = read_cad(folder_ / "part.brep");
  EXPECT_EQ(model.patches.size(), 5u);
  ASSERT_FALSE(model.notices.empty());
  expect_names(model.notices.back().text, "part.brep: face 1 of 6", "no surface");
  EXPECT_EQ(model.notices.back().severity, Severity::Shortfall);
}

TEST_F(BadCadFiles, MayHaveAFaceFarAroundItsSurface) {
  std::string text = text_of("torus_part");
  const std::string line = "\n1 1.5707963267948966 -0 0 1";
  const std::size_t at = text.find(line);
  ASSERT_NE(at, std::string::npos);
  write_text(folder_ / "part.brep", text.replace(at, line.size(), "\n1 1e13 -0 0 1"));
  const Model model = read_cad(folder_ / "part.brep");
  EXPECT_EQ(model.patches.size(), 2u);
  ASSERT_FALSE(model.notices.empty());
  expect_names(model.notices.front().text, "part.brep: face 1 of 3",
               "it is 1.59e+12 turns away from the start of its surface");
  EXPECT_EQ(model.notices.front().severity, Severity::Shortfall);
}

TEST_F(BadCadFiles, MayHaveNoFaces) {
  for (const char* ending : {".brep", ".step"}) {
    const auto path = folder_ / (std::string("wires") + ending);
    testing::write_wires(path);
    expect_names(error_of([&] { read_cad(path); }), "wires", "no faces");
  }
  testing::write_empty(folder_ / "empty.brep");
  expect_names(error_of([&] { read_cad(folder_ / "empty.brep"); }), "empty.brep", "no faces");
}

TEST_F(BadCadFiles, MayBeTooLarge) {
  write_text(folder_ / "large.step", "ISO-10303-21;");
  std::filesystem::resize_file(folder_ / "large.step", 1ull << 30);
  expect_names(error_of([&] { read_cad(folder_ / "large.step"); }), "limit", "1024 MB");
}

}  // namespace
}  // namespace surfmesh
