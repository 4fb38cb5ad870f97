// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/patch_cache.hh"

#include <algorithm>
#include <utility>

#include "surfmesh/core/copy_mesh.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {
namespace {

bool are_same(const BoundaryLoop& a, const BoundaryLoop& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const BoundaryNode& m, const BoundaryNode& n) {
        return m.uv == n.uv && m.contour == n.contour && (m.vertex < 0) == (n.vertex < 0);
      });
}

/// True if a patch has the same mesh between both, apart from the numbers of vertices.
bool are_same(const PatchBoundary& a, const PatchBoundary& b) {
  return std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(),
                    [](const BoundaryLoop& m, const BoundaryLoop& n) { return are_same(m, n); });
}

/// Without times and queries.
PatchResult copy_of(const PatchResult& result, PatchBoundary boundary) {
  PatchResult copy;
  copy.mesh.boundary = std::move(boundary);
  copy.mesh.mesh = copy_of(*result.mesh.mesh);
  copy.turned = result.turned;
  copy.is_given_up = result.is_given_up;
  return copy;
}

}  // namespace

bool PatchCache::begin(std::size_t patch, const PolyMesh& control) {
  KeptPatch& kept = patches_[patch];
  std::vector<Node> nodes = nodes_of(control);
  if (nodes == kept.nodes) return true;
  kept = {std::move(nodes), {}};
  return false;
}

std::optional<PatchResult> PatchCache::find(TilePlace place, const PatchTask& task) const {
  const Kept* kept = nullptr;
  {
    const std::lock_guard lock(mutex_);
    const auto& tiles = patches_[place.patch].tiles;
    if (const auto found = tiles.find(place.tile); found != tiles.end()) kept = &found->second;
  }
  if (!kept || kept->corrected_sag != task.corrected_sag ||
      !are_same(kept->result.mesh.boundary, task.boundary)) {
    return std::nullopt;
  }
  return copy_of(kept->result, task.boundary);
}

void PatchCache::keep(TilePlace place, double corrected_sag, const PatchResult& result) {
  Kept kept{corrected_sag, copy_of(result, result.mesh.boundary)};
  const std::lock_guard lock(mutex_);
  patches_[place.patch].tiles.insert_or_assign(place.tile, std::move(kept));
}

std::vector<PatchCache::Node> PatchCache::nodes_of(const PolyMesh& control) {
  const auto uv_of = require(control, keys::vertex_uv);
  const auto size_of = require(control, keys::vertex_size);
  std::vector<Node> nodes;
  nodes.reserve(control.n_vertices());
  for (const VertexHandle vh : control.vertices()) {
    nodes.push_back({control.property(uv_of, vh), control.property(size_of, vh)});
  }
  return nodes;
}

}  // namespace surfmesh::detail
