// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surfmesh {

/// Give memory that was freed back to the system, where the C library keeps it for later between
/// blocks that are in use. Of worth before a large allocation that finds no room there.
///
/// Cost     a walk over all blocks that are free; what is used again later is slower the first time
void return_freed_memory();

}  // namespace surfmesh
