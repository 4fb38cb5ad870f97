// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/geometry/cage.hh"
#include "surfmesh/geometry/model.hh"

namespace surfmesh {

/// How a cage becomes a model.
struct CageOptions {
  Scheme scheme = Scheme::Auto;  ///< subdivision scheme
  int approximation_level = 8;   ///< 1 to 10, see make_limit_surfaces
};

/// Make a model of the limit surface of a cage: each face a patch, each edge a contour, each vertex
/// a model vertex, at its limit position.
///
/// The side of a face that has the same vertex twice in a row is a degenerate contour; see
/// make_regular for faces that cannot be used. Patches are named f<face>. If a face of a
/// Catmull-Clark or bilinear cage is not a quad, the cage is refined once first, and patches are
/// f<face>.<k>, k the corner of the face that it is at. Contours are named e<vertex>-<vertex>,
/// after the vertices of the cage, or the refined one. A contour of three and more faces has as
/// many uses. Faces without limit surface (see make_limit_surfaces) are left out, and the contours
/// and vertices that only they have. Each group of the cage becomes one of the model. The warnings
/// are of tags that make no sense and are ignored; those of the cage itself are not repeated.
///
/// Error    see make_limit_surfaces; uses of a contour agree to 1e-9 of the cage's diagonal (test
///          CageModel.UsesOfAContourAgree), but for Chaikin creases of changing sharpness, where
///          they may differ by 1e-3: a warning tells
/// Throws   InvalidInput for a cage that cannot be subdivided, or of which no face has a limit
///          surface; InvalidOption
Model model_from_cage(const Cage& cage, const CageOptions& options = {});

}  // namespace surfmesh
