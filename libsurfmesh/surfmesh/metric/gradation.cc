// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/gradation.hh"

#include <cmath>

#include "surfmesh/metric/minimum.hh"
#include "surfmesh/metric/size_tensor.hh"

namespace surfmesh {

SizeTensor graded(const SizeTensor& at_j, const SizeTensor& at_i, double length_m, double grade) {
  if (grade == 0) return at_j;
  return minimum(at_j, scaled(at_i, 1 + std::log(grade) * length_m));
}

}  // namespace surfmesh
