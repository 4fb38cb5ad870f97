// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/metric/minimum.hh"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// Ratios of lengths this near to 1 count as equal: above rounding at aspect 1e6, so that taking
/// the minimum with the same tensor again changes nothing and sweeps come to rest.
constexpr double kEqualLengths = 1e-10;

struct Matrix2 {
  double a11, a12, a21, a22;
};

/// A turn that makes the columns of K V orthogonal, and the singular values of K in their order.
struct ColumnTurn {
  double c, s;
  double first, second;
};

struct Direction {
  double c, s;
};

/// Half the angle of a vector (x, y), between −π/2 and π/2; 0 for the zero vector.
Direction half_angle(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0)) return {1, 0};
  const double greater = std::sqrt(0.5 * (1 + std::abs(x) / length));
  const double other = 0.5 * std::abs(y) / (length * greater);
  const double c = x >= 0 ? greater : other, s = x >= 0 ? other : greater;
  return {c, y < 0 ? -s : s};
}

ColumnTurn orthogonalise_columns(const Matrix2& k) {
  const double n1 = k.a11 * k.a11 + k.a21 * k.a21;
  const double n2 = k.a12 * k.a12 + k.a22 * k.a22;
  const auto [c, s] = half_angle(n1 - n2, 2 * (k.a11 * k.a12 + k.a21 * k.a22));
  const double x = k.a11 * c + k.a12 * s, y = k.a21 * c + k.a22 * s;
  const double first = std::sqrt(x * x + y * y);
  // From the determinant, for the second column may cancel.
  return {c, s, first, std::abs(k.a11 * k.a22 - k.a12 * k.a21) / first};
}

/// H_b⁻¹ H_a, exactly the identity for equal tensors.
Matrix2 relative(const SizeTensor& a, const SizeTensor& b) {
  const double det = determinant(b);
  return {(b.h22 * a.h11 - b.h12 * a.h12) / det, (b.h22 * a.h12 - b.h12 * a.h22) / det,
          (b.h11 * a.h12 - b.h12 * a.h11) / det, (b.h11 * a.h22 - b.h12 * a.h12) / det};
}

/// The symmetric polar factor √(G Gᵀ) = (G Gᵀ + |det G|) / √(‖G‖² + 2 |det G|).
SizeTensor left_polar_factor(const Matrix2& g, double det) {
  const double n11 = g.a11 * g.a11 + g.a12 * g.a12;
  const double n12 = g.a11 * g.a21 + g.a12 * g.a22;
  const double n22 = g.a21 * g.a21 + g.a22 * g.a22;
  const double scale = 1 / std::sqrt(n11 + n22 + 2 * det);
  return {scale * (n11 + det), scale * n12, scale * (n22 + det)};
}

/// Half the difference of the two lengths of a size tensor.
double radius_of(const SizeTensor& h) { return eigenvalue_radius(0.5 * (h.h11 - h.h22), h.h12); }

/// An order that does not depend on which argument comes first.
bool is_before(const SizeTensor& a, const SizeTensor& b) {
  return std::tie(a.h11, a.h12, a.h22) < std::tie(b.h11, b.h12, b.h22);
}

}  // namespace

// With S = A + B and D = A − B the common directions are the eigenvectors of S⁻¹D, whose
// eigenvalues lie in [−1, 1]. The greater metric along each is ½ (S + |D|), |D| taken with respect
// to S. By Cayley and Hamilton |D| = ±D where both eigenvalues have one sign (one metric is nowhere
// longer), else |D| = (τ D − 2δ S) / √(τ² − 4δ) with τ, δ the trace and determinant of S⁻¹D. No
// eigenvectors: they turn arbitrarily where the metrics are nearly equal. Nothing but S has to be
// regular, and a change of parameters changes nothing but rounding.
Metric minimum(const Metric& a, const Metric& b) {
  const Metric s{a.m11 + b.m11, a.m12 + b.m12, a.m22 + b.m22};
  const Metric d{a.m11 - b.m11, a.m12 - b.m12, a.m22 - b.m22};
  const double det = determinant(s);
  // Both singular along one direction: one is a multiple of the other.
  if (det <= 0) return d.m11 + d.m22 >= 0 ? a : b;
  const double trace = (s.m22 * d.m11 - 2 * s.m12 * d.m12 + s.m11 * d.m22) / det;
  const double delta = determinant(d) / det;
  if (delta >= 0) return trace >= 0 ? a : b;
  const double scale = 0.5 / std::sqrt(trace * trace - 4 * delta);
  const double of_s = 0.5 - 2 * scale * delta, of_d = scale * trace;
  return {of_s * s.m11 + of_d * d.m11, of_s * s.m12 + of_d * d.m12, of_s * s.m22 + of_d * d.m22};
}

// With K = H_b⁻¹ H_a = U Σ Vᵀ the metrics are M_a = H_a⁻¹ V Vᵀ H_a⁻¹ and M_b = H_a⁻¹ V Σ² Vᵀ H_a⁻¹.
// The greater one along each direction is G⁻ᵀ G⁻¹ with G = H_a V / max(1, Σ), and its size tensor
// √(G Gᵀ). The way through the metrics themselves squares the aspect: at 1e6 the larger length is
// then right to four digits only.
SizeTensor minimum(const SizeTensor& a, const SizeTensor& b) {
  // Most pairs: the greater length of one is below the smaller length of the other.
  const double half_difference = 0.5 * (a.h11 + a.h22 - b.h11 - b.h22);
  const double radii = radius_of(a) + radius_of(b);
  if (half_difference <= -radii) return a;
  if (half_difference >= radii) return b;
  if (is_before(b, a)) return minimum(b, a);
  const ColumnTurn v = orthogonalise_columns(relative(a, b));
  const auto [least, greatest] = std::minmax(v.first, v.second);
  if (greatest <= 1 + kEqualLengths) return a;
  if (least >= 1 - kEqualLengths) return b;
  const double f1 = 1 / std::max(1.0, v.first), f2 = 1 / std::max(1.0, v.second);
  const Matrix2 g{f1 * (a.h11 * v.c + a.h12 * v.s), f2 * (a.h12 * v.c - a.h11 * v.s),
                  f1 * (a.h12 * v.c + a.h22 * v.s), f2 * (a.h22 * v.c - a.h12 * v.s)};
  return left_polar_factor(g, f1 * f2 * determinant(a));
}

}  // namespace surfmesh
