// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/options.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {

void check(const PipelineOptions& options) {
  check(options.control);
  check(options.boundary);
  check(options.refine);
  check(options.improve);
  if (options.threads < 0 || options.threads > kMostThreads) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("threads = {} is outside its range: 0 (all cores), or up to {}",
                            options.threads, kMostThreads));
  }
}

}  // namespace surfmesh
