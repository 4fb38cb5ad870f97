// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/formula_bounds.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "surfmesh/formula/jump_bounds.hh"
#include "surfmesh/geometry/jet_number.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kGreatest = std::numeric_limits<double>::max();

/// Two errors of a function of the C library, of at most four units in the last place each: at the
/// end of the interval, and at a point inside. Arithmetic needs no such margin (core/interval.hh).
constexpr double kMargin = 8 * std::numeric_limits<double>::epsilon();

/// The same where the value is so small that its share of it rounds to 0.
constexpr double kLeastMargin = std::numeric_limits<double>::min();

/// Values at the ends of an interval on which a function is monotone, with a margin for its error.
/// Zero stays: libraries keep the sign of these functions.
Interval widened(double lower, double upper) {
  // What overflows at one end need not do so everywhere.
  const double last = std::min(lower, kGreatest), first = std::max(upper, -kGreatest);
  const double least = last - (kMargin * std::abs(last) + kLeastMargin);
  const double greatest = first + (kMargin * std::abs(first) + kLeastMargin);
  return defined(
      {lower >= 0 ? std::max(least, 0.0) : least, upper <= 0 ? std::min(greatest, 0.0) : greatest});
}

Interval widened(const Interval& x) { return widened(x.lower, x.upper); }

Interval clipped(const Interval& x, double lower, double upper) {
  return {std::clamp(x.lower, lower, upper), std::clamp(x.upper, lower, upper)};
}

template <class Function>
Interval increasing(const Interval& x, Function function) {
  return widened(function(x.lower), function(x.upper));
}

/// Of an increasing or decreasing function that is defined on a part of the numbers.
template <class Function>
Interval monotone_on(const Interval& domain, const Interval& x, Function function) {
  if (x.upper < domain.lower || x.lower > domain.upper) return {};
  const Interval part = clipped(x, domain.lower, domain.upper);
  const double first = function(part.lower), last = function(part.upper);
  return widened(std::min(first, last), std::max(first, last));
}

/// True if the interval holds one of the points first + k·period, or may do so by rounding.
bool meets(const Interval& x, double first, double period) {
  const double from = (x.lower - first) / period, to = (x.upper - first) / period;
  const double slack = kMargin * (1 + std::max(std::abs(from), std::abs(to)));
  return !(std::floor(to + slack) < from - slack);
}

/// Of sin or cos, by the places of one maximum and one minimum.
template <class Function>
Interval wave(const Interval& x, double maximum, double minimum, Function function) {
  if (!(x.width() < 2 * pi)) return {-1, 1};
  const double first = function(x.lower), last = function(x.upper);
  const Interval ends = clipped(widened(std::min(first, last), std::max(first, last)), -1, 1);
  return {meets(x, minimum, 2 * pi) ? -1 : ends.lower, meets(x, maximum, 2 * pi) ? 1 : ends.upper};
}

Interval tangent(const Interval& x) {
  if (!(x.width() < pi) || meets(x, 0.5 * pi, pi)) return {};
  return increasing(x, [](double t) { return std::tan(t); });
}

/// The angle of (x,y) grows or falls with each of both on either side of the cut, where y = 0 and
/// x < 0 and which belongs to the side above.
Interval angle(const Interval& y, const Interval& x) {
  const Interval all = {-pi, pi}, zero = {0, 0};
  if (x.lower < 0 && y.lower < 0 && y.upper >= 0) return all;
  // The sign of a zero decides.
  if ((y == zero && x.lower <= 0) || (x == zero && y.contains(0))) return all;
  // Adding 0 makes a zero positive.
  const double x0 = x.lower + 0.0, x1 = x.upper + 0.0, y0 = y.lower + 0.0, y1 = y.upper + 0.0;
  const Interval corners =
      hull({std::atan2(y0, x0), std::atan2(y0, x1), std::atan2(y1, x0), std::atan2(y1, x1)});
  return clipped(widened(corners), all.lower, all.upper);
}

Interval length(const Interval& a, const Interval& b) {
  const Interval x = abs(a), y = abs(b);
  return widened(std::hypot(x.lower, y.lower), std::hypot(x.upper, y.upper));
}

double power(double x, double c) { return pow(JetNumber<0>(x), c).value(); }

Interval even_power(const Interval& a, double c) {
  const Interval x = abs(a);
  return c > 0 ? widened(power(x.lower, c), power(x.upper, c))
               : widened(power(x.upper, c), power(x.lower, c));
}

Interval odd_power(const Interval& x, double c) {
  if (c > 0) return widened(power(x.lower, c), power(x.upper, c));
  if (x.lower < 0 && x.upper > 0) return {};
  if (x.lower == 0 && x.upper == 0) return {};
  return widened(power(x.upper == 0 ? -0.0 : x.upper, c), power(x.lower == 0 ? 0.0 : x.lower, c));
}

/// Negative numbers have no power, but −∞ has the limit of |x|^c in C.
Interval real_power(const Interval& x, double c) {
  if (x.lower == -kInfinity) return {0, kInfinity};
  return monotone_on({0, kInfinity}, x, [c](double t) { return power(t, c); });
}

Interval constant_power(const Interval& x, double c) {
  if (!std::isfinite(c)) return {};
  if (c == 0) return {1, 1};
  if (c != std::trunc(c)) return real_power(x, c);
  return std::fmod(c, 2) == 0 ? even_power(x, c) : odd_power(x, c);
}

/// x^y for x ≥ 0: monotone in each, so the extremes are at the corners.
Interval positive_power(const Interval& x, const Interval& y) {
  return widened(hull({std::pow(x.lower, y.lower), std::pow(x.lower, y.upper),
                       std::pow(x.upper, y.lower), std::pow(x.upper, y.upper)}));
}

/// Powers of negative numbers exist for integers y, and have either sign, as have those of −0.
Interval general_power(const Interval& x, const Interval& y) {
  if (x.lower == 0 && x.upper == 0 && y.lower < 0) return {};
  if (x.lower >= 0) return positive_power(abs(x), y);
  const double greatest = positive_power(abs(x), y).upper;
  return {-greatest, greatest};
}

/// Operations that jump; Select has an operand more.
Interval bound_jump(Operation operation, const Interval& a, const Interval& b) {
  switch (operation) {
    case Operation::Sign:
      return sign(a);
    case Operation::Floor:
      return floor(a);
    case Operation::Ceil:
      return ceil(a);
    case Operation::Mod:
      return mod(a, b);
    case Operation::Less:
      return is_less(a, b);
    case Operation::LessEqual:
      return is_less_equal(a, b);
    case Operation::Equal:
      return is_equal(a, b);
    default:
      return {};
  }
}

/// Operations of the C library, and powers.
Interval bound_function(const Instruction& step, const Interval& a, const Interval& b) {
  switch (step.operation) {
    case Operation::PowerOf:
      return constant_power(a, step.constant);
    case Operation::PowerBase:
      return general_power(defined(Interval::of(step.constant)), a);
    case Operation::Power:
      return general_power(a, b);
    case Operation::Cbrt:
      return increasing(a, [](double t) { return std::cbrt(t); });
    case Operation::Exp:
      return increasing(a, [](double t) { return std::exp(t); });
    case Operation::Log:
      return monotone_on({0, kInfinity}, a, [](double t) { return std::log(t); });
    case Operation::Sin:
      return wave(a, 0.5 * pi, -0.5 * pi, [](double t) { return std::sin(t); });
    case Operation::Cos:
      return wave(a, 0, pi, [](double t) { return std::cos(t); });
    case Operation::Tan:
      return tangent(a);
    case Operation::Asin:
      return monotone_on({-1, 1}, a, [](double t) { return std::asin(t); });
    case Operation::Acos:
      return monotone_on({-1, 1}, a, [](double t) { return std::acos(t); });
    case Operation::Atan:
      return increasing(a, [](double t) { return std::atan(t); });
    case Operation::Atan2:
      return angle(a, b);
    case Operation::Sinh:
      return increasing(a, [](double t) { return std::sinh(t); });
    case Operation::Cosh:
      return increasing(abs(a), [](double t) { return std::cosh(t); });
    case Operation::Tanh:
      return clipped(increasing(a, [](double t) { return std::tanh(t); }), -1, 1);
    case Operation::Hypot:
      return length(a, b);
    case Operation::Log10:
      return monotone_on({0, kInfinity}, a, [](double t) { return std::log10(t); });
    default:
      return bound_jump(step.operation, a, b);
  }
}

inline Interval bound_step(const Instruction& step, const Interval& a, const Interval& b) {
  const Interval c = Interval::of(step.constant);
  switch (step.operation) {
    case Operation::Negate:
      return -a;
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return a / b;
    case Operation::AddConstant:
      return a + c;
    case Operation::SubtractFrom:
      return c - a;
    case Operation::Scale:
      return a * c;
    case Operation::DivideByConstant:
      return a / c;
    case Operation::DivideConstant:
      return c / a;
    case Operation::Square:
      return square(a);
    case Operation::Sqrt:
      return sqrt(a);
    case Operation::Abs:
      return abs(a);
    case Operation::Min:
      return min(a, b);
    case Operation::Max:
      return max(a, b);
    default:
      return bound_function(step, a, b);
  }
}

}  // namespace

Interval bound_operation(const Instruction& step, const Interval& a, const Interval& b,
                         const Interval& d) {
  if (step.operation == Operation::Constant) return defined(Interval::of(step.constant));
  if (step.operation == Operation::Select) return select(a, b, d);
  return bound_step(step, a, b);
}

void bound_registers(const FormulaProgram& program, std::span<const Interval> variables,
                     std::span<Interval> registers) {
  std::ranges::copy(variables, registers.begin());
  std::size_t next = variables.size();
  for (const Instruction& step : program.instructions()) {
    const auto operand = [&](std::size_t i) -> const Interval& {
      return registers[static_cast<std::size_t>(step.operand[i])];
    };
    registers[next++] = bound_operation(step, operand(0), operand(1), operand(2));
  }
}

void bound(const FormulaProgram& program, std::span<const Interval> variables,
           std::span<Interval> results) {
  // Not initialised: each is written before it is read.
  double lower[FormulaProgram::kMaxRegisters], upper[FormulaProgram::kMaxRegisters];
  std::size_t next = 0;
  const auto write = [&](const Interval& x) {
    lower[next] = x.lower;
    upper[next++] = x.upper;
  };
  const auto read = [&](int i) { return Interval{lower[i], upper[i]}; };
  for (std::size_t i = 0; i < program.variable_count(); ++i) write(variables[i]);
  for (const Instruction& step : program.instructions()) {
    const auto [a, b, d] = step.operand;
    if (step.operation == Operation::Constant) {
      write(defined(Interval::of(step.constant)));
    } else if (step.operation == Operation::Select) {
      write(select(read(a), read(b), read(d)));
    } else {
      write(bound_step(step, read(a), read(b)));
    }
  }
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = read(program.results()[i]);
}

}  // namespace surfmesh
