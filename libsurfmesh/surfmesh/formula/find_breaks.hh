// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "surfmesh/core/interval.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/formula/formula_program.hh"

namespace surfmesh {

/// How a break goes on beside the point where it was found.
enum class BreakLine { Other, ConstantU, ConstantV };

/// A point where formulas jump, or grow without bound around it.
struct FormulaBreak {
  bool is_infinite = false;
  Operation operation = Operation::Constant;  ///< what jumps or is infinite
  Uv at = {};                                 ///< v is 0 for formulas of one variable
  Uv beside = {};                             ///< a point on one side of a jump
  double height = 0;                          ///< of a jump: the distance of the results
  bool is_greatest = false;  ///< the point is where the jump is highest, of some along the line
  BreakLine line = BreakLine::Other;
  bool may_be_more = false;  ///< of the last one: the search ended before all places were seen
};

/// Where breaks are looked for.
struct BreakSearch {
  UvBox box;        ///< v is {0, 0} for formulas of one variable
  double size = 1;  ///< of the results: jumps of less than 1e-6 of it do not count
  /// Tells points of the box that do not count; empty if all do.
  std::function<bool(Uv)> is_inside = {};
};

/// At most so many jumps are looked for.
inline constexpr std::size_t kMostBreaks = 4;

/// Look for points where one to three formulas of one or two variables jump or run to infinity.
///
/// Cells that may have such a point, by the bounds of operations that can break, are halved until
/// they are points to 2^-44 of the box. Then values decide. A jump is there if the results on its
/// two sides, 2^-30 of the box from it, differ by the same amount as at 2^-45. The
/// results are infinite there if they go on growing, at least as by a logarithm, from 2^-12 to
/// 2^-24 of the box. So kinks, steep slopes, roots and removable quotients such as sin(u)/u are
/// none. Along lines of constant u or v each line gives one jump, at the highest of some places on
/// it; along others each operation gives one, at any place. The search ends at the first point of
/// infinity.
///
/// Error    not found are breaks below 1e-6 (jumps) or about 1e-2 (infinity) of `size`; those that
///          two operations make together; and those of an operation that mostly is harmless, for
///          each is followed to 8 points only. Where points are counted as inside by `is_inside`,
///          both sides of a jump have to be
/// Cost     none for formulas without operations that can break; else up to 8,192 bounds and about
///          as many evaluations
/// Pre      one or two variables, one to three results
std::vector<FormulaBreak> find_breaks(const FormulaProgram& program, const BreakSearch& search);

}  // namespace surfmesh
