// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "surfmesh/geometry/domain.hh"

namespace surfmesh {

/// Point i, from 1, of a sequence that covers the rectangle of a domain evenly: the additive one of
/// the plastic number, which has no period.
/// Source   Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
inline Uv quasirandom_point(const Domain& domain, int i) {
  constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
  double whole = 0;
  return domain.at(std::modf(i * first, &whole), std::modf(i * second, &whole));
}

}  // namespace surfmesh
