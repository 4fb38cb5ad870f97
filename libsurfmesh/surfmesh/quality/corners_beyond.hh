// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

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

  /// The patches of the faces around a vertex, some of them repeatedly.
  std::vector<int> patches_around(VertexHandle vh) const {
    const auto patch_of = require(mesh_, keys::face_patch);
    std::vector<int> patches;
    for (const FaceHandle fh : mesh_.vf_range(vh)) patches.push_back(mesh_.property(patch_of, fh));
    return patches;
  }

  /// The patches of the faces around the vertices of a face, most of them repeatedly.
  std::vector<int> patches_around(FaceHandle fh) const {
    std::vector<int> patches;
    for (const VertexHandle vh : mesh_.fv_range(fh)) {
      const std::vector<int> around = patches_around(vh);
      patches.insert(patches.end(), around.begin(), around.end());
    }
    return patches;
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
