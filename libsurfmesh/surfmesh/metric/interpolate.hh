// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Interpolate between two tensors of one frame, linear in H; exact where they are equal.
inline SizeTensor lerp(const SizeTensor& a, const SizeTensor& b, double t) {
  return {a.h11 + t * (b.h11 - a.h11), a.h12 + t * (b.h12 - a.h12), a.h22 + t * (b.h22 - a.h22)};
}

/// Average the size tensors of nodes, weighted by the inverse of their squared distances.
///
/// Linear in H. At a node the result is that node's tensor exactly, or the first one's if several
/// nodes lie there.
///
/// Units    squared distances in any one unit, 0 or more
/// Pre      as many distances as tensors, at least one
/// Source   paper, eq. (4) and (5)
/// Differs: H is averaged, not the matrix of eq. (2): the parameterisation is known exactly
inline SizeTensor interpolate(std::span<const SizeTensor> sizes,
                              std::span<const double> squared_distances) {
  const auto nearest = std::min_element(squared_distances.begin(), squared_distances.end());
  if (*nearest == 0) return sizes[static_cast<std::size_t>(nearest - squared_distances.begin())];
  const SizeTensor& first = sizes.front();
  double total = 0;
  SizeTensor sum{0, 0, 0};  // of differences from the first: exact where all tensors are equal
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    // Relative to the nearest: at most 1, however near that node is.
    const double weight = *nearest / squared_distances[i];
    total += weight;
    sum.h11 += weight * (sizes[i].h11 - first.h11);
    sum.h12 += weight * (sizes[i].h12 - first.h12);
    sum.h22 += weight * (sizes[i].h22 - first.h22);
  }
  const double scale = 1 / total;
  return {first.h11 + scale * sum.h11, first.h12 + scale * sum.h12, first.h22 + scale * sum.h22};
}

/// The same for exactly three nodes, with one division; exact where all tensors are equal.
inline SizeTensor interpolate(const std::array<SizeTensor, 3>& sizes,
                              const std::array<double, 3>& squared_distances) {
  const auto& [d0, d1, d2] = squared_distances;
  const double w0 = d1 * d2, w1 = d0 * d2, w2 = d0 * d1;
  // At a node, or where products leave the range of numbers.
  if (!std::isnormal(w2 * d2)) return interpolate(std::span(sizes), std::span(squared_distances));
  const double scale = 1 / (w0 + w1 + w2);
  const double s1 = scale * w1, s2 = scale * w2;
  const auto& [a, b, c] = sizes;
  return {a.h11 + (s1 * (b.h11 - a.h11) + s2 * (c.h11 - a.h11)),
          a.h12 + (s1 * (b.h12 - a.h12) + s2 * (c.h12 - a.h12)),
          a.h22 + (s1 * (b.h22 - a.h22) + s2 * (c.h22 - a.h22))};
}

/// Interpolate the size tensors at the corners of a triangle, counter-clockwise, linearly. A point
/// outside gets the value of a point on the rim.
///
/// Linear in H, so of second order, and continuous over neighbouring triangles. Exact at the
/// corners, and where all tensors are equal.
inline SizeTensor interpolate_linearly(const std::array<SizeTensor, 3>& sizes,
                                       const std::array<Uv, 3>& corners, Uv p) {
  const Uv to_a = corners[0] - p, to_b = corners[1] - p, to_c = corners[2] - p;
  const std::array<double, 3> areas = {std::max(0.0, cross(to_b, to_c)),
                                       std::max(0.0, cross(to_c, to_a)),
                                       std::max(0.0, cross(to_a, to_b))};
  const double total = areas[0] + areas[1] + areas[2];
  if (!(total > 0)) return sizes[0];
  // Differences from the corner that weighs most.
  const std::size_t i =
      areas[1] > areas[0] ? (areas[2] > areas[1] ? 2 : 1) : (areas[2] > areas[0] ? 2 : 0);
  const std::size_t j = i == 2 ? 0 : i + 1, k = j == 2 ? 0 : j + 1;
  const double s = areas[j] / total, t = areas[k] / total;
  const SizeTensor &a = sizes[i], &b = sizes[j], &c = sizes[k];
  return {a.h11 + (s * (b.h11 - a.h11) + t * (c.h11 - a.h11)),
          a.h12 + (s * (b.h12 - a.h12) + t * (c.h12 - a.h12)),
          a.h22 + (s * (b.h22 - a.h22) + t * (c.h22 - a.h22))};
}

}  // namespace surfmesh
