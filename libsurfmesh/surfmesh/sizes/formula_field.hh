// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// u, v, x, y, z: parameters and position.
const std::vector<std::string>& formula_field_variables();

/// A field of one size from a formula of u, v, x, y, z, with bounds: those of bound(), or where it
/// reads something twice, of bound_by_slopes(). It may use the formulas of `where`. Its patch is
/// unset.
/// Throws   as parse_formula
FieldSource formula_field(const std::string& size,
                          const std::map<std::string, double>& constants = {},
                          std::span<const NamedFormula> where = {});

/// A field of metrics from the formulas of m11, m12, m22, with bounds likewise.
/// Throws   as parse_formula
FieldSource formula_field(const std::array<std::string, 3>& metric,
                          const std::map<std::string, double>& constants = {},
                          std::span<const NamedFormula> where = {});

}  // namespace surfmesh
