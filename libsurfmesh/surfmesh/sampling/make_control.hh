// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// How a control space stores sizes: a triangulation of its nodes, or a regular grid.
enum class ControlKind { Mesh, Grid };

/// How control spaces are made and queried: what the user may set.
struct ControlOptions {
  ControlKind kind = ControlKind::Mesh;
  int regular_nodes = 0;   ///< in each patch, see ControlNodeOptions; 0 chooses them by precision
  double precision = 0.1;  ///< conformity with the requested sizes, see ControlNodeOptions
  /// Refine the triangulation of the nodes for shape (the I of the paper); no effect on a grid.
  bool inner_nodes = false;
  Interpolation interpolation = Interpolation::Linear;
  double epsilon = 0.1;  ///< of Interpolation::Automatic, see ControlSpaceOptions
  Blend blend = Blend::Linear;
  DiscLookup lookup = DiscLookup::Disc;
  double reuse = 0;  ///< R of the paper, see ControlSpaceOptions; 0 is off
};

/// Throws   InvalidOption naming the option, its value and its range
void check(const ControlOptions& options);

/// Everything that the control space of one patch is made from.
struct ControlInput {
  Domain domain;
  std::vector<ControlNode> nodes;        ///< of a triangulation, or of a square grid
  std::vector<ControlNode> extra_nodes;  ///< in addition to a grid, at points of their own
  ControlKind kind = ControlKind::Mesh;
  ControlSpaceOptions options = {};
  bool is_coarse = false;  ///< the nodes do not reach the precision, see ChosenNodes
};

/// Collect the nodes of one patch from all sources of sizes, and the options with the gradation.
///
/// Nodes are chosen so that the control space represents the sources (choose_accurate_nodes). A
/// precision given by a source overrides that of the options. Nodes of `at` get the minimum with
/// the other sources. If there are none, the only other nodes are the corners, with the size of the
/// nearest `at`. If gradation is off, a curve of sizes without a radius becomes nodes along it.
///
/// Cost     about 5 µs per node
/// Throws   InvalidOption; InvalidInput for a source that is out of range or lies outside the
///          domain, naming its (u,v)
/// Source   paper, section 3.2
ControlInput collect_control_input(const Surface& surface, const ResolvedSizing& sizing,
                                   const PatchSources& sources, const ControlOptions& options);

/// Make the control space from the collected input; gradation comes last.
std::unique_ptr<ControlSpace> make_control(const ControlInput& input);

}  // namespace surfmesh
