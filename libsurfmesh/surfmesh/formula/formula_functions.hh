// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "surfmesh/formula/formula_program.hh"

namespace surfmesh {

/// A function of the formulas.
struct FormulaFunction {
  std::string_view name;
  Operation operation;
  std::string_view arguments = "x";  ///< their names

  std::size_t argument_count() const;
};

/// All functions.
std::span<const FormulaFunction> all_formula_functions();

/// The function of a name, or null.
const FormulaFunction* find_formula_function(std::string_view name);

}  // namespace surfmesh
