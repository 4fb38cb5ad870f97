// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/surface.hh"
#include "surfmesh/metric/space_metric.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh {

/// The size that fields give where they ask for none: far above hmax, whatever the units. Beyond
/// its square, determinants of metrics would leave the range of numbers.
inline constexpr double kNoWish = 1e40;

/// A mesh with sizes, or a metric, at its vertices: from an earlier run, a solver, another program.
struct BackgroundMesh {
  std::vector<Vec3> points;                         ///< in space; in (u,v), z does not count
  std::vector<std::array<int, 3>> triangles = {};   ///< not looked at beside tetrahedra
  std::vector<std::array<int, 4>> tetrahedra = {};  ///< in space only
  std::vector<double> sizes = {};                   ///< by point, model units; else
  /// By point; in (u,v), xx, xy and yy are those of M in (u,v).
  std::vector<SpaceMetric> metrics = {};
  /// How far from the mesh it counts, in its units; unset: as far as the longest side of the
  /// element that is nearest, so that chords of curved surfaces do.
  std::optional<double> reach = {};
};

/// What the coordinates of a background mesh are.
enum class BackgroundIn { Space, Uv };

/// Sizes between the vertices of a background mesh.
///
/// Sizes are linear in each element, as finite elements and viewers have them. Metrics are
/// log-Euclidean (Arsigny et al. 2006): their logarithms are linear, so areas, and the least and
/// greatest lengths over all directions, stay between those at the vertices; means of metrics or of
/// lengths would swell where directions turn. Outside of the
/// mesh, the value at its nearest point holds within the reach; beyond that, nothing is asked for.
/// Immutable: several threads may ask at once.
class BackgroundSizes {
 public:
  /// Throws   InvalidInput, naming the vertex or element from 0, for no elements, a vertex that is
  ///          out of range or not finite, neither sizes nor metrics or other than one by point, a
  ///          size that is not positive and finite, a metric that is not positive definite, a
  ///          reach that is not above 0; values at points that no element uses are not looked at
  /// Cost     O(n log n)
  BackgroundSizes(BackgroundMesh mesh, BackgroundIn in);
  ~BackgroundSizes();

  bool has_metrics() const;
  BackgroundIn in() const;

  /// The size at a point, in space or (u,v,0); kNoWish beyond the reach.
  /// Cost     O(log n) (tests/bench/background_bench.cc)
  /// Pre      has no metrics
  double size(const Vec3& point) const;

  /// The metric at a point; that of kNoWish beyond the reach.
  /// Cost     as size, and an exponential of a matrix
  /// Pre      has metrics
  SpaceMetric metric(const Vec3& point) const;

 private:
  friend FieldSource background_field(std::shared_ptr<const BackgroundSizes> background, int patch,
                                      std::shared_ptr<const Surface> surface);
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

/// A source of the sizes of a background mesh in a patch. A metric in space M becomes JᵀMJ in (u,v)
/// with the derivatives J of the surface.
///
/// Bounds hold for sizes, so that no small one can hide, and for metrics in space. For metrics in
/// (u,v) they hold as far as first forms at the vertices are those between them.
/// Cost     O(n) evaluations of the surface for a metric in (u,v), else O(1)
/// Throws   InvalidInput for a metric in (u,v) that is not positive definite at its vertices
FieldSource background_field(std::shared_ptr<const BackgroundSizes> background, int patch,
                             std::shared_ptr<const Surface> surface);

}  // namespace surfmesh
