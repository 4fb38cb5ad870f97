// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

// The parts of [0,1] between `breaks`, which are ascending and inside it. Each part may hold as
// much detail as another whole: sample every part.

/// Breaks that make `count` equal parts.
std::vector<double> even_breaks(int count);

/// Divide each part into `count` equal intervals.
/// Returns  all t from 0 to 1, both included
std::vector<double> divided_parts(const std::vector<double>& breaks, int count);

/// The width of the part that has t inside, or of the one behind it at a break.
double part_width(const std::vector<double>& breaks, double t);

/// The breaks of the piece from `from` to `to`, as t of that piece. With from > to it runs
/// backwards.
std::vector<double> breaks_between(const std::vector<double>& breaks, double from, double to);

}  // namespace surfmesh
