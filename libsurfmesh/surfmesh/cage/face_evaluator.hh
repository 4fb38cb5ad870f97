// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <vector>

#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// The limit surface over one face as OpenSubdiv evaluates it.
class FaceEvaluator {
 public:
  virtual ~FaceEvaluator() = default;

  /// Pre      uv is in the domain of the face
  virtual Jet evaluate(Uv uv, Order order) const = 0;
};

/// One face by itself, from OpenSubdiv's Bfr. It holds all it needs, so neither the topology nor
/// the factory has to live on.
///
/// Cost     for a face at a vertex of n faces O(n²) time and O(n) memory: each of its O(n) points
///          is a sum of O(n) of the cage's points
std::unique_ptr<const FaceEvaluator> make_bfr_evaluator(
    const OpenSubdiv::Bfr::Surface<double>& surface, const std::vector<Vec3>& cage_points);

/// Several faces that share one adaptive refinement, by OpenSubdiv's Far. They are the same patches
/// as those of Bfr at this level of approximation, but for rounding.
///
/// Pre      faces of the refiner's base level that have a limit surface; all faces of that level
///          are quads or, for Loop, triangles
/// Returns  the evaluators in the order of `faces`
/// Cost     O(n) for the n faces around a vertex, 0.2 ms each
std::vector<std::unique_ptr<const FaceEvaluator>> make_shared_evaluators(
    const OpenSubdiv::Far::TopologyRefiner& refiner, const std::vector<Vec3>& cage_points,
    const std::vector<int>& faces, int approximation_level);

}  // namespace surfmesh
