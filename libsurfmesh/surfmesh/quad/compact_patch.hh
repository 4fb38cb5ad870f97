// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {

/// Compact the mesh of a patch after edits: parameters and metrics of vertices go with their
/// numbers. Edges have no property that counts before finish_patch().
inline void compact_patch(PolyMesh& mesh, FaceEditor& editor) {
  const auto uv = require(mesh, keys::vertex_uv);
  const auto metric = require(mesh, keys::vertex_metric);
  editor.compact([&](auto from, auto to) {
    if constexpr (std::is_same_v<decltype(from), VertexHandle>) {
      mesh.property(uv, to) = mesh.property(uv, from);
      mesh.property(metric, to) = mesh.property(metric, from);
    }
  });
}

}  // namespace surfmesh
