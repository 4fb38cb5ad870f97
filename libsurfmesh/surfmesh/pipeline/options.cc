// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/options.hh"

namespace surfmesh {

void check(const PipelineOptions& options) {
  check(options.control);
  check(options.boundary);
  check(options.refine);
  check(options.improve);
}

}  // namespace surfmesh
