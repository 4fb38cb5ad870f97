// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "pictures/scene.hh"

namespace surfmesh {

/// A plane over the samples of a picture, between the depths of the corners of a triangle.
class DepthPlane {
 public:
  /// `corners` are in samples.
  explicit DepthPlane(const std::array<ScenePoint, 3>& corners);

  double at(double x, double y) const;

 private:
  ScenePoint origin_;
  double slope_x_ = 0;
  double slope_y_ = 0;
  double least_;
  double greatest_;
};

/// Which triangle is in front, at several samples a pixel.
class DepthBuffer {
 public:
  /// Of the pixels from (0,0) to (width,height), with `samples` samples along each side of a pixel.
  /// Cost     O(triangles and the samples that they cover)
  DepthBuffer(const Scene& scene, std::size_t width, std::size_t height, int samples);

  int samples() const { return samples_; }
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }

  /// Index of the triangle in front at a sample, -1 for none. Where several have one depth, the
  /// first.
  int front(std::size_t column, std::size_t row) const { return front_[row * columns_ + column]; }

  /// True if nothing is in front of a point of the scene, at one of the samples around it; a
  /// quarter of a pixel of depth counts as nothing.
  bool is_visible(const ScenePoint& point) const;

  /// A point in samples, moved to a fine lattice on which it is known exactly what is inside.
  ScenePoint on_lattice(const ScenePoint& point) const;

  /// A triangle of such points.
  std::array<ScenePoint, 3> corners(const SceneTriangle& triangle) const;

 private:
  class Rows;

  const Scene& scene_;
  int samples_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<int> front_;
};

/// Call `body(column, row)` for each sample of `first_row` ≤ row < `end_row` inside a triangle or
/// on its rim.
template <class Body>
void for_samples_in(const std::array<ScenePoint, 3>& corners, std::size_t columns,
                    std::size_t first_row, std::size_t end_row, Body body) {
  const auto& [a, b, c] = corners;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(area > 0) && !(area < 0)) return;
  const double sign = area > 0 ? 1 : -1;
  const auto first_in = [](double low, std::size_t from, std::size_t end) {
    // Samples are in the middle of their squares.
    const double at = std::ceil(low - 0.5);
    return at <= double(from) ? from : at >= double(end) ? end : static_cast<std::size_t>(at);
  };
  const std::size_t top = first_in(std::min({a.y, b.y, c.y}), first_row, end_row);
  const std::size_t left = first_in(std::min({a.x, b.x, c.x}), 0, columns);
  const double right = std::max({a.x, b.x, c.x}), bottom = std::max({a.y, b.y, c.y});
  const auto side = [sign](const ScenePoint& p, const ScenePoint& q, double x, double y) {
    return sign * ((q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x));
  };
  for (std::size_t row = top; row < end_row && double(row) + 0.5 <= bottom; ++row) {
    const double y = double(row) + 0.5;
    bool was_inside = false;
    for (std::size_t column = left; column < columns && double(column) + 0.5 <= right; ++column) {
      const double x = double(column) + 0.5;
      const bool is_inside =
          side(a, b, x, y) >= 0 && side(b, c, x, y) >= 0 && side(c, a, x, y) >= 0;
      if (is_inside) body(column, row);
      if (was_inside && !is_inside) break;
      was_inside = is_inside;
    }
  }
}

}  // namespace surfmesh
