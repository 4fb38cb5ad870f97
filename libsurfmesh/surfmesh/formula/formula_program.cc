// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_program.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/formula/floored_mod.hh"

namespace surfmesh {
namespace {

bool is_commutative(Operation operation) {
  return operation == Operation::Add || operation == Operation::Multiply ||
         operation == Operation::Equal;
}

/// Steps have no derivatives but 0; what is not a number is never hidden.
template <int order>
JetNumber<order> sign(const JetNumber<order>& x) {
  return x.value() > 0 ? 1.0 : x.value() < 0 ? -1.0 : 0 * x.value();
}

template <int order>
JetNumber<order> mod(const JetNumber<order>& a, const JetNumber<order>& b) {
  const double rest = floored_mod(a.value(), b.value());
  if constexpr (order == 0) return rest;
  const double periods = std::round((a.value() - rest) / b.value());
  return chain(a, b, {rest, 1, -periods, 0, 0, 0});
}

template <int order>
JetNumber<order> truth(const JetNumber<order>& a, const JetNumber<order>& b, bool holds) {
  if (std::isnan(a.value()) || std::isnan(b.value())) return kUnset;
  return holds ? 1.0 : 0.0;
}

template <int order>
JetNumber<order> select(const JetNumber<order>& condition, const JetNumber<order>& a,
                        const JetNumber<order>& b) {
  if (std::isnan(condition.value())) return kUnset;
  return condition.value() != 0 ? a : b;
}

template <int order>
JetNumber<order> compute_step(Operation operation, const JetNumber<order>& a,
                              const JetNumber<order>& b) {
  switch (operation) {
    case Operation::Sign:
      return sign(a);
    case Operation::Floor:
      return std::floor(a.value());
    case Operation::Ceil:
      return std::ceil(a.value());
    case Operation::Mod:
      return mod(a, b);
    case Operation::Less:
      return truth(a, b, a < b);
    case Operation::LessEqual:
      return truth(a, b, a <= b);
    case Operation::Equal:
      return truth(a, b, a == b);
    default:
      return kUnset;
  }
}

template <int order>
JetNumber<order> log10(const JetNumber<order>& x) {
  const double f1 = 1 / (std::numbers::ln10 * x.value());
  return chain(x, std::log10(x.value()), f1, -f1 / x.value());
}

/// The one definition of all operations: folding and evaluation at every order agree.
template <int order>
inline JetNumber<order> compute(const Instruction& step, const JetNumber<order>* registers) {
  const auto operand = [&](std::size_t i) -> const JetNumber<order>& {
    return registers[step.operand[i]];
  };
  const JetNumber<order>& a = operand(0);
  const JetNumber<order>& b = operand(1);
  const double c = step.constant;
  switch (step.operation) {
    case Operation::Constant:
      return c;
    case Operation::Negate:
      return -a;
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::AddConstant:
      return a + c;
    case Operation::SubtractFrom:
      return c - a;
    case Operation::Scale:
      return a * c;
    case Operation::DivideByConstant:
      return a / c;
    case Operation::DivideConstant:
      return c / a;
    case Operation::Square:
      return square(a);
    case Operation::PowerOf:
      return pow(a, c);
    case Operation::PowerBase:
      return pow(c, a);
    case Operation::Power:
      return pow(a, b);
    case Operation::Sqrt:
      return sqrt(a);
    case Operation::Cbrt:
      return cbrt(a);
    case Operation::Exp:
      return exp(a);
    case Operation::Log:
      return log(a);
    case Operation::Sin:
      return sin(a);
    case Operation::Cos:
      return cos(a);
    case Operation::Tan:
      return tan(a);
    case Operation::Asin:
      return asin(a);
    case Operation::Acos:
      return acos(a);
    case Operation::Atan:
      return atan(a);
    case Operation::Atan2:
      return atan2(a, b);
    case Operation::Sinh:
      return sinh(a);
    case Operation::Cosh:
      return cosh(a);
    case Operation::Tanh:
      return tanh(a);
    case Operation::Abs:
      return abs(a);
    case Operation::Min:
      return min(a, b);
    case Operation::Max:
      return max(a, b);
    case Operation::Hypot:
      return hypot(a, b);
    case Operation::Log10:
      return log10(a);
    case Operation::Select:
      return select(a, b, operand(2));
    default:
      return compute_step(step.operation, a, b);
  }
}

/// The value of an operation on constants.
double fold(Operation operation, double a, double b = 0) {
  const std::array<JetNumber<0>, 2> operands = {a, b};
  return compute<0>({operation, {0, 1}}, operands.data()).value();
}

}  // namespace

std::size_t operand_count(Operation operation) {
  switch (operation) {
    case Operation::Constant:
      return 0;
    case Operation::Add:
    case Operation::Subtract:
    case Operation::Multiply:
    case Operation::Divide:
    case Operation::Power:
    case Operation::Atan2:
    case Operation::Min:
    case Operation::Max:
    case Operation::Hypot:
    case Operation::Mod:
    case Operation::Less:
    case Operation::LessEqual:
    case Operation::Equal:
      return 2;
    case Operation::Select:
      return 3;
    default:
      return 1;
  }
}

template <int order>
void FormulaProgram::evaluate(std::span<const JetNumber<order>> variables,
                              std::span<JetNumber<order>> results) const {
  JetNumber<order> registers[kMaxRegisters];  // not initialised: each is written before it is read
  JetNumber<order>* next = registers;
  for (std::size_t i = 0; i < variable_count_; ++i) *next++ = variables[i];
  for (const Instruction& step : instructions_) *next++ = compute(step, registers);
  for (std::size_t i = 0; i < results_.size(); ++i) results[i] = registers[results_[i]];
}

template void FormulaProgram::evaluate<0>(std::span<const JetNumber<0>>,
                                          std::span<JetNumber<0>>) const;
template void FormulaProgram::evaluate<1>(std::span<const JetNumber<1>>,
                                          std::span<JetNumber<1>>) const;
template void FormulaProgram::evaluate<2>(std::span<const JetNumber<2>>,
                                          std::span<JetNumber<2>>) const;

bool FormulaProgram::uses(std::size_t variable) const {
  const auto index = static_cast<int>(variable);
  const auto reads = [index](const Instruction& step) {
    return std::ranges::find(step.operands(), index) != step.operands().end();
  };
  return std::ranges::any_of(instructions_, reads) ||
         std::ranges::find(results_, index) != results_.end();
}

bool FormulaProgram::reads_each_once() const {
  std::vector<int> reads(variable_count_ + instructions_.size(), 0);
  for (const Instruction& step : instructions_) {
    for (const int operand : step.operands()) ++reads[static_cast<std::size_t>(operand)];
  }
  return std::ranges::all_of(reads, [](int count) { return count <= 1; });
}

bool operator<(const Instruction& x, const Instruction& y) {
  const auto key = [](const Instruction& i) {
    return std::tuple(i.operation, i.operand, std::bit_cast<std::uint64_t>(i.constant));
  };
  return key(x) < key(y);
}

int FormulaBuilder::append(const Instruction& instruction) {
  const int index = variable_count_ + static_cast<int>(nodes_.size());
  const auto [known, is_new] = known_.emplace(instruction, index);
  if (is_new) nodes_.push_back(instruction);
  return known->second;
}

std::optional<double> FormulaBuilder::constant_of(int node) const {
  if (node < variable_count_) return {};
  const Instruction& instruction = nodes_[static_cast<std::size_t>(node - variable_count_)];
  if (instruction.operation != Operation::Constant) return {};
  return instruction.constant;
}

int FormulaBuilder::apply(Operation operation, int a, int b, int d) {
  if (operation == Operation::Select) return select(a, b, d);
  const auto x = constant_of(a);
  if (operand_count(operation) == 1) {
    return x ? constant(fold(operation, *x)) : append({operation, {a}});
  }
  const auto y = constant_of(b);
  if (x && y) return constant(fold(operation, *x, *y));
  if (x || y) return apply_with_constant(operation, a, b);
  if (operation == Operation::Multiply && a == b) return append({Operation::Square, {a}});
  if (is_commutative(operation) && b < a) std::swap(a, b);
  return append({operation, {a, b}});
}

int FormulaBuilder::select(int condition, int a, int b) {
  const auto x = constant_of(condition);
  if (!x) return append({Operation::Select, {condition, a, b}});
  if (std::isnan(*x)) return constant(*x);
  return *x != 0 ? a : b;
}

/// Only rewritings that keep every bit: x + 0 is not x where x is −0.
int FormulaBuilder::apply_with_constant(Operation operation, int a, int b) {
  const auto x = constant_of(a);
  const auto y = constant_of(b);
  const auto append_with = [&](Operation form, double c) { return append({form, {x ? b : a}, c}); };
  switch (operation) {
    case Operation::Add:
      return append_with(Operation::AddConstant, x ? *x : *y);
    case Operation::Subtract:
      return x ? append_with(Operation::SubtractFrom, *x)
               : append_with(Operation::AddConstant, -*y);
    case Operation::Multiply:
      if ((x ? *x : *y) == 1) return x ? b : a;
      return append_with(Operation::Scale, x ? *x : *y);
    case Operation::Divide:
      return x ? append_with(Operation::DivideConstant, *x)
               : append_with(Operation::DivideByConstant, *y);
    case Operation::Power:
      if (x) return append_with(Operation::PowerBase, *x);
      if (*y == 0) return constant(1);
      if (*y == 1) return a;
      if (*y == 2) return append({Operation::Square, {a}});
      return append_with(Operation::PowerOf, *y);
    default:
      return append({operation, {a, b}});
  }
}

std::vector<char> FormulaBuilder::used_nodes(const std::vector<int>& results) const {
  const auto first = static_cast<std::size_t>(variable_count_);
  std::vector<char> is_used(first + nodes_.size(), 0);
  for (int result : results) is_used[static_cast<std::size_t>(result)] = 1;
  for (std::size_t i = is_used.size(); i-- > first;) {
    const Instruction& node = nodes_[i - first];
    if (!is_used[i]) continue;
    for (const int operand : node.operands()) is_used[static_cast<std::size_t>(operand)] = 1;
  }
  return is_used;
}

FormulaProgram FormulaBuilder::finish(const std::vector<int>& results) const {
  const std::vector<char> is_used = used_nodes(results);
  const auto first = static_cast<std::size_t>(variable_count_);
  FormulaProgram program;
  program.variable_count_ = first;

  std::vector<int> registers(is_used.size(), 0);
  for (std::size_t i = 0; i < first; ++i) registers[i] = static_cast<int>(i);
  for (std::size_t i = first; i < is_used.size(); ++i) {
    if (!is_used[i]) continue;
    Instruction step = nodes_[i - first];
    for (int& operand : step.operand) operand = registers[static_cast<std::size_t>(operand)];
    registers[i] = static_cast<int>(first + program.instructions_.size());
    program.instructions_.push_back(step);
  }
  for (int result : results) {
    program.results_.push_back(registers[static_cast<std::size_t>(result)]);
  }

  if (first + program.instructions_.size() > FormulaProgram::kMaxRegisters) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("a formula has {} different operations, of at most {}",
                            program.instructions_.size(), FormulaProgram::kMaxRegisters - first));
  }
  return program;
}

}  // namespace surfmesh
