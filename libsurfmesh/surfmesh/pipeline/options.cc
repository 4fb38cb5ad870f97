// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/options.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {

void check(const PipelineOptions& options) {
  check(options.control);
  check(options.improve);
  if (options.threads < 0 || options.threads > kMostThreads) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("threads = {} is outside its range: 0 (all cores), or up to {}",
                            options.threads, kMostThreads));
  }
  if (options.max_elements == 0) {
    throw Error(ErrorCode::InvalidOption, "max_elements = 0 is outside its range: above 0");
  }
}

}  // namespace surfmesh
