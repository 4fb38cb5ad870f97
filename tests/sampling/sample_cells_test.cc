// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sampling/sample_cells.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/analytic.hh"
#include "support/tensors.hh"
#include "support/waves.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/metric/conformity.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

using testing::size_of;
using testing::sizing_of;

const test::PlanePatch kPlane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {});

/// Cells of a field, sampled to a precision.
struct Sampled {
  std::unique_ptr<ControlCells> cells;
  CellSampling report;
};

Sampled sampled(const SizeField& field, double precision = 0.1, double grade = 0) {
  const auto sample = [&field](Uv uv) {
    const SizeField::Sample at = field.at(uv);
    return ControlNode{uv, at.point, at.form, at.size};
  };
  Sampled result;
  result.cells = std::make_unique<ControlCells>(
      field.surface().domain(), first_cells(field.surface()), sample,
      ControlSpaceOptions{.grade = grade}, std::vector<ControlNode>());
  result.report = sample_cells(field, *result.cells, precision, RunContext());
  return result;
}

/// Shares of random points that miss a precision of 0.1, and three times it.
std::pair<double, double> misses_of(const SizeField& field, const ControlCells& cells) {
  constexpr int samples = 20'000;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Domain domain = field.surface().domain();
  int once = 0, thrice = 0, near = -1;
  for (int i = 0; i < samples; ++i) {
    const double s = uniform(random);
    const Uv uv = domain.fold(domain.at(s, uniform(random)));
    const double miss = log_conformity(field.at(uv).size, cells.lattice_size(uv, near));
    once += miss > 0.1 ? 1 : 0;
    thrice += miss > 0.3 ? 1 : 0;
  }
  return {double(once) / samples, double(thrice) / samples};
}

TEST(SampleCells, HoldASmoothFieldToThePrecisionAtAllPoints) {
  const test::Torus torus(3, 1, {0, 6, -1, 1});
  const SizeField field(torus, resolve(sizing_of(0.25, 1e-3, 100, 100), 1), {});
  const auto [once, thrice] = misses_of(field, *sampled(field).cells);
  EXPECT_LE(once, 0.005);
  EXPECT_EQ(thrice, 0);
}

/// The same surface, said to consist of many cells.
class Divided : public Surface {
 public:
  Divided(const Surface& surface, CellCount cells) : surface_(surface), cells_(cells) {}

  Jet evaluate(Uv uv, Order order) const override { return surface_.evaluate(uv, order); }
  Domain domain() const override { return surface_.domain(); }
  CellCount cells() const override { return cells_; }

 private:
  const Surface& surface_;
  CellCount cells_;
};

TEST(SampleCells, MayBeHalvedHoweverManyThereAreAtFirst) {
  // The nodes of 720 × 8 cells are more than a patch of so few elements usually gets.
  const test::Torus torus(3, 1, {0, 6, -1, 1});
  const Divided divided(torus, {720, 8});
  const SizeField field(divided, resolve(sizing_of(0.1, 1e-3, 100, 1.2), 1), {});
  const Sampled cells = sampled(field);
  EXPECT_FALSE(cells.report.is_coarse);
  EXPECT_GT(cells.cells->node_count(), 721 * 9);
}

TEST(SampleCells, HoldAFieldWithKinksAtMostPoints) {
  const auto wave = testing::paper_wave();
  const SizeField field(*wave, resolve(testing::paper_sizing(), 1), {});
  const auto [once, thrice] = misses_of(field, *sampled(field).cells);
  EXPECT_LE(once, 0.02);
  EXPECT_LE(thrice, 0.001);
}

void expect_more_nodes_for_a_finer_precision(const SizeField& field) {
  int last = 0;
  for (const double precision : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02}) {
    const int nodes = sampled(field, precision).cells->node_count();
    EXPECT_GE(nodes, last) << precision;
    last = nodes;
  }
}

TEST(SampleCells, TakeMoreNodesForAFinerPrecision) {
  const auto wave = testing::paper_wave(), sheet = testing::half_bent_sheet();
  expect_more_nodes_for_a_finer_precision(
      SizeField(*wave, resolve(testing::paper_sizing(), 1), {}));
  expect_more_nodes_for_a_finer_precision(
      SizeField(*sheet, resolve(sizing_of(0.1, 0.001, 0.3, 5), 1), {}));
}

TEST(SampleCells, FindABumpOfAFifthOfThePatch) {
  for (const Uv at : {Uv{0.21, 0.34}, Uv{0.5, 0.5}, Uv{0.613, 0.287}, Uv{0.83, 0.71}}) {
    const std::string distance = fmt::format("((u-{})^2+(v-{})^2)/{}", at.u, at.v, 0.2 * 0.2 / 16);
    const FormulaSurface bump({"u", "v", "0.05*exp(-" + distance + ")"}, Domain());
    const SizeField field(bump, resolve(sizing_of(0.25, 1e-4, 0.2, 2), 1), {});
    int near = -1;
    const double given = sampled(field).cells->lattice_size(at, near).h11;
    EXPECT_LT(given, 1.5 * field.at(at).size.h11) << at.u;
  }
}

TEST(SampleCells, MeasureThePrecisionTheyReach) {
  const auto wave = testing::paper_wave();
  const SizeField field(*wave, resolve(testing::paper_sizing(), 1), {});
  const Sampled at_usual = sampled(field);
  EXPECT_EQ(at_usual.report.precision.asked, 0.1);
  EXPECT_GT(at_usual.report.precision.points, 100U);
  EXPECT_TRUE(at_usual.report.precision.is_held());
  EXPECT_LT(at_usual.report.precision.greatest, 0.3);
  EXPECT_FALSE(PrecisionSample({.asked = 0.1, .points = 100, .over = 7}).is_held());
  EXPECT_TRUE(PrecisionSample({.asked = 0.1, .points = 100, .over = 3}).is_held());
}

/// The size at a point of the plane.
double size_at(const ControlSpace& control, Uv uv) {
  QueryHint hint;
  return control.size({uv, Vec3(uv.u, uv.v, 0), {1, 0, 1}}, hint).h11;
}

/// Cells of the plane with gradation, which spreads small sizes.
std::unique_ptr<ControlCells> graded_cells(const SizeField& field) {
  Sampled result = sampled(field, 0.1, 1.5);
  result.cells->grade_all(RunContext());
  result.cells->finish();
  return std::move(result.cells);
}

SizeField field_of(const std::string& formula) {
  FieldSource source = formula_field(formula, {});
  source.patch = 0;
  PatchSources sources;
  sources.fields.push_back(source);
  return SizeField(kPlane, resolve(sizing_of(0, 1e-4, 1, 2), 1), sources);
}

class NarrowBand : public ::testing::TestWithParam<double> {};

TEST_P(NarrowBand, IsFoundWhereverItLies) {
  const double x = GetParam();
  const SizeField field = field_of("0.002+0.098*min(1,abs(u-" + std::to_string(x) + ")/0.02)");
  const auto band = graded_cells(field);
  for (const double v : {0.03, 0.31, 0.5, 0.77, 0.98}) {
    EXPECT_LT(size_at(*band, {x, v}), 0.0035) << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Places, NarrowBand, ::testing::Values(0.25, 0.317, 0.4, 0.6));

TEST(SampleCells, FindARingAllAround) {
  const SizeField field = field_of("0.002+0.098*min(1,abs(hypot(u-0.5,v-0.5)-0.3)/0.005)");
  const auto ring = graded_cells(field);
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.1 + 0.157 * i;
    EXPECT_LT(size_at(*ring, {0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle)}), 0.008)
        << angle;
  }
}

TEST(SampleCells, FindTheRowOfATableThatDiffers) {
  TableSource table{.patch = 0};
  for (int i = 0; i < 9; ++i) {
    const Uv uv{0.21 + 0.29 * (i % 3), 0.17 + 0.33 * (i / 3)};
    table.nodes.push_back({uv, size_of(i == 4 ? 0.002 : 0.1)});
  }
  PatchSources sources;
  sources.tables.push_back(table);
  const SizeField field(kPlane, resolve(sizing_of(0, 1e-4, 1, 2), 1), sources);
  EXPECT_LT(size_at(*graded_cells(field), {0.5, 0.5}), 0.0021);
}

TEST(SampleCells, GiveUpWhereElementsCannotFollow) {
  FieldSource noise{.patch = 0};
  noise.size = [](Uv uv, const Vec3&) {
    return std::sin(1e5 * uv.u) * std::sin(1.3e5 * uv.v) > 0 ? 1e-4 : 0.1;
  };
  PatchSources sources;
  sources.fields.push_back(noise);
  const SizeField field(kPlane, resolve(sizing_of(0, 1e-4, 1, 2), 1), sources);
  const Sampled cells = sampled(field);
  EXPECT_TRUE(cells.report.is_coarse);
  EXPECT_LE(cells.cells->node_count(), 4'000'100);
}

}  // namespace
}  // namespace surfmesh
