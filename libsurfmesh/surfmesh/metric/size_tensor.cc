// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/size_tensor.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// H = mean·1 + radius·(cos 2α, sin 2α; sin 2α, −cos 2α). Directions stay as the doubled angle's
/// cosine and sine: no trigonometry between two changes of the lengths.
struct Spectrum {
  double larger;
  double smaller;
  double cos2;
  double sin2;
};

Spectrum spectrum(const SizeTensor& h) {
  const double half_difference = 0.5 * (h.h11 - h.h22);
  const double radius = eigenvalue_radius(half_difference, h.h12);
  const double larger = 0.5 * (h.h11 + h.h22) + radius;
  if (radius == 0) return {larger, larger, 1, 0};
  // The determinant is exact for diagonal tensors, mean − radius is not.
  return {larger, determinant(h) / larger, half_difference / radius, h.h12 / radius};
}

SizeTensor with_lengths(const Spectrum& s, double larger, double smaller) {
  return size_tensor(larger, smaller, s.cos2, s.sin2);
}

}  // namespace

SizeTensor size_tensor(double l_s, double l_t, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {l_s * c * c + l_t * s * s, (l_s - l_t) * c * s, l_s * s * s + l_t * c * c};
}

PrincipalSizes principal_sizes(const SizeTensor& h) {
  const Spectrum s = spectrum(h);
  return {s.larger, s.smaller, 0.5 * std::atan2(s.sin2, s.cos2)};
}

SizeTensor clamp_sizes(const SizeTensor& h, double hmin, double hmax) {
  const Spectrum s = spectrum(h);
  if (s.smaller >= hmin && s.larger <= hmax) return h;
  return with_lengths(s, std::clamp(s.larger, hmin, hmax), std::clamp(s.smaller, hmin, hmax));
}

SizeTensor log_size(const SizeTensor& h) {
  const Spectrum s = spectrum(h);
  return with_lengths(s, std::log(s.larger), std::log(s.smaller));
}

SizeTensor exp_size(const SizeTensor& log_h) {
  // Not by spectrum(): eigenvalues of a logarithm may have any sign.
  const double mean = 0.5 * (log_h.h11 + log_h.h22);
  const double half_difference = 0.5 * (log_h.h11 - log_h.h22);
  const double radius = eigenvalue_radius(half_difference, log_h.h12);
  const double larger = std::exp(mean + radius), smaller = std::exp(mean - radius);
  if (radius == 0) return {larger, 0, larger};
  return with_lengths({larger, smaller, half_difference / radius, log_h.h12 / radius}, larger,
                      smaller);
}

SizeTensor limit_stretch(const SizeTensor& h, double stretch) {
  const Spectrum s = spectrum(h);
  const double most = stretch * s.smaller;
  return s.larger <= most ? h : with_lengths(s, most, s.smaller);
}

SizeTensor size_from_metric(const FirstFormFactor& p, const Metric& m) {
  // H² = N = M_pᵀ M⁻¹ M_p, and √N = (N + √det N) / √(tr N + 2 √det N) for 2×2 matrices.
  const double det = determinant(m);
  const double b11 = (m.m22 * p.l11 - m.m12 * p.l21) / det, b12 = -m.m12 * p.l22 / det;
  const double b21 = (m.m11 * p.l21 - m.m12 * p.l11) / det, b22 = m.m11 * p.l22 / det;
  const double n11 = p.l11 * b11 + p.l21 * b21, n12 = p.l11 * b12 + p.l21 * b22;
  const double n22 = p.l22 * b22;
  const double root = p.l11 * p.l22 / std::sqrt(det);
  const double scale = 1 / std::sqrt(n11 + n22 + 2 * root);
  return {scale * (n11 + root), scale * n12, scale * (n22 + root)};
}

}  // namespace surfmesh
