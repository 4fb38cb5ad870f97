// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {

/// The corners of a result whose (u,v) go on beyond the patch of their face.
class CornersBeyond {
 public:
  explicit CornersBeyond(const PolyMesh& mesh)
      : mesh_(mesh), handle_(find(mesh, keys::corner_beyond)) {}

  bool operator()(HalfedgeHandle corner) const {
    return handle_.is_valid() && mesh_.property(handle_, corner) != 0;
  }

  /// True if a face has such a corner.
  bool any_of(FaceHandle fh) const {
    if (!handle_.is_valid()) return false;
    const auto corners = mesh_.fh_range(fh);
    return std::any_of(corners.begin(), corners.end(),
                       [this](HalfedgeHandle corner) { return (*this)(corner); });
  }

  /// A corner of a vertex that lies on the patch of its face; invalid if there is none.
  HalfedgeHandle corner_on_patch(VertexHandle vh) const {
    for (const HalfedgeHandle corner : mesh_.vih_range(vh)) {
      if (!mesh_.is_boundary(corner) && !(*this)(corner)) return corner;
    }
    return HalfedgeHandle();
  }

 private:
  const PolyMesh& mesh_;
  decltype(keys::corner_beyond)::Handle handle_;
};

}  // namespace surfmesh::detail
