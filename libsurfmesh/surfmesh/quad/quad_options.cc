// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/quad_options.hh"

#include "surfmesh/core/option_range.hh"

namespace surfmesh {

void check(const QuadOptions& options) {
  check_option(ranges::kQuads, options.is_on ? 1 : 0);
  check_option(ranges::kQuadMethod, options.method);
  check_option(ranges::kQuadFront, options.front);
}

}  // namespace surfmesh
