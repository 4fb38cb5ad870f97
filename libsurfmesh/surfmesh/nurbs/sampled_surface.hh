// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "surfmesh/core/length.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/geometry/surface.hh"

namespace surfmesh {

/// Points of a grid of equal steps over a rectangle, its borders included.
struct PointGrid {
  std::size_t columns = 0;   ///< points along u
  std::size_t rows = 0;      ///< points along v
  std::vector<Vec3> points;  ///< row by row
};

/// A spline of degree 5 in u and v through the points of a grid. Its derivatives are continuous up
/// to the fourth.
///
/// Where all points of a side are equal (a pole), the derivatives along it are exactly 0: what
/// remains by rounding is dropped.
///
/// Error    steps⁶ for smooth functions, up to the borders
/// Cost     an evaluation is O(36) points; memory is 24 bytes a point
class SampledSurface : public Surface {
 public:
  /// Throws   InvalidInput for a grid of fewer than 6 points in a direction or of another number of
  ///          points than it says, a point that is not finite, a domain that is no rectangle, empty
  ///          or infinite
  SampledSurface(const Domain& domain, const PointGrid& grid);

  Jet evaluate(Uv uv, Order order) const override;

  Domain domain() const override { return domain_; }

  /// Each of a few steps: a function that is well sampled does not change much in one.
  CellCount cells() const override;

 private:
  /// Derivatives below these are rounding.
  struct Noise {
    double first_u = 0;
    double first_v = 0;
    double second_u = 0;
    double second_v = 0;
  };

  void make_factors(const PointGrid& grid);
  void drop_noise(Jet& jet, Order order) const;

  Domain domain_;
  std::size_t columns_;  ///< cells
  std::size_t rows_;
  Vec3 centre_ = Vec3::Zero();  ///< what factors are relative to
  std::vector<Vec3> factors_;   ///< row by row
  Noise noise_;
};

/// A spline of degree 5 over t in [0,1] through points at equal steps of t.
class SampledCurve : public Curve {
 public:
  /// Throws   InvalidInput for fewer than 6 points, or one that is not finite
  explicit SampledCurve(const std::vector<Uv>& points);

  Uv evaluate(double t) const override;

 private:
  std::size_t cells_;
  std::vector<Uv> factors_;
  Uv start_;
  Uv end_;
};

/// A function of many points at once: the result has as many entries.
using BatchFunction = std::function<void(std::span<const Uv>, std::span<Vec3>)>;

/// Far below any element, and above the rounding of a function of some operations.
inline constexpr double kSamplingShare = 1e-8;  ///< of the diagonal

/// How far a surface may be from its function, and how many samples that may take.
struct SamplingOptions {
  /// Shares are of the diagonal of the samples' box.
  Length tolerance = Length::share(kSamplingShare);
  std::size_t max_samples = 4'000'000;
};

/// A surface made of samples of a function.
struct Sampling {
  std::shared_ptr<const SampledSurface> surface;
  double error = 0;             ///< greatest one measured, model units
  Uv worst = {};                ///< where
  std::size_t columns = 0;      ///< samples along u
  std::size_t rows = 0;         ///< samples along v
  std::size_t evaluations = 0;  ///< of the function, those of checks included
};

/// Points that a function gets at most in one call: its own arrays stay in the cache.
inline constexpr std::size_t kBatchSize = 65536;

/// Sample a function on finer and finer grids until the spline through the samples differs from it
/// by no more than the tolerance.
///
/// Errors are measured in the middle between samples, in each direction by itself, which then gets
/// twice as many; and at the end at 4,096 points that are on no grid.
///
/// Error    as told, measured at those points
/// Cost     twice to four times as many evaluations as the surface has samples, about 0.3 µs each
///          besides
/// Throws   as SampledSurface; InvalidOption for a tolerance that is not above 0; Geometry naming
///          (u,v) for a value that is not finite; Limit naming the error and where it is greatest
///          if max_samples do not do; whatever the function throws
Sampling sample_surface(const BatchFunction& function, const Domain& domain,
                        const SamplingOptions& options = {});

}  // namespace surfmesh
