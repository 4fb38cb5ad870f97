// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_curve.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

const std::vector<std::string> kParameters = {"t"};

struct Coordinate {
  char name;
  std::string text;
};

/// All in one program; first one by one, so that an error can name the coordinate.
template <std::size_t count>
FormulaProgram read(const std::array<Coordinate, count>& coordinates, const CurveRange& range,
                    const std::map<std::string, double>& constants) {
  if (!std::isfinite(range.from) || !std::isfinite(range.to) || !(range.from < range.to)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("the range from {} to {} is empty or not finite", range.from, range.to));
  }
  parse_formulas({}, kParameters, constants);
  std::array<std::string, count> texts;
  for (std::size_t i = 0; i < count; ++i) {
    texts[i] = coordinates[i].text;
    try {
      parse_formula(texts[i], kParameters, constants);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("{}: {}", coordinates[i].name, error.what()));
    }
  }
  return parse_formulas(texts, kParameters, constants);
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
      program_(read(std::array{Coordinate{'u', formulas.u}, Coordinate{'v', formulas.v}}, range,
                    constants)) {}

Uv FormulaCurve::evaluate(double t) const {
  const auto [u, v] = values<2>(program_, range_.at(t));
  return {u, v};
}

FormulaSpaceCurve::FormulaSpaceCurve(const SpaceCurveFormulas& formulas, const CurveRange& range,
                                     const std::map<std::string, double>& constants)
    : range_(range),
      program_(read(std::array{Coordinate{'x', formulas.x}, Coordinate{'y', formulas.y},
                               Coordinate{'z', formulas.z}},
                    range, constants)) {}

Vec3 FormulaSpaceCurve::evaluate(double t) const {
  const auto [x, y, z] = values<3>(program_, range_.at(t));
  return {x, y, z};
}

}  // namespace surfmesh
