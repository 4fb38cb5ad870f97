// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// What fit_cage made of a cage.
struct CageFit {
  std::optional<SurfaceFit> fit;  ///< unset for a limit surface
  Notices notices;
};

/// Give a cage the creases, and the points, of the surface that the options ask for.
///
/// With SurfaceKind::Auto it stays a cage unless is_mesh_of_surface, or a fit is asked for. For a
/// limit surface, its edges become creases by the angle of the options. For an interpolating one,
/// its features are tagged, see tag_features, and its points become those of interpolating_cage.
/// Vertices beside which the surface would fold are passed by, and where that does not help, faces
/// are kept flat. Notices say what was taken, and why, and where the surface misses points, has
/// waves or still folds, or the mesh noise.
///
/// Pre      scheme is not Auto
/// Throws   InvalidOption; InvalidInput for a cage that cannot be subdivided
/// Cost     5 µs a face, for each of up to 7 rounds where the surface folds; with a fit, or for a
///          noisy mesh, 20 to 100 µs; least squares take far longer, see interpolating_cage
CageFit fit_cage(const CageOptions& options, Scheme scheme, Cage& cage);

}  // namespace surfmesh::detail
