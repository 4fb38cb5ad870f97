// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_program.hh"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {
namespace {

bool is_binary(Operation operation) {
  switch (operation) {
    case Operation::Add:
    case Operation::Subtract:
    case Operation::Multiply:
    case Operation::Divide:
    case Operation::Power:
    case Operation::Atan2:
    case Operation::Min:
    case Operation::Max:
    case Operation::Hypot:
      return true;
    default:
      return false;
  }
}

bool is_commutative(Operation operation) {
  return operation == Operation::Add || operation == Operation::Multiply;
}

/// The one definition of all operations: folding and evaluation at every order agree.
template <int order>
inline JetNumber<order> compute(Operation operation, const JetNumber<order>& a,
                                const JetNumber<order>& b, double c) {
  switch (operation) {
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
  }
  return kUnset;
}

}  // namespace

template <int order>
void FormulaProgram::evaluate(std::span<const JetNumber<order>> variables,
                              std::span<JetNumber<order>> results) const {
  JetNumber<order> registers[kMaxRegisters];  // not initialised: each is written before it is read
  JetNumber<order>* next = registers;
  for (std::size_t i = 0; i < variable_count_; ++i) *next++ = variables[i];
  for (const Instruction& step : instructions_) {
    *next++ = compute(step.operation, registers[step.a], registers[step.b], step.constant);
  }
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
    if (step.operation == Operation::Constant) return false;
    return step.a == index || (is_binary(step.operation) && step.b == index);
  };
  return std::ranges::any_of(instructions_, reads) ||
         std::ranges::find(results_, index) != results_.end();
}

bool FormulaProgram::reads_each_once() const {
  std::vector<int> reads(variable_count_ + instructions_.size(), 0);
  for (const Instruction& step : instructions_) {
    if (step.operation == Operation::Constant) continue;
    ++reads[static_cast<std::size_t>(step.a)];
    if (is_binary(step.operation)) ++reads[static_cast<std::size_t>(step.b)];
  }
  return std::ranges::all_of(reads, [](int count) { return count <= 1; });
}

bool operator<(const Instruction& x, const Instruction& y) {
  const auto key = [](const Instruction& i) {
    return std::tuple(i.operation, i.a, i.b, std::bit_cast<std::uint64_t>(i.constant));
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

int FormulaBuilder::apply(Operation operation, int a, int b) {
  if (!is_binary(operation)) {
    if (const auto x = constant_of(a)) {
      return constant(compute<0>(operation, *x, 0.0, 0).value());
    }
    return append({operation, a, 0, 0});
  }
  const auto x = constant_of(a);
  const auto y = constant_of(b);
  if (x && y) return constant(compute<0>(operation, *x, *y, 0).value());
  if (x || y) return apply_with_constant(operation, a, b);
  if (operation == Operation::Multiply && a == b) return append({Operation::Square, a, 0, 0});
  if (is_commutative(operation) && b < a) std::swap(a, b);
  return append({operation, a, b, 0});
}

/// Only rewritings that keep every bit: x + 0 is not x where x is −0.
int FormulaBuilder::apply_with_constant(Operation operation, int a, int b) {
  const auto x = constant_of(a);
  const auto y = constant_of(b);
  switch (operation) {
    case Operation::Add:
      return append({Operation::AddConstant, x ? b : a, 0, x ? *x : *y});
    case Operation::Subtract:
      return x ? append({Operation::SubtractFrom, b, 0, *x})
               : append({Operation::AddConstant, a, 0, -*y});
    case Operation::Multiply:
      if ((x ? *x : *y) == 1) return x ? b : a;
      return append({Operation::Scale, x ? b : a, 0, x ? *x : *y});
    case Operation::Divide:
      return x ? append({Operation::DivideConstant, b, 0, *x})
               : append({Operation::DivideByConstant, a, 0, *y});
    case Operation::Power:
      if (x) return append({Operation::PowerBase, b, 0, *x});
      if (*y == 0) return constant(1);
      if (*y == 1) return a;
      if (*y == 2) return append({Operation::Square, a, 0, 0});
      return append({Operation::PowerOf, a, 0, *y});
    default:
      return append({operation, a, b, 0});
  }
}

std::vector<char> FormulaBuilder::used_nodes(const std::vector<int>& results) const {
  const auto first = static_cast<std::size_t>(variable_count_);
  std::vector<char> is_used(first + nodes_.size(), 0);
  for (int result : results) is_used[static_cast<std::size_t>(result)] = 1;
  for (std::size_t i = is_used.size(); i-- > first;) {
    const Instruction& node = nodes_[i - first];
    if (!is_used[i] || node.operation == Operation::Constant) continue;
    is_used[static_cast<std::size_t>(node.a)] = 1;
    if (is_binary(node.operation)) is_used[static_cast<std::size_t>(node.b)] = 1;
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
    step.a = registers[static_cast<std::size_t>(step.a)];
    step.b = registers[static_cast<std::size_t>(step.b)];
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
