// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// A point of a control space with the sizes wanted there: (P,M), or in the extended forms (P,M,r)
/// and (P,M,r,M′,r′).
/// Source   paper, section 3.1
struct ControlNode {
  Uv uv;
  Vec3 point;
  FirstFormFactor form;
  /// What takes part in interpolation: M, in the last form M′.
  SizeTensor size;
  /// Metric in which the nodes around are about a unit away; unset for a node that comes alone.
  Metric spacing = {};
  /// M, which holds within `radius` of the node in space; unset in the form (P,M).
  SizeTensor inner = {};
  double radius = 0;        ///< r, model units
  SizeTensor outer = {};    ///< M′, `size` itself before it meets other sources
  double outer_radius = 0;  ///< r′: `inner` changes to `outer` over this further length
};

}  // namespace surfmesh
