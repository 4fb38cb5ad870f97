// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Complete a model that was built by hand.
///
/// The caller gives vertices, contours with their uses, and patches with surfaces and loops. This
/// sets what follows from them:
/// - positions of vertices that are unset: the first end of a contour there;
/// - contours and patches below 1e-7 of the diagonal, or below their tolerance, are left out
///   (merge_small.hh);
/// - ends of curves that are one corner of a patch meet exactly (pin_ends.hh);
/// - loops that touch in a corner are in the form that meshing expects (touching_loops.hh);
/// - Contour::is_degenerate, also of contours with one vertex and no extent that are not marked;
/// - ContourUse::is_same_speed: whether points of equal t are the same, to 1e-7 of the diagonal
///   or a tenth of the contour's tolerance;
/// - Contour::is_smooth (contour_smoothness.hh);
/// - Model::box and Model::diagonal, unless the box is set.
///
/// Call check() afterwards, or mesh_model, which does.
///
/// Cost     9 × 9 evaluations for each cell of a surface, 100 × 100 at most a patch, and about a
///          hundred for each use of a contour
/// Throws   InvalidInput for indices that do not exist; Geometry if a surface cannot be evaluated
void finish(Model& model);

/// The box of samples of a surface.
/// Cost     9 × 9 evaluations for each cell, 100 × 100 at most
Eigen::AlignedBox3d sampled_box(const Surface& surface);

/// The greatest distance of the curves of a contour from its first one, and of their ends from its
/// vertices, model units. Uses that do not run at the same speed are projected.
///
/// Error    measured at nine points of each part
double gap_of(const Model& model, const Contour& contour);

}  // namespace surfmesh
