// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/geometry/quasirandom.hh"
#include "surfmesh/geometry/surface_checks.hh"
#include "surfmesh/nurbs/sampled_surface.hh"

namespace surfmesh {
namespace {

/// Steps along each direction of the first grid.
constexpr std::size_t kFirstSteps = 8;

/// Points on no grid at which the result is checked.
constexpr int kIndependentPoints = 4096;

/// The greatest difference so far, and where.
struct Greatest {
  double error = 0;
  Uv at;

  void take(double other, Uv uv) {
    if (other > error) *this = {other, uv};
  }
  void take(const Greatest& other) { take(other.error, other.at); }
};

/// Samples of a function at a grid, and in the middle of its steps along u, along v, and both.
class Sampler {
 public:
  Sampler(const BatchFunction& function, const Domain& domain, const SamplingOptions& options)
      : function_(function), domain_(domain), options_(options) {}

  Sampling run() {
    check(domain_);
    if (!options_.tolerance.is_legal() || options_.tolerance.value <= 0) {
      throw Error(ErrorCode::InvalidOption,
                  fmt::format("tolerance = {} is not above 0", to_text(options_.tolerance)));
    }
    grid_ = sampled(kFirstSteps + 1, kFirstSteps + 1, 0, 0);
    while (true) {
      Sampling result = measured();
      if (greatest_.error <= tolerance()) return result;
      refine();
    }
  }

 private:
  std::size_t steps_u() const { return grid_.columns - 1; }
  std::size_t steps_v() const { return grid_.rows - 1; }

  double tolerance() const { return options_.tolerance.in_units(box_.diagonal().norm()); }

  /// Points of the grid moved by these shares of a step.
  std::vector<Uv> places(std::size_t columns, std::size_t rows, double shift_u,
                         double shift_v) const {
    const double steps_u = static_cast<double>(columns) - (shift_u > 0 ? 0 : 1);
    const double steps_v = static_cast<double>(rows) - (shift_v > 0 ? 0 : 1);
    std::vector<Uv> uvs;
    uvs.reserve(columns * rows);
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        uvs.push_back(domain_.at((static_cast<double>(i) + shift_u) / steps_u,
                                 (static_cast<double>(j) + shift_v) / steps_v));
      }
    }
    return uvs;
  }

  std::vector<Vec3> values(const std::vector<Uv>& uvs) {
    std::vector<Vec3> points(uvs.size());
    for (std::size_t i = 0; i < uvs.size(); i += kBatchSize) {
      const std::size_t count = std::min(kBatchSize, uvs.size() - i);
      function_(std::span(uvs).subspan(i, count), std::span(points).subspan(i, count));
    }
    for (std::size_t i = 0; i < uvs.size(); ++i) {
      if (points[i].allFinite()) {
        box_.extend(points[i]);
        continue;
      }
      throw Error(ErrorCode::Geometry,
                  fmt::format("the surface is not finite at (u,v) = ({}, {}): ({}, {}, {})",
                              uvs[i].u, uvs[i].v, points[i].x(), points[i].y(), points[i].z()));
    }
    evaluations_ += uvs.size();
    return points;
  }

  PointGrid sampled(std::size_t columns, std::size_t rows, double shift_u, double shift_v) {
    return {columns, rows, values(places(columns, rows, shift_u, shift_v))};
  }

  static Greatest difference(const SampledSurface& surface, const std::vector<Uv>& uvs,
                             const std::vector<Vec3>& points) {
    std::vector<double> errors(uvs.size());
    share_ranges(uvs.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        errors[i] = (surface.evaluate(uvs[i], Order::Position).point - points[i]).norm();
      }
    });
    Greatest greatest;
    for (std::size_t i = 0; i < uvs.size(); ++i) greatest.take(errors[i], uvs[i]);
    return greatest;
  }

  /// The surface through the grid, with its error in the middle of steps and, where that is small
  /// enough, beside.
  Sampling measured() {
    Sampling result;
    result.surface = std::make_shared<const SampledSurface>(domain_, grid_);
    const auto measure = [&](PointGrid& middles, double shift_u, double shift_v) {
      const auto uvs = places(steps_u() + (shift_u > 0 ? 0 : 1), steps_v() + (shift_v > 0 ? 0 : 1),
                              shift_u, shift_v);
      middles = {shift_u > 0 ? steps_u() : grid_.columns, shift_v > 0 ? steps_v() : grid_.rows,
                 values(uvs)};
      return difference(*result.surface, uvs, middles.points);
    };
    const Greatest along_u = measure(middles_u_, 0.5, 0), along_v = measure(middles_v_, 0, 0.5);
    Greatest within = measure(middles_, 0.5, 0.5);
    is_fine_u_ = along_u.error <= tolerance();
    is_fine_v_ = along_v.error <= tolerance();
    if (is_fine_u_ && is_fine_v_ && within.error <= tolerance())
      within.take(beside(*result.surface));
    greatest_ = along_u;
    greatest_.take(along_v);
    greatest_.take(within);
    result.error = greatest_.error;
    result.worst = greatest_.at;
    result.columns = grid_.columns;
    result.rows = grid_.rows;
    result.evaluations = evaluations_;
    return result;
  }

  Greatest beside(const SampledSurface& surface) {
    std::vector<Uv> uvs;
    for (int i = 1; i <= kIndependentPoints; ++i) uvs.push_back(quasirandom_point(domain_, i));
    return difference(surface, uvs, values(uvs));
  }

  /// Halve steps along u, along v, or both. All values are known already.
  void refine() {
    const bool is_both = is_fine_u_ == is_fine_v_;
    const bool in_u = is_both || !is_fine_u_, in_v = is_both || !is_fine_v_;
    PointGrid finer{
        in_u ? 2 * steps_u() + 1 : grid_.columns, in_v ? 2 * steps_v() + 1 : grid_.rows, {}};
    if (finer.columns * finer.rows > options_.max_samples) throw_too_coarse();
    finer.points.reserve(finer.columns * finer.rows);
    for (std::size_t j = 0; j < finer.rows; ++j) {
      for (std::size_t i = 0; i < finer.columns; ++i) {
        const bool is_new_u = in_u && i % 2 == 1, is_new_v = in_v && j % 2 == 1;
        const PointGrid& from =
            is_new_u ? (is_new_v ? middles_ : middles_u_) : (is_new_v ? middles_v_ : grid_);
        finer.points.push_back(from.points[(in_v ? j / 2 : j) * from.columns + (in_u ? i / 2 : i)]);
      }
    }
    grid_ = std::move(finer);
  }

  [[noreturn]] void throw_too_coarse() const {
    throw Error(ErrorCode::Limit,
                fmt::format("the surface through {} x {} samples is still {:.3g} off its function "
                            "at (u,v) = ({}, {}), more than the tolerance of {:.3g}: a function "
                            "that bends sharply needs a patch on either side, or a greater "
                            "tolerance",
                            grid_.columns, grid_.rows, greatest_.error, greatest_.at.u,
                            greatest_.at.v, tolerance()));
  }

  const BatchFunction& function_;
  Domain domain_;
  SamplingOptions options_;
  Eigen::AlignedBox3d box_;  ///< of all values
  PointGrid grid_;
  PointGrid middles_u_;  ///< in the middle of steps along u, at the rows of the grid
  PointGrid middles_v_;
  PointGrid middles_;  ///< in the middle of both
  Greatest greatest_;
  bool is_fine_u_ = false;
  bool is_fine_v_ = false;
  std::size_t evaluations_ = 0;
};

}  // namespace

Sampling sample_surface(const BatchFunction& function, const Domain& domain,
                        const SamplingOptions& options) {
  return Sampler(function, domain, options).run();
}

}  // namespace surfmesh
