// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_curve.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/errors.hh"

namespace surfmesh {
namespace {

TEST(FormulaCurve, RunsThroughItsRange) {
  const FormulaCurve curve({"a*t", "t^2"}, {2, 4}, {{"a", 3}});
  EXPECT_EQ(curve.evaluate(0), (Uv{6, 4}));
  EXPECT_EQ(curve.evaluate(0.5), (Uv{9, 9}));
  EXPECT_EQ(curve.evaluate(1), (Uv{12, 16}));
}

TEST(FormulaSpaceCurve, RunsThroughItsRange) {
  const FormulaSpaceCurve curve({"cos(t)", "sin(t)", "t"}, {0, 2});
  EXPECT_EQ(curve.evaluate(0.5), Vec3(std::cos(1.0), std::sin(1.0), 1));
}

TEST(FormulaCurve, NamesTheCoordinateOfABadFormula) {
  const std::string error = error_of([] { FormulaCurve({"t", "u+1"}, {0, 1}); });
  EXPECT_TRUE(error.starts_with("invalid input: v: ")) << error;
}

TEST(FormulaCurve, RefusesAnEmptyRange) {
  EXPECT_EQ(error_of([] {
              FormulaCurve({"t", "t"}, {1, 1});
            }),
            "invalid input: the range from 1 to 1 is empty or not finite");
}

TEST(FormulaCurve, TellsWhereItIsNotFinite) {
  const FormulaCurve curve({"1/t", "t"}, {-1, 1});
  EXPECT_EQ(error_of([&] { curve.evaluate(0.5); }), "geometry: the curve at t = 0 is not finite");
}

}  // namespace
}  // namespace surfmesh
