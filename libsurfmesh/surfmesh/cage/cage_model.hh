// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/cage/cage.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// What is a patch of a cage: a face, or a block of faces. Auto: blocks.
enum class PatchKind { Auto, Faces, Blocks };

/// How a cage becomes a model.
struct CageOptions {
  Scheme scheme = Scheme::Auto;  ///< subdivision scheme
  int approximation_level = 8;   ///< 1 to 10, see make_limit_surfaces
  PatchKind patches = PatchKind::Auto;
};

/// Make a model of the limit surface of a cage: each block of faces a patch, model vertices at
/// their limit positions.
///
/// A block is a rectangle of m × n quads, with parameters in [0,m] × [0,n] that run on over its
/// faces; it is as large as can be. It ends at creases, sharp or semi-sharp, at boundaries and at
/// the borders of groups, and vertices that are not regular are on its border. Blocks are there
/// under Catmull-Clark only; otherwise, and with PatchKind::Faces, each face is a patch. If a face
/// of a Catmull-Clark or bilinear cage is not a quad, the cage is refined once first. See
/// make_regular for faces that cannot be used; those without limit surface (see
/// make_limit_surfaces) are left out, too.
///
/// A contour runs along edges of the cage from one model vertex to the next; these are the corners
/// of blocks, all vertices where other than two borders meet, and the ends of creases. The side of
/// a block is a chain of contours. A contour of three and more patches has as many uses; a ring of
/// faces uses one twice. The side of a face that has the same vertex twice in a row is a degenerate
/// contour.
///
/// Patches are named f<face> after the first of their faces or, where the cage is refined,
/// f<face>.<k>, k the corner of the face that its part is at; they are in the order of these faces.
/// Contours are named e<vertex>-<vertex> after the vertices of the cage, or the refined one, those
/// of several edges e<vertex>-<vertex>..<vertex> after their first edge and their last vertex. Each
/// group of the cage becomes one of the model. The warnings are of tags that make no sense and are
/// ignored; those of the cage itself are not repeated.
///
/// Cost     beside the limit surfaces a few milliseconds for 1,000 faces
/// Error    see make_limit_surfaces; uses of a contour agree to 1e-9 of the cage's diagonal (test
///          CageModel.UsesOfAContourAgree), but for Chaikin creases of changing sharpness, where
///          they may differ by 1e-3: a warning tells
/// Throws   InvalidInput for a cage that cannot be subdivided, or of which no face has a limit
///          surface; InvalidOption
Model model_from_cage(const Cage& cage, const CageOptions& options = {});

}  // namespace surfmesh
