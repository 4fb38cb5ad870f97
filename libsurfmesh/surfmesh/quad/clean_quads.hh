// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/quad/quad_geometry.hh"

namespace surfmesh {

struct CleaningReport {
  std::size_t tried = 0;    ///< changes of connectivity
  std::size_t changed = 0;  ///< of these, kept
};

/// Change the connectivity of quads where that makes them better.
///
/// In up to 8 passes over the faces near what the last pass has changed, bad quads first: dissolve
/// doublets, collapse quads, rotate edges, open vertices of many faces; at bad quads also insert
/// columns and, from the third pass on, pillows. A change is tried where it does not raise the sum
/// of squares of what vertices have more or less faces than fit, or at a quad under 0.55; it is
/// kept by QuadTrial's rule.
///
/// `wanted` is how many faces fit best at each of the first vertices; 4 at all others.
/// Cost     about 30 µs a trial
/// Throws   Cancelled
CleaningReport clean_quads(PolyMesh& mesh, FaceEditor& editor, QuadGeometry& geometry,
                           std::vector<int> wanted, const RunContext& context);

}  // namespace surfmesh
