// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A number that carries its derivatives with respect to two parameters, up to order 0, 1 or 2.
///
/// Arithmetic on it, as on a double, gives exact derivatives; formulas and callables are evaluated
/// this way. Eigen's AutoDiffScalar would have to be nested for second derivatives: that computes
/// duv twice, returns expressions that dangle when stored in `auto`, and lacks pow with two
/// variables, hypot, cbrt and the order 0.
///
/// The value is the same bit for bit at every order, and so are the first derivatives. A default
/// constructed number is not initialised, like a double; JetNumber() is zero. Comparisons compare
/// values only, so a callable may branch.
///
/// Where a derivative does not exist it is not finite, except abs'(0) = 0; min and max have the
/// derivatives of the operand they return, the first of two equal ones. A value that is not a
/// number is never hidden by min or max.
template <int order>
class JetNumber {
  static_assert(order >= 0 && order <= 2);

 public:
  static constexpr int kSize = (order + 1) * (order + 2) / 2;

  JetNumber() = default;

  /// A constant: all its derivatives are 0.
  constexpr JetNumber(double value) : members_{value} {}  // NOLINT: mixes with double like double

  /// The first (index 0, u) or second (index 1, v) parameter itself.
  static constexpr JetNumber parameter(double value, int index) {
    JetNumber result(value);
    if constexpr (order >= 1) result.members_[static_cast<std::size_t>(1 + index)] = 1;
    return result;
  }

  constexpr double value() const { return members_[0]; }
  constexpr double du() const requires(order >= 1) { return members_[1]; }
  constexpr double dv() const requires(order >= 1) { return members_[2]; }
  constexpr double duu() const requires(order >= 2) { return members_[3]; }
  constexpr double duv() const requires(order >= 2) { return members_[4]; }
  constexpr double dvv() const requires(order >= 2) { return members_[5]; }

  JetNumber& operator+=(const JetNumber& b) { return *this = *this + b; }
  JetNumber& operator-=(const JetNumber& b) { return *this = *this - b; }
  JetNumber& operator*=(const JetNumber& b) { return *this = *this * b; }
  JetNumber& operator/=(const JetNumber& b) { return *this = *this / b; }

  friend JetNumber operator+(const JetNumber& a) { return a; }
  friend JetNumber operator-(const JetNumber& a) {
    return each([&](std::size_t i) { return -a.members_[i]; });
  }

  friend JetNumber operator+(const JetNumber& a, const JetNumber& b) {
    return each([&](std::size_t i) { return a.members_[i] + b.members_[i]; });
  }
  friend JetNumber operator+(JetNumber a, double b) {
    a.members_[0] += b;
    return a;
  }
  friend JetNumber operator+(double a, const JetNumber& b) { return b + a; }

  friend JetNumber operator-(const JetNumber& a, const JetNumber& b) {
    return each([&](std::size_t i) { return a.members_[i] - b.members_[i]; });
  }
  friend JetNumber operator-(JetNumber a, double b) {
    a.members_[0] -= b;
    return a;
  }
  friend JetNumber operator-(double a, const JetNumber& b) {
    JetNumber result = -b;
    result.members_[0] = a - b.members_[0];
    return result;
  }

  friend JetNumber operator*(const JetNumber& x, const JetNumber& y) {
    const Members& a = x.members_;
    const Members& b = y.members_;
    JetNumber result;
    Members& r = result.members_;
    r[0] = a[0] * b[0];
    if constexpr (order >= 1) {
      r[1] = a[0] * b[1] + a[1] * b[0];
      r[2] = a[0] * b[2] + a[2] * b[0];
    }
    if constexpr (order >= 2) {
      r[3] = a[0] * b[3] + a[3] * b[0] + 2 * (a[1] * b[1]);
      r[4] = a[0] * b[4] + a[4] * b[0] + (a[1] * b[2] + a[2] * b[1]);
      r[5] = a[0] * b[5] + a[5] * b[0] + 2 * (a[2] * b[2]);
    }
    return result;
  }
  friend JetNumber operator*(const JetNumber& a, double b) {
    return each([&](std::size_t i) { return a.members_[i] * b; });
  }
  friend JetNumber operator*(double a, const JetNumber& b) { return b * a; }

  friend JetNumber operator/(const JetNumber& x, const JetNumber& y) {
    const Members& a = x.members_;
    const Members& b = y.members_;
    JetNumber result;
    Members& r = result.members_;
    r[0] = a[0] / b[0];
    if constexpr (order >= 1) {
      r[1] = (a[1] - r[0] * b[1]) / b[0];
      r[2] = (a[2] - r[0] * b[2]) / b[0];
    }
    if constexpr (order >= 2) {
      r[3] = (a[3] - r[0] * b[3] - 2 * (r[1] * b[1])) / b[0];
      r[4] = (a[4] - r[0] * b[4] - (r[1] * b[2] + r[2] * b[1])) / b[0];
      r[5] = (a[5] - r[0] * b[5] - 2 * (r[2] * b[2])) / b[0];
    }
    return result;
  }
  friend JetNumber operator/(const JetNumber& a, double b) {
    return each([&](std::size_t i) { return a.members_[i] / b; });
  }
  friend JetNumber operator/(double a, const JetNumber& b) { return JetNumber(a) / b; }

  friend bool operator==(const JetNumber& a, const JetNumber& b) { return a.value() == b.value(); }
  friend auto operator<=>(const JetNumber& a, const JetNumber& b) {
    return a.value() <=> b.value();
  }

  /// f(x) of a function f with value f0 and derivatives f1, f2 at x: the chain rule.
  friend JetNumber chain(const JetNumber& number, double f0, double f1, double f2) {
    const Members& x = number.members_;
    JetNumber result;
    Members& r = result.members_;
    r[0] = f0;
    if constexpr (order >= 1) {
      r[1] = f1 * x[1];
      r[2] = f1 * x[2];
    }
    if constexpr (order >= 2) {
      r[3] = f1 * x[3] + f2 * (x[1] * x[1]);
      r[4] = f1 * x[4] + f2 * (x[1] * x[2]);
      r[5] = f1 * x[5] + f2 * (x[2] * x[2]);
    }
    return result;
  }

  /// Value and partial derivatives of a function of two numbers.
  struct Partials {
    double f = 0;
    double fa = 0, fb = 0;
    double faa = 0, fab = 0, fbb = 0;
  };

  /// f(a,b) of a function of two numbers: the chain rule.
  friend JetNumber chain(const JetNumber& first, const JetNumber& second, const Partials& p) {
    const Members& a = first.members_;
    const Members& b = second.members_;
    JetNumber result;
    Members& r = result.members_;
    r[0] = p.f;
    if constexpr (order >= 1) {
      r[1] = p.fa * a[1] + p.fb * b[1];
      r[2] = p.fa * a[2] + p.fb * b[2];
    }
    if constexpr (order >= 2) {
      r[3] = p.fa * a[3] + p.fb * b[3] + p.faa * (a[1] * a[1]) + p.fbb * (b[1] * b[1]) +
             2 * p.fab * (a[1] * b[1]);
      r[4] = p.fa * a[4] + p.fb * b[4] + p.faa * (a[1] * a[2]) + p.fbb * (b[1] * b[2]) +
             p.fab * (a[1] * b[2] + a[2] * b[1]);
      r[5] = p.fa * a[5] + p.fb * b[5] + p.faa * (a[2] * a[2]) + p.fbb * (b[2] * b[2]) +
             2 * p.fab * (a[2] * b[2]);
    }
    return result;
  }

  friend JetNumber sqrt(const JetNumber& x) {
    const double f = std::sqrt(x.value());
    if constexpr (order == 0) return f;
    const double f1 = 0.5 / f;
    return chain(x, f, f1, -0.5 * f1 / x.value());
  }
  friend JetNumber cbrt(const JetNumber& x) {
    const double f = std::cbrt(x.value());
    if constexpr (order == 0) return f;
    const double f1 = 1 / (3 * f * f);
    return chain(x, f, f1, -2 * f1 / (3 * x.value()));
  }
  friend JetNumber exp(const JetNumber& x) {
    const double f = std::exp(x.value());
    return chain(x, f, f, f);
  }
  friend JetNumber log(const JetNumber& x) {
    const double f1 = 1 / x.value();
    return chain(x, std::log(x.value()), f1, -f1 * f1);
  }

  friend JetNumber sin(const JetNumber& x) {
    const double f = std::sin(x.value());
    if constexpr (order == 0) return f;
    return chain(x, f, std::cos(x.value()), -f);
  }
  friend JetNumber cos(const JetNumber& x) {
    const double f = std::cos(x.value());
    if constexpr (order == 0) return f;
    return chain(x, f, -std::sin(x.value()), -f);
  }
  friend JetNumber tan(const JetNumber& x) {
    const double f = std::tan(x.value());
    const double f1 = 1 + f * f;
    return chain(x, f, f1, 2 * f * f1);
  }
  friend JetNumber asin(const JetNumber& x) {
    const double f = std::asin(x.value());
    if constexpr (order == 0) return f;
    const double f1 = 1 / std::sqrt((1 - x.value()) * (1 + x.value()));
    return chain(x, f, f1, x.value() * f1 * f1 * f1);
  }
  friend JetNumber acos(const JetNumber& x) {
    const double f = std::acos(x.value());
    if constexpr (order == 0) return f;
    const double f1 = -1 / std::sqrt((1 - x.value()) * (1 + x.value()));
    return chain(x, f, f1, x.value() * f1 * f1 * f1);
  }
  friend JetNumber atan(const JetNumber& x) {
    const double f1 = 1 / (1 + x.value() * x.value());
    return chain(x, std::atan(x.value()), f1, -2 * x.value() * f1 * f1);
  }

  friend JetNumber sinh(const JetNumber& x) {
    const double f = std::sinh(x.value());
    if constexpr (order == 0) return f;
    return chain(x, f, std::cosh(x.value()), f);
  }
  friend JetNumber cosh(const JetNumber& x) {
    const double f = std::cosh(x.value());
    if constexpr (order == 0) return f;
    return chain(x, f, std::sinh(x.value()), f);
  }
  friend JetNumber tanh(const JetNumber& x) {
    const double f = std::tanh(x.value());
    if constexpr (order == 0) return f;
    // 1 − f² would lose all digits where f is near ±1.
    const double c = std::cosh(x.value());
    const double f1 = 1 / (c * c);
    return chain(x, f, f1, -2 * f * f1);
  }

  friend JetNumber abs(const JetNumber& x) {
    const double f1 = x.value() > 0 ? 1 : x.value() < 0 ? -1 : 0;
    return chain(x, std::abs(x.value()), f1, 0);
  }
  friend JetNumber min(const JetNumber& a, const JetNumber& b) {
    return b.value() < a.value() || std::isnan(b.value()) ? b : a;
  }
  friend JetNumber max(const JetNumber& a, const JetNumber& b) {
    return b.value() > a.value() || std::isnan(b.value()) ? b : a;
  }

  friend JetNumber hypot(const JetNumber& a, const JetNumber& b) {
    const double f = std::hypot(a.value(), b.value());
    if constexpr (order == 0) return f;
    const double fa = a.value() / f;
    const double fb = b.value() / f;
    return chain(a, b, {f, fa, fb, fb * fb / f, -fa * fb / f, fa * fa / f});
  }

  /// The angle of the point (x,y), in radians.
  friend JetNumber atan2(const JetNumber& y, const JetNumber& x) {
    const double f = std::atan2(y.value(), x.value());
    if constexpr (order == 0) return f;
    const double d = x.value() * x.value() + y.value() * y.value();
    const double fy = x.value() / d;
    const double fx = -y.value() / d;
    return chain(y, x, {f, fy, fx, 2 * fx * fy, fx * fx - fy * fy, -2 * fx * fy});
  }

  /// x to a constant power; powers that are small integers by multiplication, any sign of x.
  friend JetNumber pow(const JetNumber& x, double c) {
    if (c == 2) return square(x);
    if (c == 0) return 1;
    if (c == 1) return x;
    if (std::abs(c) <= kMultipliedPower && c == std::trunc(c)) {
      return integer_power(x, static_cast<int>(c));
    }
    return real_power(x, c);
  }

  /// A constant to the power of x.
  friend JetNumber pow(double c, const JetNumber& x) {
    const double f = std::pow(c, x.value());
    if constexpr (order == 0) return f;
    // 0^x is constant for x > 0, whatever log(0) says.
    const double l = c == 0 && x.value() > 0 ? 0 : std::log(c);
    return chain(x, f, f * l, f * l * l);
  }

  friend JetNumber pow(const JetNumber& x, const JetNumber& y) {
    const double a = x.value();
    const double b = y.value();
    const double f = std::pow(a, b);
    if constexpr (order == 0) return f;
    const double power1 = std::pow(a, b - 1);
    const double fa = b * power1;
    if (a == 0 && b > 0) {  // the limits: a^b log(a) and a^(b-1) log(a) for b > 1 go to 0
      const double fab = b > 1 ? 0 : std::log(a);
      return chain(x, y, {f, fa, 0, second_power_derivative(a, b), fab, 0});
    }
    const double l = std::log(a);
    return chain(x, y,
                 {f, fa, f * l, second_power_derivative(a, b), power1 * (1 + b * l), f * l * l});
  }

  friend JetNumber square(const JetNumber& x) {
    return chain(x, x.value() * x.value(), 2 * x.value(), 2);
  }

 private:
  using Members = std::array<double, static_cast<std::size_t>(kSize)>;

  /// Up to here multiplication is faster than pow, with an error of at most as many roundings
  /// (test JetNumberPower.ByMultiplicationIsAccurate).
  static constexpr double kMultipliedPower = 16;

  template <class Function>
  static JetNumber each(Function function) {
    JetNumber result;
    for (std::size_t i = 0; i < kSize; ++i) result.members_[i] = function(i);
    return result;
  }

  static double positive_power(double x, int n) {
    double result = 1;
    for (; n > 0; n /= 2) {
      if (n % 2 == 1) result *= x;
      x *= x;
    }
    return result;
  }

  static JetNumber integer_power(const JetNumber& x, int n) {
    if (n > 0) {
      const double second = positive_power(x.value(), n - 2);
      const double first = second * x.value();
      return chain(x, first * x.value(), n * first, n * (n - 1) * second);
    }
    const double reciprocal = 1 / x.value();
    const double f = 1 / positive_power(x.value(), -n);
    const double f1 = n * f * reciprocal;
    return chain(x, f, f1, (n - 1) * f1 * reciprocal);
  }

  static JetNumber real_power(const JetNumber& x, double c) {
    const double f = std::pow(x.value(), c);
    if constexpr (order == 0) return f;
    if (x.value() == 0) {
      return chain(x, f, c * std::pow(0.0, c - 1), second_power_derivative(0, c));
    }
    const double f1 = c * f / x.value();
    return chain(x, f, f1, (c - 1) * f1 / x.value());
  }

  /// b (b−1) a^(b−2), 0 for b = 0 and 1 also where a = 0.
  static double second_power_derivative(double a, double b) {
    const double factor = b * (b - 1);
    return factor == 0 ? 0 : factor * std::pow(a, b - 2);
  }

  Members members_;  // value, du, dv, duu, duv, dvv as far as the order goes
};

}  // namespace surfmesh

namespace Eigen {

/// Lets vectors and matrices hold jet numbers.
template <int order>
struct NumTraits<surfmesh::JetNumber<order>> : NumTraits<double> {
  using Real = surfmesh::JetNumber<order>;
  using NonInteger = surfmesh::JetNumber<order>;
  using Nested = surfmesh::JetNumber<order>;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = surfmesh::JetNumber<order>::kSize,
    AddCost = surfmesh::JetNumber<order>::kSize,
    MulCost = 3 * surfmesh::JetNumber<order>::kSize
  };
};

/// Eigen multiplies vectors of such numbers by plain ones.
template <int order, class Operation>
struct ScalarBinaryOpTraits<surfmesh::JetNumber<order>, double, Operation> {
  using ReturnType = surfmesh::JetNumber<order>;
};
/// In the other order, too.
template <int order, class Operation>
struct ScalarBinaryOpTraits<double, surfmesh::JetNumber<order>, Operation> {
  using ReturnType = surfmesh::JetNumber<order>;
};

}  // namespace Eigen
