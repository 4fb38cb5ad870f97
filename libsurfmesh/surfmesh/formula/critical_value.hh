// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "surfmesh/core/interval.hh"
#include "surfmesh/formula/formula_program.hh"

namespace surfmesh {

/// True for an operation that may be infinite for finite operands.
bool may_be_infinite(const Instruction& step);

/// True for an operation that may jump or be infinite for finite operands. Comparisons by == do not
/// count: they jump to and back, within a point.
bool may_break(const FormulaProgram& program, const Instruction& step);

/// True if a program has an operation that may break.
bool may_break(const FormulaProgram& program);

/// Of an operation that may break, the value that is 0 where it does: a divisor, the difference of
/// what is compared, the distance to the nearest integer for floor.
///
/// Returns  its bounds for operands in these registers; nothing if the operation does not break
///          there, as where the value is 0 throughout
/// Pre      may_break(program, step)
std::optional<Interval> critical_value(const Instruction& step,
                                       std::span<const Interval> registers);

}  // namespace surfmesh
