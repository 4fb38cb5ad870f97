// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"
#include "surfmesh/sampling/make_control.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// The control spaces of all patches of a model, with notices about them.
struct ControlSpaces {
  std::vector<std::unique_ptr<ControlSpace>> spaces;  ///< in the order of the patches
  Notices notices;
  PrecisionSample precision;  ///< of all patches; of cells and of grids with chosen nodes
};

/// Make the control space of each patch, graded within patches and across their contours.
///
/// Throws   Cancelled; InvalidOption; InvalidInput for a source that is invalid or whose patch does
///          not exist; Geometry; Limit; errors name the patch
ControlSpaces make_control_spaces(const Model& model, const Sources& sources,
                                  const ResolvedSizing& sizing, const ControlOptions& options,
                                  const RunContext& context = RunContext());

namespace detail {

/// The first half of make_control_spaces: control spaces that are graded within their patches only,
/// and what they were made from.
struct ControlBases {
  ControlSpaces control;
  std::vector<ControlInput> inputs;   ///< in the order of the patches
  std::vector<PatchSources> sources;  ///< likewise
};

/// Throws   as make_control_spaces
ControlBases make_control_bases(const Model& model, const Sources& sources,
                                const ResolvedSizing& sizing, const ControlOptions& options,
                                const RunContext& context);

/// The second half: grade across contours, and prepare for queries.
/// Throws   Cancelled
void finish_control_spaces(const Model& model, std::vector<ControlInput>& inputs,
                           std::vector<std::unique_ptr<ControlSpace>>& spaces,
                           const RunContext& context);

}  // namespace detail
}  // namespace surfmesh
