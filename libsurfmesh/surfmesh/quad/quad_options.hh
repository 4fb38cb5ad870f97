// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// How quads are made.
enum class QuadMethod {
  Best,    ///< between nodes placed for them
  Frontal  ///< by conversion of the triangles from the boundary inwards, as in the paper
};

/// How the frontal method makes a quad.
enum class QuadFront {
  LeeLo,   ///< by merging two triangles
  QMorph,  ///< by side edges and a top edge
  Mixed    ///< by either, as the change of the metric suggests
};

/// Quads in place of triangles.
struct QuadOptions {
  bool is_on = false;
  QuadMethod method = QuadMethod::Best;
  QuadFront front = QuadFront::Mixed;  ///< of the frontal method
};

/// Throws   InvalidOption, naming the option, its value and its range
void check(const QuadOptions& options);

}  // namespace surfmesh
