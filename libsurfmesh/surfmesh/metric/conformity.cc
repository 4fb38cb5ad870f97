// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/conformity.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

SizeTensor difference(const SizeTensor& a, const SizeTensor& b) {
  return {a.h11 - b.h11, a.h12 - b.h12, a.h22 - b.h22};
}

}  // namespace

// From the symmetric matrix L⁻¹ (A − B) L⁻ᵀ with B = L Lᵀ: the discriminant of the characteristic
// polynomial would lose half of the digits where both eigenvalues are nearly equal.
double greatest_growth(const SizeTensor& a, const SizeTensor& b) {
  const SizeTensor d = difference(a, b);
  const double det = determinant(b);
  const double k = b.h12 / b.h11;
  const double c11 = d.h11 / b.h11;
  const double c12 = (d.h12 - k * d.h11) / std::sqrt(det);
  const double c22 = (d.h22 - 2 * k * d.h12 + k * k * d.h11) * b.h11 / det;
  return std::max(0.0, 0.5 * (c11 + c22) + eigenvalue_radius(0.5 * (c11 - c22), c12));
}

double entry_conformity(const SizeTensor& h_o, const SizeTensor& h_t) {
  const SizeTensor d = difference(h_o, h_t);
  const double e11 = d.h11 * h_t.h22 - d.h12 * h_t.h12;
  const double e12 = d.h12 * h_t.h11 - d.h11 * h_t.h12;
  const double e21 = d.h12 * h_t.h22 - d.h22 * h_t.h12;
  const double e22 = d.h22 * h_t.h11 - d.h12 * h_t.h12;
  return std::max({std::abs(e11), std::abs(e12), std::abs(e21), std::abs(e22)}) / determinant(h_t);
}

// max |ln λ| is the greater of ln λ_max both ways round: 1/λ_min is the greatest eigenvalue of the
// inverse ratio, and a small λ_min itself would be a difference of large numbers.
double log_conformity(const SizeTensor& h_o, const SizeTensor& h_t) {
  return std::log1p(std::max(greatest_growth(h_o, h_t), greatest_growth(h_t, h_o)));
}

// Metrics are squares of lengths.
double metric_conformity(const Metric& a, const Metric& b) {
  return 0.5 * log_conformity(SizeTensor{a.m11, a.m12, a.m22}, SizeTensor{b.m11, b.m12, b.m22});
}

}  // namespace surfmesh
