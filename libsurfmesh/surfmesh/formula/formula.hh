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

/// All functions of formulas in one line: "sqrt cbrt ... atan2(y,x) ... if(condition,a,b)". Those
/// without parentheses have one argument.
std::string formula_functions();

/// Why a constant or a formula must not have this name: it is none, or one that has a meaning in
/// all formulas (functions, pi, e, u, v, t); empty if it may. A name begins with a letter or _,
/// followed by letters, digits and _.
std::string_view formula_name_fault(std::string_view name);

/// A formula that others use by its name.
struct NamedFormula {
  std::string name;
  std::string text;
};

/// Reads formulas of the same variables into one program, which computes common parts only once.
///
/// Numbers, pi (or PI), e, the variables, constants and named formulas; + - * / ^ (or **),
/// comparisons and parentheses. `^` binds from the right and before a leading minus: -2^2 is -4,
/// 2^3^2 is 512. Comparisons (< <= > >= == !=) bind last and are 1 or 0. The functions are those of
/// formula_functions(): angles are in radians; log and ln are the same; step(edge,x) is 1 from the
/// edge on, else 0; mod(x,y) lies from 0 to y; if(condition,a,b) is b where the condition is 0,
/// else a. A constant named PI or E is just that.
///
/// Derivatives are exact. Those of steps are 0, also at the jump; those of `if` are those of the
/// chosen operand.
class FormulaReader {
 public:
  /// Throws   InvalidInput for more variables than kMaxFormulaVariables; for a constant whose name
  ///          is in use or is not a name, or whose value is not finite
  explicit FormulaReader(const std::vector<std::string>& variables,
                         const std::map<std::string, double>& constants = {});

  /// Let the formulas read from here on use `text` by its name.
  /// Throws   as read, and InvalidInput if the name is in use or is not a name
  void define(const std::string& name, std::string_view text);

  /// Read a formula. The result stands for it in finish().
  /// Throws   InvalidInput for the text, with the column, what was expected and found there, and
  ///          for an unknown name what was probably meant and which there are
  int read(std::string_view text);

  /// The program of these formulas.
  /// Throws   as FormulaBuilder::finish
  FormulaProgram finish(const std::vector<int>& formulas) const;

 private:
  std::string_view name_fault(const std::string& name) const;

  std::vector<std::string> variables_;
  std::map<std::string, double> constants_;
  std::map<std::string, int> named_;
  FormulaBuilder builder_;
};

/// Read a formula.
/// Throws   InvalidInput as FormulaReader
Formula parse_formula(std::string_view text, const std::vector<std::string>& variables,
                      const std::map<std::string, double>& constants = {});

/// Read several formulas of the same variables into one program, which may use the formulas of
/// `where`; each of those may use the ones before it.
/// Throws   InvalidInput as FormulaReader; for `where`, after the name
FormulaProgram parse_formulas(std::span<const std::string> texts,
                              const std::vector<std::string>& variables,
                              const std::map<std::string, double>& constants = {},
                              std::span<const NamedFormula> where = {});

/// The value of a formula without variables.
/// Throws   InvalidInput as parse_formula, and if the value is not finite
double evaluate_constant(std::string_view text,
                         const std::map<std::string, double>& constants = {});

}  // namespace surfmesh
