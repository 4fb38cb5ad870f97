// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/critical_value.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

using std::numbers::pi;

/// The distance to the integer nearest to the middle: it holds 0 if the interval has an integer.
Interval beyond_integer(const Interval& x) {
  const double nearest = std::round(x.middle());
  return std::isfinite(nearest) ? x - Interval::of(nearest) : Interval{};
}

bool is_comparison(Operation operation) {
  return operation == Operation::Less || operation == Operation::LessEqual ||
         operation == Operation::Equal;
}

/// True if a condition is no comparison itself, which would jump before it.
bool is_plain_condition(const FormulaProgram& program, int condition) {
  const std::size_t index = static_cast<std::size_t>(condition);
  if (index < program.variable_count()) return true;
  const Instruction& step = program.instructions()[index - program.variable_count()];
  return !is_comparison(step.operation);
}

/// Of operations whose bounds alone decide.
Interval value_of(const Instruction& step, const Interval& a, const Interval& b) {
  switch (step.operation) {
    case Operation::Divide:
      return b;
    case Operation::Less:
    case Operation::LessEqual:
      return a - b;
    case Operation::Floor:
    case Operation::Ceil:
      return beyond_integer(a);
    case Operation::Mod:
      return beyond_integer(a / b);
    case Operation::Tan:
      return beyond_integer((a - Interval::of(pi / 2)) / Interval::of(pi));
    default:
      return a;
  }
}

}  // namespace

bool may_be_infinite(const Instruction& step) {
  switch (step.operation) {
    case Operation::Divide:
    case Operation::DivideConstant:
    case Operation::Power:
    case Operation::Log:
    case Operation::Log10:
    case Operation::Tan:
      return true;
    case Operation::PowerOf:
      return step.constant < 0;
    default:
      return false;
  }
}

bool may_break(const FormulaProgram& program, const Instruction& step) {
  switch (step.operation) {
    case Operation::Less:
    case Operation::LessEqual:
    case Operation::Floor:
    case Operation::Ceil:
    case Operation::Mod:
    case Operation::Sign:
    case Operation::Atan2:
      return true;
    case Operation::Select:
      return is_plain_condition(program, step.operand[0]);
    default:
      return may_be_infinite(step);
  }
}

bool may_break(const FormulaProgram& program) {
  return std::ranges::any_of(program.instructions(),
                             [&](const Instruction& step) { return may_break(program, step); });
}

std::optional<Interval> critical_value(const Instruction& step,
                                       std::span<const Interval> registers) {
  const Interval a = registers[static_cast<std::size_t>(step.operand[0])];
  const Interval b = registers[static_cast<std::size_t>(step.operand[1])];
  // Atan2 has its cut where x ≤ 0; x^y is finite where y > 0.
  const bool is_limited = step.operation == Operation::Atan2 || step.operation == Operation::Power;
  if (is_limited && b.lower > 0) return {};
  const Interval value = value_of(step, a, b);
  if (!value.contains(0) || value.width() == 0) return {};
  return value;
}

}  // namespace surfmesh
