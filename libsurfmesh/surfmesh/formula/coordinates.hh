// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/formula/formula.hh"

namespace surfmesh {

/// A coordinate and its formula.
struct Coordinate {
  std::string_view name;
  const std::string& text;
};

/// Let the reader know the formulas of `where`.
/// Throws   as FormulaReader::define, after the name
void define_all(std::span<const NamedFormula> where, FormulaReader& reader);

/// Read the formulas of coordinates into one program; those of `where` may be used by their names.
/// Throws   InvalidInput as FormulaReader, after the name of the coordinate or of the formula
FormulaProgram read_coordinates(const std::vector<Coordinate>& coordinates,
                                const std::vector<std::string>& variables,
                                const std::map<std::string, double>& constants,
                                std::span<const NamedFormula> where);

}  // namespace surfmesh
