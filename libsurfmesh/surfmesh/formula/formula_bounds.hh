// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "surfmesh/core/interval.hh"
#include "surfmesh/formula/formula_program.hh"

namespace surfmesh {

/// Bound all results of a program for variables inside intervals.
///
/// Every value that FormulaProgram::evaluate gives at numbers in the box lies inside, unless it is
/// NaN. Points where a formula is not defined do not count; a result that is defined nowhere in the
/// box is unbounded, and so is a quotient whose divisor changes its sign. Where the sign of a zero
/// decides, as for 1/0 and on the cut of atan2, that zero has the sign of the rest of its interval.
/// Where a step may be in the box, both of its sides count.
///
/// The bounds are exact, up to a few roundings, where each variable occurs once. Otherwise they are
/// too wide, by an amount that falls linearly with the width of the box.
///
/// Error    8 roundings at each end for functions other than sqrt and abs; none for arithmetic
///          (test FormulaBounds.*)
/// Cost     about 10 ns for an arithmetic operation, 30 ns for sin or a power
///          (tests/bench/field_search_bench.cc)
/// Pre      as many variables and results as the program has; no NaN in the variables
void bound(const FormulaProgram& program, std::span<const Interval> variables,
           std::span<Interval> results);

/// The same for all registers: the variables, then the instructions.
/// Pre      as many registers
void bound_registers(const FormulaProgram& program, std::span<const Interval> variables,
                     std::span<Interval> registers);

/// The same for one operation on operands inside intervals. Those that the operation does not have
/// are not read.
Interval bound_operation(const Instruction& step, const Interval& a, const Interval& b,
                         const Interval& d = {});

}  // namespace surfmesh
