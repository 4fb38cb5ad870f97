// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "surfmesh/geometry/jet_number.hh"

namespace surfmesh {

/// What one instruction of a formula program computes from its operands a, b, d and its constant c.
/// Comparisons give 1 or 0.
enum class Operation : unsigned char {
  Constant,  ///< c
  Negate,
  Add,
  Subtract,
  Multiply,
  Divide,
  AddConstant,       ///< a + c
  SubtractFrom,      ///< c − a
  Scale,             ///< c a
  DivideByConstant,  ///< a / c
  DivideConstant,    ///< c / a
  Square,
  PowerOf,    ///< a to the constant power c
  PowerBase,  ///< c to the power a
  Power,      ///< a to the power b
  Sqrt,
  Cbrt,
  Exp,
  Log,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Atan2,
  Sinh,
  Cosh,
  Tanh,
  Abs,
  Min,
  Max,
  Hypot,
  Log10,
  Sign,
  Floor,
  Ceil,
  Mod,        ///< a − b floor(a/b)
  Less,       ///< a < b
  LessEqual,  ///< a ≤ b
  Equal,      ///< a = b
  Select      ///< b if a is not 0, else d
};

/// How many of its operands an operation reads: 0 to 3.
std::size_t operand_count(Operation operation);

/// One step of a program; instruction i writes register (variable count + i).
struct Instruction {
  Operation operation = Operation::Constant;
  std::array<int, 3> operand = {0, 0, 0};  ///< registers; those that are not read are 0
  double constant = 0;

  /// The operands that are read.
  std::span<const int> operands() const { return {operand.data(), operand_count(operation)}; }

  /// An order of all instructions; constants by their bits, so that NaN and −0 are ordered, too.
  friend bool operator<(const Instruction& x, const Instruction& y);
};

/// Formulas as a list of instructions without jumps, each result computed once.
///
/// Evaluation is const, allocates nothing and may run in several threads at once.
class FormulaProgram {
 public:
  /// Registers of an evaluation, which are on the stack: 48 bytes each at order 2.
  static constexpr std::size_t kMaxRegisters = 1024;

  /// Evaluate all formulas. Variables that carry derivatives give results that do.
  /// Cost     about 4 ns for an arithmetic operation, 10 to 20 ns for sin or exp, at any order
  /// Pre      as many variables and results as the program has
  template <int order>
  void evaluate(std::span<const JetNumber<order>> variables,
                std::span<JetNumber<order>> results) const;

  std::size_t variable_count() const { return variable_count_; }
  std::size_t result_count() const { return results_.size(); }
  const std::vector<Instruction>& instructions() const { return instructions_; }

  /// The registers of the results.
  const std::vector<int>& results() const { return results_; }

  /// True if a result may depend on this variable.
  bool uses(std::size_t variable) const;

  /// True if no variable and no instruction is read by more than one operand.
  bool reads_each_once() const;

 private:
  friend class FormulaBuilder;

  std::size_t variable_count_ = 0;
  std::vector<Instruction> instructions_;
  std::vector<int> results_;  // registers
};

/// Collects the operations of formulas. A node is identified by its index; the variables come
/// first.
///
/// Constants are folded and equal operations on equal operands become one node.
class FormulaBuilder {
 public:
  explicit FormulaBuilder(std::size_t variable_count)
      : variable_count_(static_cast<int>(variable_count)) {}

  int constant(double value) { return append({Operation::Constant, {}, value}); }

  /// The result of an operation: Negate to Divide, Power, a comparison or a function. The forms
  /// with a constant are chosen by the builder.
  int apply(Operation operation, int a, int b = 0, int d = 0);

  /// The program that computes the nodes `results`, without the nodes that these do not use.
  /// Throws   InvalidInput if it needs more than FormulaProgram::kMaxRegisters
  FormulaProgram finish(const std::vector<int>& results) const;

 private:
  std::optional<double> constant_of(int node) const;
  std::vector<char> used_nodes(const std::vector<int>& results) const;
  int append(const Instruction& instruction);
  int select(int condition, int a, int b);
  int apply_with_constant(Operation operation, int a, int b);

  int variable_count_;
  std::vector<Instruction> nodes_;
  std::map<Instruction, int> known_;
};

}  // namespace surfmesh
