// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_slopes.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "surfmesh/formula/formula_bounds.hh"
#include "surfmesh/formula/jump_bounds.hh"

namespace surfmesh {
namespace {

/// Error of one operation as a share of its result, once at the middle and once elsewhere.
constexpr double kSlopeRounding = 8 * std::numeric_limits<double>::epsilon();

constexpr Interval kOne = {1, 1};
constexpr Interval kZero = {0, 0};

/// The slopes of an operation with respect to its operands; none if it does not depend on one.
struct Slopes {
  std::optional<Interval> a = {};
  std::optional<Interval> b = {};
  std::optional<Interval> d = {};
};

/// What a slope may be that has become 0 by its size.
constexpr Interval kUnderflow = {-std::numeric_limits<double>::min(),
                                 std::numeric_limits<double>::min()};

Interval of(Operation operation, const Interval& a) { return bound_operation({operation}, a, a); }

Interval power(const Interval& a, double c) {
  if (c == 1) return a;
  return bound_operation({Operation::PowerOf, {}, c}, a, a);
}

Interval scaled(const Interval& a, double c) { return a * Interval::of(c); }

Interval within(const Interval& a, double lower, double upper) {
  return {std::clamp(a.lower, lower, upper), std::clamp(a.upper, lower, upper)};
}

/// Where |a| has no slope, it lies between those beside.
Interval slope_of_abs(const Interval& a) {
  return {a.lower > 0 ? 1.0 : -1.0, a.upper < 0 ? -1.0 : 1.0};
}

/// Of the lesser of two operands: 1 for the one that is always chosen, else between 0 and 1.
Slopes slopes_of_minimum(const Interval& a, const Interval& b) {
  if (a.upper < b.lower) return {kOne, {}};
  if (b.upper < a.lower) return {{}, kOne};
  return {Interval{0, 1}, Interval{0, 1}};
}

/// An angle jumps at the cut, so there it has no slope.
Slopes slopes_of_angle(const Interval& y, const Interval& x) {
  if (x.lower <= 0 && y.contains(0)) return {Interval{}, Interval{}};
  const Interval squares = square(x) + square(y);
  return {x / squares, -y / squares};
}

/// Powers of negative numbers are not continuous in the exponent.
Slopes slopes_of_power(const Interval& a, const Interval& b, const Interval& result) {
  if (!(a.lower > 0)) return {Interval{}, Interval{}};
  return {b * result / a, result * of(Operation::Log, a)};
}

/// Across a jump there is no slope; else the slopes are those of a − b times a whole number.
Slopes slopes_of_mod(const Interval& a, const Interval& b) {
  const auto periods = whole_periods(a, b);
  if (!periods) return {Interval{}, Interval{}};
  return {kOne, Interval::of(-*periods)};
}

/// Of the operand that is always chosen, if there is one.
Slopes slopes_of_select(const Interval& condition) {
  if (!condition.contains(0)) return {{}, kOne, {}};
  if (condition == kZero) return {{}, {}, kOne};
  return {Interval{}, Interval{}, Interval{}};
}

/// Steps are constant or jump.
Slopes slopes_of_step(const Interval& result) {
  if (result.lower == result.upper) return {};
  return {Interval{}, Interval{}};
}

Slopes slopes_of_function(const Instruction& step, const Interval& a, const Interval& b,
                          const Interval& result) {
  switch (step.operation) {
    case Operation::PowerOf:
      return {scaled(power(a, step.constant - 1), step.constant)};
    case Operation::PowerBase:
      if (!(step.constant > 0)) return {Interval{}};
      return {scaled(result, std::log(step.constant))};
    case Operation::Power:
      return slopes_of_power(a, b, result);
    case Operation::Sqrt:
      return {Interval::of(0.5) / result};
    case Operation::Cbrt:
      return {kOne / scaled(square(result), 3)};
    case Operation::Exp:
      return {result};
    case Operation::Log:
      return {kOne / a};
    case Operation::Sin:
      return {of(Operation::Cos, a)};
    case Operation::Cos:
      return {-of(Operation::Sin, a)};
    case Operation::Tan:
      return {kOne + square(result)};
    case Operation::Asin:
      return {kOne / sqrt(kOne - square(a))};
    case Operation::Acos:
      return {-(kOne / sqrt(kOne - square(a)))};
    case Operation::Atan:
      return {kOne / (kOne + square(a))};
    case Operation::Atan2:
      return slopes_of_angle(a, b);
    case Operation::Sinh:
      return {of(Operation::Cosh, a)};
    case Operation::Cosh:
      return {of(Operation::Sinh, a)};
    case Operation::Tanh:
      return {kOne - square(result)};
    case Operation::Hypot:
      return {within(a / result, -1, 1), within(b / result, -1, 1)};
    case Operation::Log10:
      return {kOne / scaled(a, std::numbers::ln10)};
    case Operation::Mod:
      return slopes_of_mod(a, b);
    case Operation::Select:
      return slopes_of_select(a);
    default:
      return slopes_of_step(result);
  }
}

Slopes slopes_of(const Instruction& step, const Interval& a, const Interval& b,
                 const Interval& result) {
  switch (step.operation) {
    case Operation::Constant:
      return {};
    case Operation::Negate:
    case Operation::SubtractFrom:
      return {-kOne};
    case Operation::Add:
      return {kOne, kOne};
    case Operation::Subtract:
      return {kOne, -kOne};
    case Operation::Multiply:
      return {b, a};
    case Operation::Divide:
      return {kOne / b, -(result / b)};
    case Operation::AddConstant:
      return {kOne};
    case Operation::Scale:
      return {Interval::of(step.constant)};
    case Operation::DivideByConstant:
      return {kOne / Interval::of(step.constant)};
    case Operation::DivideConstant:
      return {-(result / a)};
    case Operation::Square:
      return {scaled(a, 2)};
    case Operation::Abs:
      return {slope_of_abs(a)};
    case Operation::Min:
      return slopes_of_minimum(a, b);
    case Operation::Max: {
      const Slopes minimum = slopes_of_minimum(a, b);
      return {minimum.b, minimum.a};
    }
    default:
      return slopes_of_function(step, a, b, result);
  }
}

/// The slopes of one result with respect to all registers, from the last one backwards.
class SlopesOfResult {
 public:
  SlopesOfResult(const FormulaProgram& program, std::span<const Interval> registers)
      : program_(program), registers_(registers), slopes_(registers.size(), kZero) {}

  /// How far the result may be from its value in the middle, with all roundings.
  Interval difference(int result, std::span<const Interval> variables);

 private:
  void step_back(std::size_t instruction);
  const Interval& at(int i) const { return registers_[static_cast<std::size_t>(i)]; }

  const FormulaProgram& program_;
  std::span<const Interval> registers_;
  std::vector<Interval> slopes_;
  double rounding_ = 0;
};

void SlopesOfResult::step_back(std::size_t instruction) {
  const std::size_t index = program_.variable_count() + instruction;
  const Interval slope = slopes_[index];
  if (slope == kZero) return;
  rounding_ += kSlopeRounding * abs(slope).upper * abs(registers_[index]).upper;
  const Instruction& step = program_.instructions()[instruction];
  const auto [a, b, d] = step.operand;
  const Slopes own = slopes_of(step, at(a), at(b), registers_[index]);
  const auto add = [&](int operand, const std::optional<Interval>& x) {
    if (!x) return;
    Interval& sum = slopes_[static_cast<std::size_t>(operand)];
    sum = sum + (slope * (*x + kUnderflow) + kUnderflow);
  };
  add(a, own.a);
  add(b, own.b);
  add(d, own.d);
}

Interval SlopesOfResult::difference(int result, std::span<const Interval> variables) {
  slopes_[static_cast<std::size_t>(result)] = kOne;
  rounding_ = kSlopeRounding * abs(registers_[static_cast<std::size_t>(result)]).upper;
  for (std::size_t i = program_.instructions().size(); i-- > 0;) step_back(i);
  Interval sum = kZero;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (slopes_[i] == kZero) continue;
    const Interval middle = Interval::of(variables[i].middle());
    sum = sum + slopes_[i] * (variables[i] - middle);
    rounding_ += kSlopeRounding * abs(slopes_[i]).upper * abs(variables[i]).upper;
  }
  return sum + Interval{-rounding_, rounding_} + kUnderflow;
}

}  // namespace

void bound_by_slopes(const FormulaProgram& program, std::span<const Interval> variables,
                     std::span<Interval> results) {
  std::vector<Interval> registers(program.variable_count() + program.instructions().size());
  bound_registers(program, variables, registers);
  std::vector<Interval> middle(variables.size()), values(results.size());
  std::ranges::transform(variables, middle.begin(),
                         [](const Interval& x) { return defined(Interval::of(x.middle())); });
  bound(program, middle, values);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const int index = program.results()[i];
    const Interval simple = registers[static_cast<std::size_t>(index)];
    const Interval by_slopes =
        values[i] + SlopesOfResult(program, registers).difference(index, variables);
    // Both hold what is defined, if anything is.
    results[i] = {std::max(simple.lower, by_slopes.lower), std::min(simple.upper, by_slopes.upper)};
    if (!(results[i].lower <= results[i].upper)) results[i] = simple;
  }
}

}  // namespace surfmesh
