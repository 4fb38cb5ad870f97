// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "surfmesh/core/interval.hh"
#include "surfmesh/formula/formula_program.hh"

namespace surfmesh {

/// Bound all results of a program as bound() does, and by their slopes: no value differs from that
/// in the middle of the box by more than the slopes in the box permit. The tighter one counts.
///
/// This helps where variables occur several times: the excess of the bounds falls with the square
/// of the width of the box. Where no result or variable is read twice, bound() is as good.
///
/// Error    the rounding errors of the formula are added, to first order
///          (test FormulaSlopes.*)
/// Cost     three to four times that of bound()
/// Pre      as many variables and results as the program has; no NaN in the variables
void bound_by_slopes(const FormulaProgram& program, std::span<const Interval> variables,
                     std::span<Interval> results);

}  // namespace surfmesh
