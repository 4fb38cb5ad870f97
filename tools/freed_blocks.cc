// SPDX-License-Identifier: BSD-3-Clause
#include "freed_blocks.hh"

#include <cstdlib>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace surfmesh {

void keep_freed_blocks() {
#ifdef __GLIBC__
  constexpr int largest = 32 << 20;  // the greatest threshold that the library takes
  mallopt(M_MMAP_THRESHOLD, largest);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace surfmesh
