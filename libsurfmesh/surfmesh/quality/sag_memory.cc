// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/sag_memory.hh"

#include <functional>

#include "surfmesh/core/properties.hh"
#include "surfmesh/quality/face_corners.hh"

namespace surfmesh {
namespace {

/// Spreads what differs in few bits (the golden ratio, as in boost::hash_combine).
std::size_t combined(std::size_t hash, std::size_t other) {
  return hash ^ (other + 0x9e3779b97f4a7c15 + (hash << 6) + (hash >> 2));
}

}  // namespace

std::size_t SagMemory::Hash::operator()(const Key& key) const {
  auto hash = static_cast<std::size_t>(key.patch);
  for (const Uv uv : key.corners) {
    hash = combined(hash, std::hash<double>()(uv.u));
    hash = combined(hash, std::hash<double>()(uv.v));
  }
  return hash;
}

SagMemory::Key SagMemory::key_of(const PolyMesh& mesh, FaceHandle fh) {
  const auto uv_of = require(mesh, keys::corner_uv);
  Key key{mesh.property(require(mesh, keys::face_patch), fh), {}};
  const std::vector<HalfedgeHandle> corners = detail::corners_of(mesh, fh);
  for (std::size_t k = 0; k < 3; ++k) key.corners[k] = mesh.property(uv_of, corners[k]);
  return key;
}

const FaceSag* SagMemory::find(const PolyMesh& mesh, FaceHandle fh) const {
  if (known_.empty() || mesh.valence(fh) != 3) return nullptr;
  const auto found = known_.find(key_of(mesh, fh));
  return found == known_.end() ? nullptr : &found->second;
}

void SagMemory::keep(const PolyMesh& mesh, const std::vector<FaceSag>& faces) {
  known_.clear();
  known_.reserve(faces.size());
  for (const FaceHandle fh : mesh.faces()) {
    if (mesh.valence(fh) == 3) known_.emplace(key_of(mesh, fh), faces[index(fh)]);
  }
}

}  // namespace surfmesh
