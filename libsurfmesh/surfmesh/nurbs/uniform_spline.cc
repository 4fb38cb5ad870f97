// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/uniform_spline.hh"

#include <algorithm>

namespace surfmesh {
namespace {

/// Values of the basis functions at a knot.
constexpr std::array kAtKnot = {1. / 120, 26. / 120, 66. / 120, 26. / 120, 1. / 120};
/// The jump of the fifth derivative at a knot: sixth differences of the factors.
constexpr std::array kJump = {1., -6., 15., -20., 15., -6., 1.};

/// Weights of degree d from those of degree d - 1.
template <std::size_t d>
std::array<double, d + 1> raised(const std::array<double, d>& lower, double s) {
  std::array<double, d + 1> weights{};
  for (std::size_t j = 0; j <= d; ++j) {
    const double rising = j > 0 ? (s + static_cast<double>(d - j)) * lower[j - 1] : 0;
    const double falling = j < d ? (1 - s + static_cast<double>(j)) * lower[j] : 0;
    weights[j] = (rising + falling) / static_cast<double>(d);
  }
  return weights;
}

/// Derivatives of weights that belong to these of one degree less.
template <std::size_t d>
std::array<double, d + 1> differences(const std::array<double, d>& lower) {
  std::array<double, d + 1> result{};
  for (std::size_t j = 0; j < d; ++j) {
    result[j] -= lower[j];
    result[j + 1] += lower[j];
  }
  return result;
}

}  // namespace

UniformSpline::UniformSpline(std::size_t cells) : cells_(cells), matrix_(control_count()) {
  fill();
  factorise();
}

void UniformSpline::fill() {
  const std::size_t count = control_count();
  for (std::size_t j = 0; j < kJump.size(); ++j) {
    for (const std::size_t row : {std::size_t{0}, std::size_t{1}}) {
      entry(row, row + j) = kJump[j];
      entry(count - 1 - row, count - 1 - row - j) = kJump[j];
    }
  }
  for (std::size_t row = 2; row + 2 < count; ++row) {
    for (std::size_t j = 0; j < kAtKnot.size(); ++j) entry(row, row - 2 + j) = kAtKnot[j];
  }
}

void UniformSpline::factorise() {
  const std::size_t count = control_count();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t end = std::min(count, k + kBand + 1);
    for (std::size_t row = k + 1; row < end; ++row) {
      const double factor = entry(row, k) / entry(k, k);
      entry(row, k) = factor;
      if (factor == 0) continue;
      for (std::size_t column = k + 1; column < end; ++column) {
        entry(row, column) -= factor * entry(k, column);
      }
    }
  }
}

void UniformSpline::solve(double* rows, std::size_t width) const {
  const std::size_t count = control_count();
  const auto subtract = [&](std::size_t from, std::size_t row, double factor) {
    if (factor == 0) return;
    const double* source = rows + from * width;
    double* target = rows + row * width;
    for (std::size_t i = 0; i < width; ++i) target[i] -= factor * source[i];
  };
  std::fill_n(rows, 2 * width, 0.);
  std::fill_n(rows + (count - 2) * width, 2 * width, 0.);
  for (std::size_t row = 1; row < count; ++row) {
    for (std::size_t k = row - std::min(row, kBand); k < row; ++k) {
      subtract(k, row, matrix_[row][kBand + k - row]);
    }
  }
  for (std::size_t row = count; row-- > 0;) {
    const std::size_t end = std::min(count, row + kBand + 1);
    for (std::size_t k = row + 1; k < end; ++k) subtract(k, row, matrix_[row][kBand + k - row]);
    const double pivot = 1 / matrix_[row][kBand];
    for (std::size_t i = 0; i < width; ++i) rows[row * width + i] *= pivot;
  }
}

SplineBasis spline_basis(double s) {
  const std::array<double, 2> linear = {1 - s, s};
  const auto cubic = raised<3>(raised<2>(linear, s), s);
  const auto quartic = raised<4>(cubic, s);
  return {raised<5>(quartic, s), differences(quartic), differences(differences(cubic))};
}

}  // namespace surfmesh
