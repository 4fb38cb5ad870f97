// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// a − b·floor(a/b): what is left of a after whole periods b, from 0 to b and with the sign of b;
/// a zero has it, too. NaN for b = 0.
/// Error    one rounding; none if a and b have the same sign
inline double floored_mod(double a, double b) {
  const double rest = std::fmod(a, b);
  if (rest == 0) return std::copysign(rest, b);
  return (rest < 0 && b > 0) || (rest > 0 && b < 0) ? rest + b : rest;
}

}  // namespace surfmesh
