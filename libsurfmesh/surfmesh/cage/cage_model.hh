// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// What becomes a patch of a cage: a face, a rectangular block of faces, or a region of faces over
/// a plane. Auto: see model_from_cage.
enum class PatchKind { Auto, Faces, Blocks, Regions };

/// Which surface a cage stands for: its limit surface, or that of the same connectivity which
/// passes through its points. Auto: the second for what is a fine mesh of a surface, see
/// mesh_or_cage.
enum class SurfaceKind { Auto, Limit, Interpolate };

/// How a cage becomes a model.
struct CageOptions {
  Scheme scheme = Scheme::Auto;  ///< subdivision scheme
  int approximation_level = 8;   ///< 1 to 10, see make_limit_surfaces
  PatchKind patches = PatchKind::Auto;
  /// Vertices of the cage become one within this distance, of which shares are those of the cage's
  /// diagonal; 0 is off, and so is unset.
  std::optional<Length> weld = {};
  std::optional<bool> orient = {};  ///< turn faces to agree with their neighbours; unset is off
  /// Edges where two faces meet at more than this angle become creases, degrees up to 180; 0 is
  /// off. See add_creases. Unset is off for limit surfaces and kFeatureAngle for interpolating
  /// ones.
  std::optional<double> crease_angle = {};
  SurfaceKind surface = SurfaceKind::Auto;
  /// How far an interpolating surface may stay from the points, which damps noise and waves; 0, and
  /// unset, is through all of them. See interpolating_cage. Shares are those of the cage's
  /// diagonal.
  std::optional<Length> fit = {};
};

/// Make a model of the limit surface of a cage. Each block, region or face becomes a patch, and
/// model vertices are at their limit positions.
///
/// A block is a rectangle of m × n quads, as large as possible, with parameters in [0,m] × [0,n]
/// that run smoothly across its faces. It ends at creases, sharp or semi-sharp, at boundaries and
/// at the borders of groups; irregular vertices lie on its border. Only Catmull-Clark cages have
/// blocks. A region is a number of connected faces that lie over a plane (see gather_regions), with
/// coordinates in it as parameters; bilinear cages have none. PatchKind::Auto takes blocks or, if
/// there are none, single faces; but regions where these are half as many, and the others 200.
///
/// If a face of a Catmull-Clark or bilinear cage is not a quad, the cage is refined once first. See
/// make_regular for faces that cannot be used; faces without a limit surface (see
/// make_limit_surfaces) are left out, too.
///
/// A contour runs along edges of the cage from one model vertex to the next; between regions that
/// join smoothly, beside them (see model_of_regions). Model vertices are the corners of blocks, all
/// vertices where the number of borders is not two, the ends of creases, and the corners of true
/// boundaries beside holes.
/// The side of a block is a chain of contours. A contour of three or more patches has as many uses;
/// a ring of faces uses one twice. The side of a face that has the same vertex twice in a row is a
/// degenerate contour.
///
/// A patch is named `f<face>` after the first of its faces or, if the cage is refined,
/// `f<face>.<k>`, where k is the corner of the face at which its part lies. Patches are in the
/// order of these faces. A contour is named `e<vertex>-<vertex>` after the vertices of the cage or
/// of the refined cage; one of several edges is named `e<vertex>-<vertex>..<vertex>` after its
/// first edge and its last vertex. Each group of the cage becomes a group of the model. Surfaces
/// tell their places on the cage as given (see cage_surface.hh), a copy of which each patch holds.
/// Notices are about tags that make no sense and are ignored, and about cages that are not what
/// they seem (see mend_cage); those of the cage itself are not repeated.
///
/// Cost     a few milliseconds for 1,000 faces, in addition to the limit surfaces
/// Error    see make_limit_surfaces; uses of a contour agree to 1e-9 of the cage's diagonal (test
///          CageModel.UsesOfAContourAgree), those between regions to 1e-8 (see model_of_regions),
///          except for Chaikin creases of changing sharpness, where they may differ by 1e-3, with a
///          warning
/// Throws   InvalidInput for a cage that cannot be subdivided or has no face with a limit surface;
///          InvalidOption
Model model_from_cage(const Cage& cage, const CageOptions& options = {});

}  // namespace surfmesh
