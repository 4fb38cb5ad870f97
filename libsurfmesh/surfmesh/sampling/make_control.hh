// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/control/control_space.hh"
#include "surfmesh/control/lattice_space.hh"
#include "surfmesh/control/node_triangulation.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/sampling/control_nodes.hh"
#include "surfmesh/sampling/sample_cells.hh"
#include "surfmesh/sizes/patch_sources.hh"
#include "surfmesh/sizes/resolved_sizing.hh"

namespace surfmesh {

/// How a control space stores sizes.
enum class ControlKind {
  Mesh,       ///< in a triangulation of its nodes, as in the paper
  Grid,       ///< at the nodes of a regular grid
  Cells,      ///< in cells that are halved where sizes change
  Automatic,  ///< Mesh if an option is set that belongs to it alone, otherwise Cells
};

/// How control spaces are made and queried: what the user may set.
struct ControlOptions {
  ControlKind kind = ControlKind::Automatic;
  double precision = 0.1;  ///< conformity with the requested sizes, see ControlNodeOptions
  Blend blend = Blend::Linear;
  /// In each patch, of a mesh or a grid, see ControlNodeOptions; 0 chooses them by precision.
  int regular_nodes = 0;
  // Of a mesh alone.
  bool inner_nodes = false;  ///< refine the triangulation for shape (the I of the paper)
  Interpolation interpolation = Interpolation::Linear;
  double epsilon = 0.1;  ///< of Interpolation::Automatic, see ControlSpaceOptions
  DiscLookup lookup = DiscLookup::Disc;
  double reuse = 0;  ///< R of the paper, see ControlSpaceOptions; 0 is off
};

/// The kind that takes effect: that of the options, unless it is automatic.
ControlKind effective_kind(const ControlOptions& options);

/// Throws   InvalidOption naming the option, its value and its range
void check(const ControlOptions& options);

/// Tell an option that has no effect on the kind of control space that was asked for.
std::optional<Notice> unused_option(const ControlOptions& options);

/// Everything that the control space of one patch is made from.
struct ControlInput {
  Domain domain;
  ControlKind kind = ControlKind::Mesh;  ///< not Automatic
  std::vector<ControlNode> nodes = {};   ///< of a triangulation
  ControlSpaceOptions options = {};
  /// The triangulation of these nodes, if it is known: make_control takes it, so that nodes may be
  /// added afterwards.
  std::unique_ptr<NodeTriangulation> triangulation = {};
  /// A lattice with the sizes of the sources, before gradation: make_control takes it.
  std::unique_ptr<LatticeSpace> lattice = {};
  CellSampling sampling = {};
};

/// Collect the nodes of one patch from all sources of sizes, and the options with the gradation.
///
/// Nodes are chosen so that the control space represents the sources (sample_cells,
/// choose_accurate_nodes, choose_grid_nodes). A precision given by a source overrides that of the
/// options. Nodes of `at` get the minimum with the other sources. If there are none, the nodes of a
/// mesh are those of `at` and the corners, with the size of the nearest `at`; a lattice represents
/// what they give. If gradation is off, a curve of sizes without a radius becomes nodes along it.
///
/// Cost     with make_control, 1 µs per node of cells, 8 µs of a mesh, 2.5 µs of a grid
///          (make_whole_control in tests/bench/control_bench.cc)
/// Throws   Cancelled; InvalidOption; InvalidInput for a source that is out of range or outside the
///          domain, naming its (u,v)
/// Source   paper, section 3.2
ControlInput collect_control_input(const Surface& surface, const ResolvedSizing& sizing,
                                   const PatchSources& sources, const ControlOptions& options,
                                   const RunContext& context = RunContext());

/// Make the control space from the collected input, with gradation within the patch. Its sizes are
/// final for queries after finish().
///
/// Throws   Cancelled
std::unique_ptr<ControlSpace> make_control(ControlInput& input,
                                           const RunContext& context = RunContext());

/// Prepare a control space for queries, once its sizes are final. A mesh always is.
void finish(ControlSpace& space);

}  // namespace surfmesh
