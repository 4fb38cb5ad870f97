// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/across/across.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/formats/output_options.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/quad/quad_options.hh"
#include "surfmesh/refine/refine.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// Everything the user may set, for all stages.
struct PipelineOptions {
  Sizing sizing = {};
  ControlOptions control = {};
  RefineOptions refine = {};
  ImproveOptions improve = {};
  QuadOptions quads = {};
  AcrossOptions across = {};
  OutputOptions output = {};
  /// Of cages; see CageOptions. This and the next seven act where a model is made; mesh_model warns
  /// of those that its model was not made with.
  PatchKind patches = PatchKind::Auto;
  std::optional<Length> weld = {};          ///< likewise
  std::optional<bool> orient = {};          ///< likewise
  std::optional<double> crease_angle = {};  ///< likewise, degrees
  SurfaceKind surface = SurfaceKind::Auto;  ///< likewise
  std::optional<Length> fit = {};           ///< likewise; of interpolating surfaces
  std::optional<Length> joining = {};       ///< of formula patches; see JoinOptions
  std::optional<Length> sew = {};           ///< of CAD files; see CadOptions
  /// Triangles up to which a patch, or a part of it, is meshed in one: larger ones are cut into
  /// tiles. 0 is off.
  int tile = 100'000;
  int threads = 0;  ///< from 1 to 256; 0 is one per core. The mesh is always the same
  std::size_t max_elements = 50'000'000;  ///< more triangles end the run with an error. Above 0
};

/// Check every option by itself. That hmin is not above hmax is checked by resolve(), which knows
/// the size of the model.
///
/// Throws   InvalidOption, naming the option, its value and its range
void check(const PipelineOptions& options);

/// What a run with these options makes.
ElementKind element_kind(const PipelineOptions& options);

}  // namespace surfmesh
