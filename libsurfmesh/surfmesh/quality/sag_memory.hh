// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// What is known of how far a face and its surface are from each other.
struct FaceSag {
  double sag = 0;
  double error = 0;  ///< of an estimate; infinite where nothing is known
  bool is_measured = false;
  Vec3 at = Vec3::Zero();  ///< where it is measured

  double most() const { return sag + error; }
};

/// Keeps what is known of the faces of a mesh, for another mesh of the same model that shares many
/// of them.
class SagMemory {
 public:
  /// What is known of a face; null if it was no triangle of the mesh before.
  const FaceSag* find(const PolyMesh& mesh, FaceHandle fh) const;

  /// Forget all other faces.
  void keep(const PolyMesh& mesh, const std::vector<FaceSag>& faces);

 private:
  /// A triangle by its corners, in their order.
  struct Key {
    int patch = -1;
    std::array<Uv, 3> corners;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  static Key key_of(const PolyMesh& mesh, FaceHandle fh);

  std::unordered_map<Key, FaceSag, Hash> known_;
};

}  // namespace surfmesh
