// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// Copy a mesh with all named properties of its elements, which is all that this library attaches;
/// properties of the mesh itself are left out.
///
/// OpenMesh's own copies leak properties where memory runs out, and those by assignment even delete
/// what belongs to the other mesh.
std::unique_ptr<PolyMesh> copy_of(const PolyMesh& mesh);

/// A mesh as a member of what is copied. Handles of properties stay valid in copies where no
/// property before them was removed.
class CopiedMesh : public PolyMesh {
 public:
  CopiedMesh() = default;
  CopiedMesh(const CopiedMesh& other);
  CopiedMesh& operator=(const CopiedMesh&) = delete;
};

}  // namespace surfmesh
