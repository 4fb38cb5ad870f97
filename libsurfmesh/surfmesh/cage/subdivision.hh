// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The one header that shows OpenSubdiv's types; for sources of this folder and their tests only.

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <string>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/cage_surface.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// A cage's topology as OpenSubdiv holds it, with its tags.
struct CageTopology {
  std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner;
  Notices notices;  ///< tags that make no sense and were ignored
};

/// Check that all faces are triangles, as Loop's scheme needs them. `numbers` are those that faces
/// have in messages, for cages from which some were left out; empty for their own.
///
/// Throws   InvalidInput, naming the first face that is none
void check_triangles(const Cage& cage, const std::vector<int>& numbers = {});

/// Give a cage with its tags to OpenSubdiv.
///
/// Everything that OpenSubdiv would refuse, or warn of, is looked for here first, because it
/// reports through callbacks that are global to the process and print by default. So nothing is
/// printed, and an application's own callbacks stay as they are.
/// Pre      scheme is not Auto
/// Throws   InvalidInput: see check(const Cage&), and a face that is no triangle under Loop
CageTopology make_topology(const Cage& cage, Scheme scheme);

/// How limit surfaces are evaluated.
struct LimitSurfaceOptions {
  int approximation_level = 8;  ///< 1 to 10, for smooth and sharp features
  /// Catmull-Clark faces, and squares of them, that are bicubics as such, not through Bfr.
  bool is_regular_by_hand = true;
};

/// Make the limit surfaces of the faces of a refiner's base level; see make_limit_surfaces. `faces`
/// tells for each of them what it is of the cage as given; empty for the same faces.
std::vector<std::shared_ptr<const Surface>> make_limit_surfaces(
    const OpenSubdiv::Far::TopologyRefiner& refiner, const std::vector<Vec3>& points,
    const LimitSurfaceOptions& options, const std::vector<FaceOfCage>& faces = {});

}  // namespace surfmesh
