// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::detail {

/// Mesh a model with these sources; where it is the last time, correct triangles one by one.
using MeshOnce = std::function<MeshResult(const Sources&, bool is_last)>;

MeshResult reach_sag(const Model& model, const Sources& sources, const PipelineOptions& options,
                     const MeshOnce& mesh_once);

}  // namespace surfmesh::detail
