// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/freed_memory.hh"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace surfmesh {

void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace surfmesh
