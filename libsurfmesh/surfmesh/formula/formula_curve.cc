// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_curve.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/coordinates.hh"

namespace surfmesh {
namespace {

const std::vector<std::string> kParameters = {"t"};

FormulaProgram read(const std::vector<Coordinate>& coordinates, const CurveRange& range,
                    const std::map<std::string, double>& constants,
                    const std::vector<NamedFormula>& where) {
  if (!std::isfinite(range.from) || !std::isfinite(range.to) || !(range.from < range.to)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("the range from {} to {} is empty or not finite", range.from, range.to));
  }
  return read_coordinates(coordinates, kParameters, constants, where);
}

template <std::size_t count>
std::array<double, count> values(const FormulaProgram& program, double t) {
  const std::array variables = {JetNumber<0>(t)};
  std::array<JetNumber<0>, count> results;
  program.evaluate<0>(variables, results);
  std::array<double, count> result{};
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = results[i].value();
    if (std::isfinite(result[i])) continue;
    throw Error(ErrorCode::Geometry, fmt::format("the curve at t = {} is not finite", t));
  }
  return result;
}

}  // namespace

FormulaCurve::FormulaCurve(const CurveFormulas& formulas, const CurveRange& range,
                           const std::map<std::string, double>& constants)
    : range_(range),
      program_(read({{"u", formulas.u}, {"v", formulas.v}}, range, constants, formulas.where)) {}

Uv FormulaCurve::evaluate(double t) const {
  const auto [u, v] = values<2>(program_, range_.at(t));
  return {u, v};
}

FormulaSpaceCurve::FormulaSpaceCurve(const SpaceCurveFormulas& formulas, const CurveRange& range,
                                     const std::map<std::string, double>& constants)
    : range_(range),
      program_(read({{"x", formulas.x}, {"y", formulas.y}, {"z", formulas.z}}, range, constants,
                    formulas.where)) {}

Vec3 FormulaSpaceCurve::evaluate(double t) const {
  const auto [x, y, z] = values<3>(program_, range_.at(t));
  return {x, y, z};
}

}  // namespace surfmesh
