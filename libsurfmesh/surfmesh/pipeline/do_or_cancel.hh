// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/run_context.hh"

namespace surfmesh::detail {

/// Do the work of a run. Of a cancelled run no other error counts, for which patch was at work then
/// is a matter of chance.
///
/// Where memory runs out, the error says how far the run came in finished `parts`: patches, tiles.
/// Throws   Cancelled; Limit without memory; what the work throws
template <class Work>
void do_or_cancel(const RunContext& context, std::string_view parts, Work work) {
  try {
    tell_out_of_memory(work, [&] {
      return fmt::format("at {} {} in finished {}", context.elements(),
                         name(context.element_kind()), parts);
    });
  } catch (const Error&) {
    if (context.was_cancelled()) context.throw_if_cancelled();
    throw;
  }
}

}  // namespace surfmesh::detail
