// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/nurbs_surface.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/surface_checks.hh"
#include "surfmesh/nurbs/full_knots.hh"

namespace surfmesh {
namespace {

using Vector4 = Eigen::Vector4d;

/// Derivatives below this share of the greatest one are rounding: it is far above the rounding of
/// an evaluation, 1e-16, and far below any derivative that means something.
constexpr double kNoiseShare = 1e-12;

/// Samples across a span that tell how great derivatives are.
constexpr int kSpanSamples = 3;

FullKnots knots_of(const NurbsNet& net, std::size_t direction) {
  return full_knots(net.knots[direction], net.degree[direction], net.periodic[direction]);
}

const NurbsNet& checked(const NurbsNet& net) {
  check(net);
  return net;
}

/// Check that a range lies within the knots, or is no longer than their period.
void check_range(const FullKnots& knots, double from, double to, std::string_view parameter) {
  const double rounding = knots.rounding();
  if (!(to - from > 2 * rounding)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the domain in {} has no width: from {} to {}", parameter, from, to));
  }
  if (knots.period > 0) {
    if (to - from <= knots.period + rounding) return;
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the domain is longer in {} than the period of the knots, {}",
                            parameter, knots.period));
  }
  if (from >= knots.from() - rounding && to <= knots.to() + rounding) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the domain in {} is from {} to {}, but the knots only reach from {} to "
                          "{}",
                          parameter, from, to, knots.from(), knots.to()));
}

/// The centre of the box of all points.
Vec3 centre_of(const NurbsNet& net) {
  Eigen::AlignedBox3d box;
  for (const std::vector<Vec3>& row : net.points) {
    for (const Vec3& point : row) box.extend(point);
  }
  return box.center();
}

bool has_uneven_weights(const NurbsNet& net) {
  if (net.weights.empty()) return false;
  const double first = net.weights.front().front();
  for (const std::vector<double>& row : net.weights) {
    if (std::any_of(row.begin(), row.end(), [&](double w) { return w != first; })) return true;
  }
  return false;
}

/// The points of a net by the numbers of the basis functions of its inner and outer direction.
class ControlPoints {
 public:
  ControlPoints(const NurbsNet& net, const Vec3& centre, bool is_rational, bool is_inner_u)
      : net_(net), centre_(centre), is_rational_(is_rational), is_inner_u_(is_inner_u) {}

  /// A point times its weight, relative to the centre, and the weight.
  Vector4 at(int inner, int outer) const {
    const auto row = static_cast<std::size_t>(is_inner_u_ ? outer : inner) % net_.points.size();
    const std::vector<Vec3>& points = net_.points[row];
    const auto column = static_cast<std::size_t>(is_inner_u_ ? inner : outer) % points.size();
    const double weight = is_rational_ ? net_.weights[row][column] : 1;
    Vector4 result;
    result << weight * (points[column] - centre_), weight;
    return result;
  }

 private:
  const NurbsNet& net_;
  const Vec3& centre_;
  bool is_rational_;
  bool is_inner_u_;
};

/// The basis functions of a span as polynomials (span_functions), and the number of the first.
struct SpanFunctions {
  std::vector<double> factors;
  int first = 0;
  int size = 0;

  double factor(int function, int power) const {
    return factors[static_cast<std::size_t>(function * size + power)];
  }
};

std::vector<SpanFunctions> functions_of(const FullKnots& knots, const KnotSpans& spans) {
  std::vector<SpanFunctions> result;
  for (int i = 0; i < spans.count(); ++i) {
    const int knot = spans.knot(i);
    result.push_back({span_functions(knots, knot), knot - knots.degree, knots.degree + 1});
  }
  return result;
}

/// Make the polynomial of a span: first of its rows along the inner direction, then across.
void make_polynomial(const ControlPoints& points, const SpanFunctions& inner,
                     const SpanFunctions& outer, Vector4* factors) {
  std::vector<Vector4> row(static_cast<std::size_t>(inner.size));
  for (int o = 0; o < outer.size; ++o) {
    std::fill(row.begin(), row.end(), Vector4::Zero());
    for (int i = 0; i < inner.size; ++i) {
      const Vector4 point = points.at(inner.first + i, outer.first + o);
      for (int k = 0; k < inner.size; ++k) {
        row[static_cast<std::size_t>(k)] += inner.factor(i, k) * point;
      }
    }
    for (int l = 0; l < outer.size; ++l) {
      for (int k = 0; k < inner.size; ++k) {
        factors[l * inner.size + k] += outer.factor(o, l) * row[static_cast<std::size_t>(k)];
      }
    }
  }
}

/// The value of a polynomial, its first derivative and half of its second one.
struct Powers {
  Vector4 value;
  Vector4 first;
  Vector4 half_second;
};

/// Sum the powers of s, up to the derivatives of an order.
template <int order>
inline void sum_powers(const Vector4* factors, int degree, double s, Powers& sum) {
  sum.value = factors[degree];
  if constexpr (order >= 1) sum.first.setZero();
  if constexpr (order >= 2) sum.half_second.setZero();
  for (int k = degree - 1; k >= 0; --k) {
    if constexpr (order >= 2) sum.half_second = sum.half_second * s + sum.first;
    if constexpr (order >= 1) sum.first = sum.first * s + sum.value;
    sum.value = sum.value * s + factors[k];
  }
}

/// A sum of powers of both directions: i for the inner one, o for the outer one.
struct DoublePowers {
  Vector4 value, i, o, ii, io, oo;
};

/// Sum the powers of both directions. Those of second order are halves but io.
template <int order>
inline void sum_double_powers(const Vector4* factors, int inner_degree, int outer_degree, double s,
                              double t, DoublePowers& sum) {
  Powers row;
  const Vector4* last = factors + outer_degree * (inner_degree + 1);
  sum_powers<order>(last, inner_degree, s, row);
  sum.value = row.value;
  if constexpr (order >= 1) sum.i = row.first, sum.o.setZero();
  if constexpr (order >= 2) sum.ii = row.half_second, sum.io.setZero(), sum.oo.setZero();
  for (int l = outer_degree - 1; l >= 0; --l) {
    last -= inner_degree + 1;
    sum_powers<order>(last, inner_degree, s, row);
    if constexpr (order >= 2) {
      sum.oo = sum.oo * t + sum.o;
      sum.io = sum.io * t + sum.i;
      sum.ii = sum.ii * t + row.half_second;
    }
    if constexpr (order >= 1) {
      sum.o = sum.o * t + sum.value;
      sum.i = sum.i * t + row.first;
    }
    sum.value = sum.value * t + row.value;
  }
}

/// The jet of a sum, with u for the inner direction; derivatives of a quotient if it is rational.
template <bool is_rational, int order>
inline Jet jet_of(const DoublePowers& sum, double slope_i, double slope_o) {
  Jet jet;
  const double a = is_rational ? 1 / sum.value[3] : 1;
  jet.point = a * sum.value.head<3>();
  if constexpr (order >= 1) {
    const double i = a * slope_i, o = a * slope_o;
    jet.du = i * sum.i.head<3>();
    jet.dv = o * sum.o.head<3>();
    const double wi = i * sum.i[3], wo = o * sum.o[3];
    if constexpr (is_rational) {
      jet.du -= wi * jet.point;
      jet.dv -= wo * jet.point;
    }
    if constexpr (order >= 2) {
      const double ii = 2 * i * slope_i, io = i * slope_o, oo = 2 * o * slope_o;
      jet.duu = ii * sum.ii.head<3>();
      jet.duv = io * sum.io.head<3>();
      jet.dvv = oo * sum.oo.head<3>();
      if constexpr (is_rational) {
        jet.duu -= 2 * wi * jet.du + ii * sum.ii[3] * jet.point;
        jet.duv -= wo * jet.du + wi * jet.dv + io * sum.io[3] * jet.point;
        jet.dvv -= 2 * wo * jet.dv + oo * sum.oo[3] * jet.point;
      }
    }
  }
  return jet;
}

}  // namespace

Domain knot_domain(const NurbsNet& net) {
  check(net);
  const FullKnots u = knots_of(net, 0), v = knots_of(net, 1);
  return {u.from(), u.to(), v.from(), v.to()};
}

NurbsSurface::NurbsSurface(const NurbsNet& net) : NurbsSurface(net, knot_domain(net)) {}

NurbsSurface::NurbsSurface(const NurbsNet& net, const Domain& domain)
    : domain_(domain),
      is_inner_u_(checked(net).degree[0] >= net.degree[1]),
      is_rational_(has_uneven_weights(net)),
      centre_(centre_of(net)) {
  check(domain);
  const FullKnots u = knots_of(net, 0), v = knots_of(net, 1);
  check_range(u, domain.u0, domain.u1, "u");
  check_range(v, domain.v0, domain.v1, "v");
  const KnotSpans along_u(u, domain.u0, domain.u1), along_v(v, domain.v0, domain.v1);
  cells_ = {along_u.lines(), along_v.lines()};
  inner_ = is_inner_u_ ? along_u : along_v;
  outer_ = is_inner_u_ ? along_v : along_u;
  inner_degree_ = std::max(u.degree, v.degree);
  outer_degree_ = std::min(u.degree, v.degree);
  make_polynomials(net, is_inner_u_ ? u : v, is_inner_u_ ? v : u);
  measure_noise();
}

void NurbsSurface::make_polynomials(const NurbsNet& net, const FullKnots& inner,
                                    const FullKnots& outer) {
  const ControlPoints points(net, centre_, is_rational_, is_inner_u_);
  const std::vector<SpanFunctions> along = functions_of(inner, inner_);
  const std::vector<SpanFunctions> across = functions_of(outer, outer_);
  const auto size = static_cast<std::size_t>((inner_degree_ + 1) * (outer_degree_ + 1));
  factors_.assign(size * along.size() * across.size(), Vector4::Zero());
  Vector4* factors = factors_.data();
  for (const SpanFunctions& o : across) {
    for (const SpanFunctions& i : along) {
      make_polynomial(points, i, o, factors);
      factors += size;
    }
  }
}

/// Find how great derivatives are, and from it what is rounding.
void NurbsSurface::measure_noise() {
  const CellCount count = cells();
  Noise greatest;
  const auto grow = [](double& most, const Vec3& value) { most = std::max(most, value.norm()); };
  for (int j = 0; j <= (kSpanSamples - 1) * count.v; ++j) {
    for (int i = 0; i <= (kSpanSamples - 1) * count.u; ++i) {
      const Uv uv = from_cells({static_cast<double>(i) / (kSpanSamples - 1),
                                static_cast<double>(j) / (kSpanSamples - 1)});
      const Jet jet = evaluate(uv, Order::Second);
      grow(greatest.du, jet.du);
      grow(greatest.dv, jet.dv);
      grow(greatest.duu, jet.duu);
      grow(greatest.dvv, jet.dvv);
    }
  }
  noise_ = {kNoiseShare * greatest.du, kNoiseShare * greatest.dv, kNoiseShare * greatest.duu,
            kNoiseShare * greatest.dvv};
}

/// At a pole, p_u is 0 and so is p_uu. Where only p_u is 0, as at a cusp, p_uu stays; p_uv always
/// does, since it tells the shape around a pole.
void NurbsSurface::drop_noise(Jet& jet, Order order) const {
  const auto is_below = [](const Vec3& value, double noise) {
    return value.squaredNorm() <= noise * noise;
  };
  if (is_below(jet.du, noise_.du)) {
    jet.du.setZero();
    if (order == Order::Second && is_below(jet.duu, noise_.duu)) jet.duu.setZero();
  }
  if (is_below(jet.dv, noise_.dv)) {
    jet.dv.setZero();
    if (order == Order::Second && is_below(jet.dvv, noise_.dvv)) jet.dvv.setZero();
  }
}

template <bool is_rational, int order>
Jet NurbsSurface::evaluate_to(Uv uv) const {
  const KnotSpans::Place inner = inner_.place(is_inner_u_ ? uv.u : uv.v);
  const KnotSpans::Place outer = outer_.place(is_inner_u_ ? uv.v : uv.u);
  const auto size = static_cast<std::size_t>((inner_degree_ + 1) * (outer_degree_ + 1));
  const auto row = static_cast<std::size_t>(outer.span) * static_cast<std::size_t>(inner_.count());
  const std::size_t span = row + static_cast<std::size_t>(inner.span);
  DoublePowers sum;
  sum_double_powers<order>(factors_.data() + span * size, inner_degree_, outer_degree_, inner.s,
                           outer.s, sum);
  Jet jet = jet_of<is_rational, order>(sum, inner.slope, outer.slope);
  jet.point += centre_;
  if (!is_inner_u_) {
    std::swap(jet.du, jet.dv);
    std::swap(jet.duu, jet.dvv);
  }
  return jet;
}

template <bool is_rational>
Jet NurbsSurface::evaluate_as(Uv uv, Order order) const {
  if (order == Order::Position) return evaluate_to<is_rational, 0>(uv);
  return order == Order::First ? evaluate_to<is_rational, 1>(uv) : evaluate_to<is_rational, 2>(uv);
}

Jet NurbsSurface::evaluate(Uv uv, Order order) const {
  Jet jet = is_rational_ ? evaluate_as<true>(uv, order) : evaluate_as<false>(uv, order);
  check_finite(jet, uv, order);
  if (order != Order::Position) drop_noise(jet, order);
  return jet;
}

}  // namespace surfmesh
