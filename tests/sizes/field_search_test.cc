// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/field_search.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/analytic.hh"
#include "support/errors.hh"
#include "support/waves.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/sizes/field_size.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

const UvBox kWhole = {{0, 1}, {0, 1}};
constexpr int kCells = 16;

SizeField field_of(const FieldSource& source, const Surface& surface = test::kUnitPlane) {
  PatchSources sources;
  sources.fields.push_back(source);
  return SizeField(surface, resolve(testing::sizing_of(0, 0.0001, 1, 2), 1), sources);
}

std::vector<UvBox> cells_of(const Domain& domain = {}) {
  std::vector<UvBox> cells;
  for (int k = 0; k < kCells * kCells; ++k) {
    const double i = k % kCells, j = k / kCells;
    const Uv from = domain.at(i / kCells, j / kCells);
    const Uv to = domain.at((i + 1) / kCells, (j + 1) / kCells);
    cells.push_back({{from.u, to.u}, {from.v, to.v}});
  }
  return cells;
}

/// The points found in cells of the domain, each of them tested for what it promises.
std::vector<Uv> find_in_cells(FieldSearch& search, const SizeField& field, double size) {
  std::vector<Uv> found;
  for (const UvBox& cell : cells_of(field.surface().domain())) {
    const auto uv = search.find_smaller(cell, size);
    if (!uv) continue;
    EXPECT_TRUE(cell.u.contains(uv->u) && cell.v.contains(uv->v));
    EXPECT_LT(least_length(field.fields()[0], field.surface(), *uv), size);
    found.push_back(*uv);
  }
  EXPECT_FALSE(search.is_exhausted());
  return found;
}

TEST(FieldSearch, FindsBandsAnywhere) {
  for (const std::string x : {"0.25", "0.317", "0.4", "0.6"}) {
    const SizeField field = field_of(formula_field("0.002+0.098*min(1,abs(u-" + x + ")/0.02)"));
    FieldSearch search(field);
    const std::vector<Uv> found = find_in_cells(search, field, 0.01);
    EXPECT_GE(found.size(), 16u) << x;
    for (const Uv uv : found) EXPECT_NEAR(uv.u, std::stod(x), 0.0017);
    EXPECT_LT(search.evaluations(), 2000u);
  }
}

/// Whether each of the cells that a curve crosses has one of the points.
TEST(FieldSearch, FindsARingInEveryCellThatItCrosses) {
  const SizeField field =
      field_of(formula_field("0.002+0.098*min(1,abs(hypot(u-0.5,v-0.5)-0.3)/0.005)"));
  FieldSearch search(field);
  std::vector<UvBox> crossed;
  for (const UvBox& cell : cells_of()) {
    const auto is_in = [&](int i) {
      const double angle = 0.001 * i;
      return cell.u.contains(0.5 + 0.3 * std::cos(angle)) &&
             cell.v.contains(0.5 + 0.3 * std::sin(angle));
    };
    int count = 0;
    for (int i = 0; i < 6284; ++i) count += is_in(i);
    if (count > 0) crossed.push_back(cell);
  }
  EXPECT_GT(crossed.size(), 30u);
  for (const UvBox& cell : crossed) EXPECT_TRUE(search.find_smaller(cell, 0.02));
  EXPECT_GE(find_in_cells(search, field, 0.02).size(), crossed.size());
}

const std::array<Uv, 5> kBlobs = {{{0.141592, 0.718281},
                                   {0.414213, 0.732050},
                                   {0.618033, 0.236067},
                                   {0.870796, 0.645751},
                                   {0.0625, 0.0625}}};

std::string blobs(const std::string& radius) {
  std::string distance = "1";
  for (const Uv uv : kBlobs) {
    distance = "min(" + distance + ",hypot(u-" + std::to_string(uv.u) + ",v-" +
               std::to_string(uv.v) + ")/" + radius + ")";
  }
  return "0.002+0.098*" + distance;
}

void expect_blobs(const std::string& radius, const std::vector<Uv>& found) {
  for (const Uv blob : kBlobs) {
    EXPECT_TRUE(std::ranges::any_of(
        found, [&](Uv uv) { return std::hypot(uv.u - blob.u, uv.v - blob.v) < std::stod(radius); }))
        << blob.u << ", " << blob.v;
  }
}

TEST(FieldSearch, FindsBlobsOfAThousandthOfTheSide) {
  for (const std::string radius : {"0.0005", "0.0001"}) {
    const SizeField field = field_of(formula_field(blobs(radius)));
    FieldSearch search(field);
    expect_blobs(radius, find_in_cells(search, field, 0.05));
    EXPECT_LT(search.evaluations(), 2000u);
  }
}

/// The parameters of this plane reach to 10 and 3.
TEST(FieldSearch, FindsWhatIsSmallInSpace) {
  const auto surface = make_callable_surface(Domain{-1, 10, 0, 3}, [](auto u, auto v) {
    return std::array{0.1 * u, v / 3.0, 0.05 * sin(u)};
  });
  const SizeField field =
      field_of(formula_field("0.002+0.098*min(1,hypot(x-0.618033,y-0.236067)/0.0005)"), *surface);
  FieldSearch search(field);
  const std::vector<Uv> found = find_in_cells(search, field, 0.05);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].u, 6.18033, 0.005);
  EXPECT_NEAR(found[0].v, 0.708201, 0.0015);
}

TEST(FieldSearch, FindsWhatIsSmallInAMetric) {
  const std::string inverse = "(0.002+0.098*min(1,abs(u-0.317)/0.02))^-2";
  const SizeField field = field_of(formula_field(std::array<std::string, 3>{inverse, "0", "100"}));
  FieldSearch search(field);
  EXPECT_GE(find_in_cells(search, field, 0.01).size(), 16u);
  EXPECT_LT(search.evaluations(), 2000u);
}

/// Asks in each cell for less than 0.7 of the least of 3 × 3 samples, as the sampling of a control
/// space does.
std::size_t evaluations_for(const FieldSource& source, std::size_t& found) {
  const SizeField field = field_of(source);
  FieldSearch search(field);
  for (const UvBox& cell : cells_of()) {
    double least = 1;
    for (int k = 0; k < 9; ++k) {
      const Uv uv = {std::lerp(cell.u.lower, cell.u.upper, 0.5 * (k % 3)),
                     std::lerp(cell.v.lower, cell.v.upper, 0.5 * (k / 3))};
      least = std::min(least, least_length(source, test::kUnitPlane, uv));
    }
    found += search.find_smaller(cell, 0.7 * least).has_value();
  }
  return search.evaluations();
}

TEST(FieldSearch, FindsWhatLiesWithinSteps) {
  for (const std::string text : {"if((abs(u-0.3171)<0.0005)*(abs(v-0.61)<0.0005),0.002,0.1)",
                                 "0.1-0.098*step(0.3166,u)*step(-0.3176,-u)*(floor(1000*v)==610)",
                                 "max(0.002,0.1*sign(hypot(u-0.3171,v-0.61)-0.0004))"}) {
    const SizeField field = field_of(formula_field(text));
    FieldSearch search(field);
    const std::vector<Uv> found = find_in_cells(search, field, 0.05);
    ASSERT_EQ(found.size(), 1u) << text;
    EXPECT_NEAR(found[0].u, 0.3171, 0.0005) << text;
    EXPECT_NEAR(found[0].v, 0.61, 0.001) << text;
    EXPECT_LT(search.evaluations(), 2000u) << text;
  }
}

TEST(FieldSearch, FindsNothingBesideSteps) {
  for (const std::string text :
       {"0.06+0.03*floor(4*u)-0.01*sign(v-0.317)", "0.03+0.02*mod(3.3*u,1)", "if(u<v,0.05,0.08)",
        "0.05+0.02*(u>0.317)", "0.05+0.02*mod(u,0.3+0.1*v)/0.4"}) {
    std::size_t found = 0;
    const std::size_t evaluations = evaluations_for(formula_field(text), found);
    EXPECT_EQ(found, 0u) << text;
    EXPECT_LE(evaluations, 2u * kCells * kCells) << text;
  }
}

TEST(FieldSearch, FindsNothingInSmoothFields) {
  for (const std::string text :
       {"0.1", "0.05+0.02*sin(6*u)*cos(5*v)", "0.02+0.1*(u-0.3)^2+0.2*v^2*u",
        "0.1*exp(-2*(u^2+v^2))", "0.05*(1+u-u^2+v*(1-v))", "0.1/(1+u^2+v^2)",
        "0.03+0.1*hypot(u-0.4,v-0.6)", "0.02+0.05*sqrt(u)+0.03*log(1+v)"}) {
    std::size_t found = 0;
    const std::size_t evaluations = evaluations_for(formula_field(text), found);
    EXPECT_EQ(found, 0u) << text;
    EXPECT_LE(evaluations, 2u * kCells * kCells) << text;
  }
}

/// Simple bounds of these would spend the budget: terms of size 1 cancel to 0.01.
TEST(FieldSearch, FindsNothingWhereTermsCancel) {
  for (const std::string text :
       {"0.01+u^4-2*u^3+1.5*u^2-0.5*u+0.0625", "0.001+0.1*(u^2-2*u*v+v^2)"}) {
    std::size_t found = 0;
    const std::size_t evaluations = evaluations_for(formula_field(text), found);
    EXPECT_EQ(found, 0u) << text;
    EXPECT_LE(evaluations, 10u * kCells * kCells) << text;
  }
}

TEST(FieldSearch, AsksOnceWhereThereIsNoRoom) {
  const SizeField field = field_of(formula_field("0.1+0.01*u"));
  FieldSearch search(field);
  EXPECT_FALSE(search.find_smaller(kWhole, 0.1));
  EXPECT_EQ(search.evaluations(), 1u);
}

TEST(FieldSearch, LooksIntoAllFieldsWithBounds) {
  PatchSources sources;
  sources.fields.push_back(formula_field("0.1"));
  sources.fields.push_back({0, [](Uv, const Vec3&) { return 0.001; }});
  sources.fields.push_back(formula_field("0.002+abs(u-0.317)"));
  const SizeField field(test::kUnitPlane, resolve(testing::sizing_of(0, 0.0001, 1, 2), 1), sources);
  FieldSearch search(field);
  EXPECT_FALSE(search.find_smaller(kWhole, 0.0015));
  const auto found = search.find_smaller(kWhole, 0.01);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->u, 0.317, 0.008);
}

TEST(FieldSearch, FindsNothingBelowHmin) {
  const SizeField field = field_of(formula_field("0.00001"));
  EXPECT_FALSE(FieldSearch(field).find_smaller(kWhole, 0.0001));
  EXPECT_TRUE(FieldSearch(field).find_smaller(kWhole, 0.0002));
}

/// sin² + cos² is 1, but bounds leave room for small sizes everywhere.
TEST(FieldSearch, EndsWithItsBudget) {
  const SizeField field = field_of(formula_field("0.1+100000*(sin(u)^2+cos(u)^2-1)+1e-9*v"));
  FieldSearch search(field, 1000);
  EXPECT_FALSE(search.find_smaller(kWhole, 0.05));
  EXPECT_TRUE(search.is_exhausted());
  EXPECT_LE(search.evaluations(), 1002u);
  EXPECT_FALSE(search.find_smaller(kWhole, 1));
}

TEST(FieldSearch, StaysInATriangle) {
  const test::PlanePatch surface(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(),
                                 {0, 1, 0, 1, Domain::Shape::Triangle});
  const SizeField field = field_of(formula_field("0.002+0.098*min(1,abs(u-0.317)/0.02)"), surface);
  FieldSearch search(field);
  EXPECT_FALSE(search.find_smaller({{0.25, 0.375}, {0.8, 1}}, 0.01));
  const std::vector<Uv> found = find_in_cells(search, field, 0.01);
  EXPECT_EQ(found.size(), 11u);
  for (const Uv uv : found) EXPECT_LE(uv.u + uv.v, 1);
}

TEST(FieldSearch, NamesThePlaceOfABadSize) {
  const SizeField field = field_of(formula_field("u-0.5"));
  EXPECT_EQ(error_of([&] { FieldSearch(field).find_smaller(kWhole, 0.1); }), error_of([&] {
              field.at({0.5, 0.5});
            }));
}

}  // namespace
}  // namespace surfmesh
