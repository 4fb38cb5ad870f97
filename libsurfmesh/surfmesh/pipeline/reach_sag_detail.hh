// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::detail {

/// Mesh a model, with these sources and whatever else is given.
using MeshOnce = std::function<MeshResult(const Sources&)>;

MeshResult reach_sag(const Model& model, const Sources& sources, const PipelineOptions& options,
                     const MeshOnce& mesh_once);

}  // namespace surfmesh::detail
