// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/nurbs/full_knots.hh"

#include <algorithm>
#include <cmath>

namespace surfmesh {
namespace {

/// Knots that differ by rounding become equal to the first of them.
void unite_equal(std::vector<double>& knots, double rounding) {
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i] - knots[i - 1] <= rounding) knots[i] = knots[i - 1];
  }
}

/// Knot i of one that goes on periodically; `one` has the knots of a period with both ends.
double periodic_knot(const std::vector<double>& one, int i) {
  const int count = static_cast<int>(one.size()) - 1;
  const int turn = i >= 0 ? i / count : -((count - 1 - i) / count);
  return one[static_cast<std::size_t>(i - turn * count)] + turn * (one.back() - one.front());
}

/// Add factor · (at + step·s) · function to a sum of polynomials.
void add_product(const double* function, int degree, double at, double step, double* sum) {
  for (int k = 0; k <= degree; ++k) {
    sum[k] += at * function[k];
    sum[k + 1] += step * function[k];
  }
}

}  // namespace

int FullKnots::multiplicity(double knot) const {
  return static_cast<int>(std::count(knots.begin(), knots.end(), knot));
}

FullKnots full_knots(const std::vector<double>& given, int degree, bool is_periodic) {
  std::vector<double> knots = given;
  unite_equal(knots, kKnotRounding * (knots.back() - knots.front()));
  if (!is_periodic) return {knots, degree, static_cast<int>(knots.size()) - degree - 1, 0};
  FullKnots result;
  result.degree = degree;
  result.point_count = static_cast<int>(knots.size()) - 1;
  result.period = knots.back() - knots.front();
  for (int i = -degree; i <= result.point_count + degree; ++i) {
    result.knots.push_back(periodic_knot(knots, i));
  }
  unite_equal(result.knots, kKnotRounding * result.period);
  return result;
}

std::vector<double> span_functions(const FullKnots& knots, int knot) {
  const int size = knots.degree + 1;
  const double middle = (knots[knot] + knots[knot + 1]) / 2;
  const double half = (knots[knot + 1] - knots[knot]) / 2;
  const auto row = [&](std::vector<double>& rows, int r) { return rows.data() + r * size; };
  std::vector<double> functions(static_cast<std::size_t>(size * size), 0.0);
  functions[0] = 1;
  // Cox and de Boor: those of degree d from those of degree d - 1. Function r of degree d begins at
  // knot - d + r.
  for (int d = 1; d < size; ++d) {
    std::vector<double> next(functions.size(), 0.0);
    for (int r = 0; r < d; ++r) {
      const double begin = knots[knot - d + 1 + r], end = knots[knot + 1 + r];
      const double width = end - begin;
      const double* function = row(functions, r);
      add_product(function, d - 1, (end - middle) / width, -half / width, row(next, r));
      add_product(function, d - 1, (middle - begin) / width, half / width, row(next, r + 1));
    }
    functions = std::move(next);
  }
  return functions;
}

}  // namespace surfmesh
