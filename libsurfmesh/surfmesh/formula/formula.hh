// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/formula/formula_program.hh"
#include "surfmesh/geometry/jet_number.hh"

namespace surfmesh {

/// A formula of some variables, with exact derivatives with respect to the first two.
///
/// Immutable; may be evaluated from several threads at once. Where the formula is not defined,
/// results may not be finite; the caller must deal with that.
class Formula {
 public:
  /// Evaluate a formula of one or two variables with derivatives up to `order` (0, 1, 2); for one
  /// variable the derivatives with respect to v are 0.
  template <int order>
  JetNumber<order> evaluate(double u, double v = 0) const;

  /// Evaluate a formula of any number of variables, whose values are given in their order.
  /// Pre      as many values as the formula has variables
  double evaluate(std::span<const double> variables) const;

  /// True if the formula does not depend on its variables.
  bool is_constant() const;

 private:
  friend Formula parse_formula(std::string_view, const std::vector<std::string>&,
                               const std::map<std::string, double>&);

  explicit Formula(FormulaProgram program) : program_(std::move(program)) {}

  FormulaProgram program_;
};

/// Greatest nesting of parentheses, functions, signs and powers in a formula.
inline constexpr int kMaxFormulaDepth = 200;
/// Greatest number of variables of a formula.
inline constexpr std::size_t kMaxFormulaVariables = 16;

/// Read a formula.
///
/// Numbers, pi, e, the variables and constants by name, + - * / ^ and parentheses; `^` binds from
/// the right and before a leading minus: -2^2 is -4, 2^3^2 is 512. Functions: sqrt cbrt exp log
/// sin cos tan asin acos atan sinh cosh tanh abs of one argument, atan2 min max pow hypot of two.
/// Angles are in radians.
///
/// Throws   InvalidInput: for the text, with the column and what was expected and found there; for
///          a constant whose name is in use (pi, e, u, v, t, variables, functions) or is not a
///          name, or whose value is not finite
Formula parse_formula(std::string_view text, const std::vector<std::string>& variables,
                      const std::map<std::string, double>& constants = {});

/// Read several formulas of the same variables into one program, which computes common parts only
/// once.
/// Throws   as parse_formula
FormulaProgram parse_formulas(std::span<const std::string> texts,
                              const std::vector<std::string>& variables,
                              const std::map<std::string, double>& constants = {});

/// The value of a formula without variables.
/// Throws   InvalidInput as parse_formula, and if the value is not finite
double evaluate_constant(std::string_view text,
                         const std::map<std::string, double>& constants = {});

}  // namespace surfmesh
