// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/formula_field.hh"

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_bounds.hh"
#include "surfmesh/formula/formula_slopes.hh"

namespace surfmesh {
namespace {

/// A program, and whether its simple bounds are as good as those by slopes.
struct Fields {
  FormulaProgram program;
  bool reads_each_once;
};
using SharedFields = std::shared_ptr<const Fields>;

SharedFields parse(std::span<const std::string> texts,
                   const std::map<std::string, double>& constants,
                   std::span<const NamedFormula> where) {
  FormulaProgram program = parse_formulas(texts, formula_field_variables(), constants, where);
  const bool reads_each_once = program.reads_each_once();
  return std::make_shared<Fields>(Fields{std::move(program), reads_each_once});
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
std::array<Interval, count> bounds(const Fields& fields, const UvBox& box,
                                   const Eigen::AlignedBox3d& positions) {
  const auto side = [&](int i) { return Interval{positions.min()[i], positions.max()[i]}; };
  const std::array<Interval, 5> variables = {box.u, box.v, side(0), side(1), side(2)};
  std::array<Interval, count> results;
  const FormulaProgram& program = fields.program;
  fields.reads_each_once ? bound(program, variables, results)
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
  const SharedFields fields = parse(std::span(&size, 1), constants, where);
  FieldSource source;
  source.uses_position = uses_position(fields->program);
  source.size = [fields](Uv uv, const Vec3& p) { return evaluate<1>(fields->program, uv, p)[0]; };
  source.size_bounds = [fields](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    return bounds<1>(*fields, box, positions)[0];
  };
  return source;
}

FieldSource formula_field(const std::array<std::string, 3>& metric,
                          const std::map<std::string, double>& constants,
                          std::span<const NamedFormula> where) {
  const SharedFields fields = parse(metric, constants, where);
  FieldSource source;
  source.uses_position = uses_position(fields->program);
  source.metric = [fields](Uv uv, const Vec3& p) {
    const auto [m11, m12, m22] = evaluate<3>(fields->program, uv, p);
    return Metric{m11, m12, m22};
  };
  source.metric_bounds = [fields](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    const auto [m11, m12, m22] = bounds<3>(*fields, box, positions);
    return MetricBounds{m11, m12, m22};
  };
  return source;
}

}  // namespace surfmesh
