// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/errors.hh"
#include "surfmesh_cad/cad_number.hh"
#include "surfmesh_cad/iges_text.hh"
#include "surfmesh_cad/step_text.hh"

namespace surfmesh {
namespace {

TEST(CadNumber, IsANumberAsAWhole) {
  EXPECT_EQ(cad_number("-1.5E2"), -150);
  EXPECT_EQ(cad_number("+3."), 3);
  EXPECT_EQ(cad_number(".5e+1"), 5);
  EXPECT_EQ(cad_number("1e-320999"), 0);
  EXPECT_EQ(cad_number("0." + std::string(400, '0') + "1E10"), 0);
  EXPECT_TRUE(std::isinf(*cad_number("1E999")));
  EXPECT_TRUE(std::isinf(*cad_number(std::string(400, '9') + "E-5")));
  for (const char* text :
       {"", "+", "-", ".", "inf", "nan", "-inf", "1.2.3", "1E", "12H", "0x1p9"}) {
    EXPECT_FALSE(cad_number(text)) << text;
  }
}

TEST(CadNumber, MayBeTheInfinityOfOpenCascade) {
  EXPECT_FALSE(is_too_large(2e100));
  EXPECT_FALSE(is_too_large(-2e100));
  EXPECT_TRUE(is_too_large(1e102));
  EXPECT_TRUE(is_too_large(-1e102));
}

/// A line of a section; columns that are not given are blank.
std::string iges_line(std::string values, char section) {
  values.resize(72, ' ');
  return values + section + "      1";
}

std::string error_of_iges(const std::string& text) {
  return error_of([&] { check_iges_text(text); });
}

TEST(IgesText, HasNumbersInItsValuesOnly) {
  for (const char* values :
       {"406,1,19HBRACKET 12E345 REV.B,0;", "110,1.,2E100,3.;1E300 is a comment",
        "406,2,12H1E300,2E300,,5H,E9,;;", "110,1.E-300,1.D-999;"}) {
    EXPECT_EQ(error_of_iges(iges_line(values, 'P')), "no error") << values;
  }
  EXPECT_EQ(error_of_iges(iges_line("start 1E300, 1E300;", 'S')), "no error");
}

/// A text of 70 characters, of which the last six stand in the next line.
TEST(IgesText, HasTextsOverSeveralLines) {
  const std::string begin = "406,1,70H" + std::string(55, 'x');
  const std::string end = std::string(8, 'x') + "7E104, ;";
  ASSERT_EQ(begin.size(), 64u);
  const std::string first = iges_line(begin, 'P') + "\n";
  EXPECT_EQ(error_of_iges(first + iges_line(end, 'P')), "no error");
  EXPECT_EQ(error_of_iges(first + iges_line(end.substr(0, 15) + ",7E104;", 'P')),
            "invalid input: the IGES file is damaged: line 2: 7E104 is too large");
}

TEST(IgesText, HasLinesThatEndInAnyWay) {
  for (const char* end : {"\n", "\r", "\r\n"}) {
    const std::string text = iges_line("", 'S') + end + iges_line("110,0.,1.d300;", 'P') + end;
    EXPECT_EQ(error_of_iges(text),
              "invalid input: the IGES file is damaged: line 2: 1.d300 is too large");
  }
}

TEST(IgesText, ChoosesItsDelimiters) {
  const std::string global = iges_line("1H||1H!|4Hpart", 'G') + "\n";
  EXPECT_EQ(error_of_iges(global + iges_line("110|0.|1.E300!", 'P')),
            "invalid input: the IGES file is damaged: line 2: 1.E300 is too large");
  EXPECT_EQ(error_of_iges(global + iges_line("110|0.|1.!1.E300|", 'P')), "no error");
}

std::string error_of_step(const std::string& value) {
  return error_of([&] { check_step_text("#1 = DIRECTION('',(" + value + "));\n"); });
}

TEST(StepText, HasNumbersOfAnySizeOnlyInTexts) {
  for (const char* value : {"'1.E300'", "\"21E9999\"", ".E300.", "1.E-300", "+2.E100,-2.E100"}) {
    EXPECT_EQ(error_of_step(value), "no error") << value;
  }
  for (const char* value : {"1.E300", "0.,-1.E300", "1.E300-5", "\"1.E300"}) {
    EXPECT_NE(error_of_step(value).find("#1: "), std::string::npos) << value;
    EXPECT_NE(error_of_step(value).find("1.E300 is too large"), std::string::npos) << value;
  }
}

/// To look for the end of the run at each point of it would take hours.
TEST(StepText, MayHaveMillionsOfPoints) {
  EXPECT_EQ(error_of_step(std::string(4'000'000, '.')), "no error");
}

}  // namespace
}  // namespace surfmesh
