// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/metric/tensor.hh"

namespace surfmesh::testing {

/// Unit steps evenly over half a turn.
inline std::vector<Uv> directions(int count = 64) {
  std::vector<Uv> result;
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * i / count;
    result.push_back({std::cos(angle), std::sin(angle)});
  }
  return result;
}

/// Length that a size tensor wants in a direction: 1 / |H⁻¹ d|.
inline double wanted_length(const SizeTensor& h, Uv d) {
  return determinant(h) / std::hypot(h.h22 * d.u - h.h12 * d.v, h.h11 * d.v - h.h12 * d.u);
}

/// Length that a metric wants in a direction.
inline double wanted_length(const Metric& m, Uv d) { return 1 / std::sqrt(squared_length(m, d)); }

/// Size tensors of lengths from 0.1 to 1 and aspects up to `aspect`, in all directions.
inline std::vector<SizeTensor> random_sizes(int count, double aspect, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<SizeTensor> result;
  for (int i = 0; i < count; ++i) {
    const double l_t = 0.1 * std::pow(10, unit(random));
    const double l_s = l_t * std::pow(aspect, unit(random));
    result.push_back(size_tensor(l_s, l_t, std::numbers::pi * unit(random)));
  }
  return result;
}

/// The metric of a size tensor in an orthonormal frame.
inline Metric metric_of(const SizeTensor& h) { return metric_from_size({1, 0, 1}, h); }

/// H seen from a frame that is turned by −angle: its lengths then lie `angle` further.
inline SizeTensor rotated(const SizeTensor& h, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * c * h.h11 - 2 * c * s * h.h12 + s * s * h.h22,
          c * s * (h.h11 - h.h22) + (c * c - s * s) * h.h12,
          s * s * h.h11 + 2 * c * s * h.h12 + c * c * h.h22};
}

/// The same metric for parameters that are multiplied by u_scale and v_scale.
inline Metric with_scaled_parameters(const Metric& m, double u_scale, double v_scale) {
  return {m.m11 / (u_scale * u_scale), m.m12 / (u_scale * v_scale), m.m22 / (v_scale * v_scale)};
}

/// Expect that two size tensors differ by at most `tolerance` of the largest entry.
inline void expect_near(const SizeTensor& a, const SizeTensor& b, double tolerance) {
  const double bound = tolerance * std::max(std::abs(b.h11), std::abs(b.h22));
  EXPECT_NEAR(a.h11, b.h11, bound);
  EXPECT_NEAR(a.h12, b.h12, bound);
  EXPECT_NEAR(a.h22, b.h22, bound);
}

/// Expect that two metrics differ by at most `tolerance`, each parameter on its own scale.
inline void expect_near(const Metric& a, const Metric& b, double tolerance) {
  EXPECT_NEAR(a.m11, b.m11, tolerance * b.m11);
  EXPECT_NEAR(a.m12, b.m12, tolerance * std::sqrt(b.m11 * b.m22));
  EXPECT_NEAR(a.m22, b.m22, tolerance * b.m22);
}

}  // namespace surfmesh::testing
