// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/formula_field.hh"

#include <memory>
#include <span>
#include <vector>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_bounds.hh"
#include "surfmesh/formula/formula_slopes.hh"

namespace surfmesh {
namespace {

using Program = std::shared_ptr<const FormulaProgram>;

Program parse(std::span<const std::string> texts, const std::map<std::string, double>& constants,
              std::span<const NamedFormula> where) {
  return std::make_shared<FormulaProgram>(
      parse_formulas(texts, formula_field_variables(), constants, where));
}

bool uses_position(const FormulaProgram& program) {
  return program.uses(2) || program.uses(3) || program.uses(4);
}

template <std::size_t count>
std::array<double, count> evaluate(const FormulaProgram& program, Uv uv, const Vec3& p) {
  const std::array<JetNumber<0>, 5> variables = {JetNumber<0>(uv.u), JetNumber<0>(uv.v),
                                                 JetNumber<0>(p.x()), JetNumber<0>(p.y()),
                                                 JetNumber<0>(p.z())};
  std::array<JetNumber<0>, count> results;
  program.evaluate<0>(variables, results);
  std::array<double, count> values;
  for (std::size_t i = 0; i < count; ++i) values[i] = results[i].value();
  return values;
}

template <std::size_t count>
std::array<Interval, count> bounds(const FormulaProgram& program, const UvBox& box,
                                   const Eigen::AlignedBox3d& positions) {
  const auto side = [&](int i) { return Interval{positions.min()[i], positions.max()[i]}; };
  const std::array<Interval, 5> variables = {box.u, box.v, side(0), side(1), side(2)};
  std::array<Interval, count> results;
  program.reads_each_once() ? bound(program, variables, results)
                            : bound_by_slopes(program, variables, results);
  return results;
}

}  // namespace

const std::vector<std::string>& formula_field_variables() {
  static const std::vector<std::string> variables = {"u", "v", "x", "y", "z"};
  return variables;
}

FieldSource formula_field(const std::string& size, const std::map<std::string, double>& constants,
                          std::span<const NamedFormula> where) {
  const Program program = parse(std::span(&size, 1), constants, where);
  FieldSource source;
  source.uses_position = uses_position(*program);
  source.size = [program](Uv uv, const Vec3& p) { return evaluate<1>(*program, uv, p)[0]; };
  source.size_bounds = [program](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    return bounds<1>(*program, box, positions)[0];
  };
  return source;
}

FieldSource formula_field(const std::array<std::string, 3>& metric,
                          const std::map<std::string, double>& constants,
                          std::span<const NamedFormula> where) {
  const Program program = parse(metric, constants, where);
  FieldSource source;
  source.uses_position = uses_position(*program);
  source.metric = [program](Uv uv, const Vec3& p) {
    const auto [m11, m12, m22] = evaluate<3>(*program, uv, p);
    return Metric{m11, m12, m22};
  };
  source.metric_bounds = [program](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    const auto [m11, m12, m22] = bounds<3>(*program, box, positions);
    return MetricBounds{m11, m12, m22};
  };
  return source;
}

}  // namespace surfmesh
