// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/coordinates.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Call `read`, and put a name in front of its errors.
template <class Read>
auto under_name(std::string_view name, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace

void define_all(std::span<const NamedFormula> where, FormulaReader& reader) {
  for (const auto& [name, text] : where) {
    under_name(name, [&, &name = name, &text = text] { reader.define(name, text); });
  }
}

FormulaProgram read_coordinates(const std::vector<Coordinate>& coordinates,
                                const std::vector<std::string>& variables,
                                const std::map<std::string, double>& constants,
                                std::span<const NamedFormula> where) {
  FormulaReader reader(variables, constants);
  define_all(where, reader);
  std::vector<int> formulas;
  for (const Coordinate& coordinate : coordinates) {
    formulas.push_back(under_name(coordinate.name, [&] { return reader.read(coordinate.text); }));
  }
  return reader.finish(formulas);
}

}  // namespace surfmesh
