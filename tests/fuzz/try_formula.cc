// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fuzz/checks.hh"
#include "fuzz/targets.hh"
#include "surfmesh/formula/find_breaks.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_bounds.hh"
#include "surfmesh/geometry/jet_number.hh"

namespace surfmesh::fuzz {
namespace {

const std::vector<std::string> kVariables = {"u", "v"};
constexpr double kPlaces[] = {-2, -0.5, 0, 1e-3, 0.5, 1, 3};
constexpr double kWidths[] = {0, 0.5, 4};

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

template <int order>
JetNumber<order> number_of(const FormulaProgram& program, Uv uv) {
  const std::array variables = {JetNumber<order>::parameter(uv.u, 0),
                                JetNumber<order>::parameter(uv.v, 1)};
  std::array<JetNumber<order>, 1> result;
  program.evaluate<order>(variables, result);
  return result[0];
}

/// Where a divisor is zero there are no derivatives, and the sign of the zero is arbitrary
/// (core/interval.hh).
void check_bounds(const FormulaProgram& program, Uv uv, const JetNumber<1>& number) {
  if (std::isnan(number.value()) || !std::isfinite(number.du()) || !std::isfinite(number.dv())) {
    return;
  }
  for (const double width : kWidths) {
    const std::array box = {Interval{uv.u - width / 3, uv.u + width},
                            Interval{uv.v - width, uv.v + width / 3}};
    std::array<Interval, 1> result;
    bound(program, box, result);
    demand(result[0].contains(number.value()), "bounds hold the values of a formula");
  }
}

void check_values(const FormulaProgram& program) {
  for (const double u : kPlaces) {
    for (const double v : kPlaces) {
      const double value = number_of<0>(program, {u, v}).value();
      const JetNumber<1> first = number_of<1>(program, {u, v});
      const double second = number_of<2>(program, {u, v}).value();
      demand(is_same(value, first.value()), "values agree at order 1");
      demand(is_same(value, second), "values agree at order 2");
      check_bounds(program, {u, v}, first);
    }
  }
}

std::vector<std::string> lines_of(Bytes bytes) {
  std::vector<std::string> lines(1);
  for (const std::uint8_t c : bytes) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += static_cast<char>(c);
    }
  }
  return lines;
}

}  // namespace

bool try_formula(Bytes bytes) {
  const std::vector<std::string> lines = lines_of(bytes);
  std::vector<NamedFormula> where;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    where.push_back({std::string("f").append(std::to_string(i)), lines[i]});
  }
  const bool is_taken = accepts([&] {
    const FormulaProgram program =
        parse_formulas(std::vector{lines.back()}, kVariables, {{"c", 0.5}}, where);
    check_values(program);
    for (const FormulaBreak& found : find_breaks(program, {{{-1, 2}, {-2, 1}}, 1, {}})) {
      demand(std::isfinite(found.at.u) && std::isfinite(found.at.v), "breaks are somewhere");
    }
  });
  accepts([&] { evaluate_constant(lines.back()); });
  return is_taken;
}

}  // namespace surfmesh::fuzz
