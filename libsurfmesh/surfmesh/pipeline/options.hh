// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/boundary/contour_nodes.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/refine/refine.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The options of all stages.
struct PipelineOptions {
  Sizing sizing = {};
  ControlOptions control = {};
  BoundaryOptions boundary = {};
  RefineOptions refine = {};
  ImproveOptions improve = {};
  PatchKind patches = PatchKind::Auto;  ///< of cages, when a model is loaded; not used in meshing
  int threads = 0;  ///< that work, from 1 to 256; 0 is one for each core. The mesh is the same
  Observer* observer = nullptr;  ///< told of progress, by one thread at a time; not owned, or null
};

/// Throws   InvalidOption naming the option, its value and its range
void check(const PipelineOptions& options);

}  // namespace surfmesh
