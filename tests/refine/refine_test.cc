// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/refine.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

using testing::connectivity;
using testing::constant_field;
using testing::edge_lengths;
using testing::empty_square;
using testing::four_point_field;
using testing::FunctionField;
using testing::ideal_triangles;
using testing::positions;
using testing::valid_area;

struct Way {
  const char* name;
  RefineOptions options;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

const Way kFrontalCavity{"FrontalCavity", {Placement::Frontal, Kernel::Cavity}};
const Way kFrontalSwap{"FrontalSwap", {Placement::Frontal, Kernel::Swap}};
const Way kCircumcentreCavity{"CircumcentreCavity", {Placement::Circumcentre, Kernel::Cavity}};
const Way kCircumcentreSwap{"CircumcentreSwap", {Placement::Circumcentre, Kernel::Swap}};

struct FieldCase {
  const char* name;
  FunctionField field;
};

void PrintTo(const FieldCase& field, std::ostream* out) { *out << field.name; }

std::vector<FieldCase> fields() {
  return {{"Isotropic", testing::isotropic_field(0.02)},
          {"Stretched", constant_field(testing::directed_metric({0.8, 0.6}, 0.1, 0.01))},
          {"FourPoints", four_point_field()},
          {"Shock10", testing::shock_field(10, 0.02)},
          {"Shock1000", testing::shock_field(1000)},
          {"Ring", testing::ring_field(1e-3)}};
}

class Refine : public ::testing::TestWithParam<std::tuple<Way, FieldCase>> {
 protected:
  const FunctionField& field() const { return std::get<1>(GetParam()).field; }
  const RefineOptions& options() const { return std::get<0>(GetParam()).options; }
};

TEST_P(Refine, FillsTheDomainWithValidTriangles) {
  const auto delaunay = empty_square(field());
  refine(*delaunay, field(), options());
  EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
  testing::expect_valid(delaunay->mesh());
}

TEST_P(Refine, MakesAboutAsManyTrianglesAsTheMetricAsksFor) {
  const auto delaunay = empty_square(field());
  refine(*delaunay, field(), options());
  const bool is_easy =
      options().placement == Placement::Frontal || field()({0.1, 0.2}) == field()({0.7, 0.4});
  // Circumcentres need more triangles in layers, where each one is half as large as its neighbour.
  EXPECT_NEAR(static_cast<double>(delaunay->n_faces()) / ideal_triangles(field()), 1,
              is_easy ? 0.08 : 0.2);
}

TEST_P(Refine, KeepsTheBoundary) {
  const auto delaunay = empty_square(field());
  const std::vector<Uv> before = positions(*delaunay);
  refine(*delaunay, field(), options());
  const std::vector<Uv> after = positions(*delaunay);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
  EXPECT_EQ(testing::count_constrained(*delaunay, 0, before.size()), before.size());
}

TEST_P(Refine, CountsTheNewVerticesAndTheQueries) {
  const auto delaunay = empty_square(field());
  const std::size_t before = delaunay->n_vertices(), queries = field().queries();
  const RefineReport report = refine(*delaunay, field(), options());
  EXPECT_EQ(report.counts.inserted, delaunay->n_vertices() - before);
  EXPECT_EQ(report.queries.total(), field().queries() - queries);
}

TEST_P(Refine, GivesEveryVertexTheMetricOfItsPlace) {
  const auto delaunay = empty_square(field());
  refine(*delaunay, field(), options());
  for (std::size_t i = 0; i < delaunay->n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    EXPECT_EQ(delaunay->metric(vh), field()(delaunay->uv(vh)));
  }
}

TEST_P(Refine, IsTheSameTwice) {
  const auto first = empty_square(field()), second = empty_square(field());
  EXPECT_EQ(refine(*first, field(), options()), refine(*second, field(), options()));
  EXPECT_EQ(positions(*first), positions(*second));
  EXPECT_EQ(connectivity(*first), connectivity(*second));
}

INSTANTIATE_TEST_SUITE_P(Ways, Refine,
                         ::testing::Combine(::testing::Values(kFrontalCavity, kFrontalSwap,
                                                              kCircumcentreCavity,
                                                              kCircumcentreSwap),
                                            ::testing::ValuesIn(fields())),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) +
                                  std::get<1>(test.param).name;
                         });

/// The unit square refined in a field.
std::unique_ptr<DelaunayMesh> refined(const FunctionField& field, const RefineOptions& options) {
  auto delaunay = empty_square(field);
  refine(*delaunay, field, options);
  return delaunay;
}

TEST(RefineFrontal, DeviatesByLessThanATenth) {
  EXPECT_LT(edge_lengths(*refined(four_point_field(), kFrontalCavity.options)).deviation, 0.1);
}

TEST(RefineFrontal, MakesUnitEdges) {
  const auto edges = edge_lengths(*refined(four_point_field(), kFrontalCavity.options));
  EXPECT_NEAR(edges.mean, 1, 0.03);
  EXPECT_GT(edges.unit_fraction, 0.99);
}

TEST(RefineFrontal, AsksForTheMetricAboutTwiceANode) {
  const FunctionField field = four_point_field();
  const auto delaunay = empty_square(field);
  const RefineReport report = refine(*delaunay, field, kFrontalCavity.options);
  EXPECT_LT(
      static_cast<double>(report.queries.total()) / static_cast<double>(report.counts.inserted),
      2.2);
}

TEST(RefineFrontal, GetsBetterWithSmallerSizes) {
  const double coarse = edge_lengths(*refined(four_point_field(1), {})).deviation;
  const double fine = edge_lengths(*refined(four_point_field(3), {})).deviation;
  EXPECT_LT(fine, coarse);
}

TEST(RefineCircumcentre, DeviatesAsInThePaper) {
  EXPECT_NEAR(edge_lengths(*refined(four_point_field(), kCircumcentreCavity.options)).deviation,
              0.18, 0.03);
}

TEST(RefineCircumcentre, AsksForTheMetricAboutOnceANode) {
  const FunctionField field = four_point_field();
  const auto delaunay = empty_square(field);
  const RefineReport report = refine(*delaunay, field, kCircumcentreCavity.options);
  EXPECT_LT(
      static_cast<double>(report.queries.total()) / static_cast<double>(report.counts.inserted),
      1.3);
}

TEST(RefineConformity, CountsTheCircumcentresThatAreGivenUp) {
  const FunctionField field = four_point_field();
  const auto report_with = [&](double conformity) {
    const auto delaunay = empty_square(field);
    const RefineReport report =
        refine(*delaunay, field, {.placement = Placement::Circumcentre, .conformity = conformity});
    EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
    return report.counts;
  };
  // Sizes differ by a factor of ten at most: no pair of metrics by more than ln 10.
  EXPECT_EQ(report_with(2.4).unconforming, 0u);
  const RefineCounts some = report_with(0.3), most = report_with(0.01);
  EXPECT_GT(some.unconforming, 0u);
  EXPECT_GT(most.unconforming, 10 * some.unconforming);
  EXPECT_GT(most.inserted, 1000u);  // at the middles of longest sides
}

TEST(RefineConformity, BelongsToCircumcentresAlone) {
  const FunctionField field = four_point_field();
  const auto with = empty_square(field), without = empty_square(field);
  EXPECT_EQ(refine(*with, field, {.conformity = 0.01}), refine(*without, field, {}));
}

TEST(RefineConformity, IsNoMatterInAConstantMetric) {
  const FunctionField field = testing::constant_field(testing::directed_metric({1, 0}, 0.1, 0.05));
  const auto delaunay = empty_square(field);
  const RefineOptions strict = {.placement = Placement::Circumcentre, .conformity = 0.01};
  EXPECT_EQ(refine(*delaunay, field, strict).counts.unconforming, 0u);
}

TEST(RefineLimit, EndsTheRun) {
  const FunctionField field = four_point_field();
  const auto delaunay = empty_square(field);
  EXPECT_EQ(error_of([&] { refine(*delaunay, field, {}, RunContext(nullptr, 1000)); }),
            "limit: more than max_elements = 1000 triangles");
}

TEST(RefineLimit, IsTheNumberOfTrianglesThatAreStillAllowed) {
  const FunctionField field = testing::isotropic_field(0.1);
  const std::size_t count = refined(field, {})->n_faces();
  const auto error_with = [&](std::size_t most) {
    return error_of([&] { refine(*empty_square(field), field, {}, RunContext(nullptr, most)); });
  };
  EXPECT_EQ(error_with(count), "no error");
  EXPECT_EQ(error_with(count - 1).substr(0, 6), "limit:");
}

TEST(RefineDegenerate, LeavesADomainThatIsSmallEnough) {
  const FunctionField field = testing::isotropic_field(10);
  const auto delaunay = empty_square(field);
  EXPECT_EQ(refine(*delaunay, field), RefineReport{});
}

TEST(RefineDegenerate, FillsARoundHoleAndAnLShape) {
  const FunctionField field = testing::isotropic_field(0.05);
  const std::vector<Uv> ell = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto hole = testing::circle({0.5, 0.5}, 0.3, -38);
  const auto delaunay =
      triangulate_boundary({testing::with_nodes(ell, field), hole}, field).delaunay;
  refine(*delaunay, field);
  EXPECT_NEAR(valid_area(*delaunay), 3 + testing::polygon_area(hole), 1e-12);
  EXPECT_GT(testing::mean_quality(*delaunay), 0.95);
}

TEST(RefineDegenerate, KeepsANarrowGap) {
  const FunctionField field = testing::isotropic_field(0.1);
  const std::vector<Uv> slit = {{0, 0}, {1, 0}, {1, 1e-4}, {0, 1e-4}};
  const auto delaunay = triangulate_boundary({testing::with_nodes(slit, field)}, field).delaunay;
  refine(*delaunay, field);
  EXPECT_NEAR(valid_area(*delaunay), 1e-4, 1e-12);
}

TEST(RefineDegenerate, EndsOnABoundaryThatIsMuchFinerThanItsSizes) {
  const FunctionField field = testing::isotropic_field(0.2);
  const auto nodes = testing::with_nodes(testing::kUnitSquare, testing::isotropic_field(0.002));
  const auto delaunay = triangulate_boundary({nodes}, field).delaunay;
  refine(*delaunay, field);
  EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
}

TEST(RefineDegenerate, EndsOnABoundaryThatIsMuchCoarserThanItsSizes) {
  const FunctionField field = testing::isotropic_field(0.01);
  const auto delaunay = triangulate_boundary({testing::kUnitSquare}, field).delaunay;
  refine(*delaunay, field);
  EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
}

TEST(RefineDegenerate, EndsWhereSizesJump) {
  const FunctionField field =
      testing::isotropic_field([](Uv p) { return p.u < 0.5 ? 0.1 : 0.005; });
  for (const Way& way : {kFrontalCavity, kCircumcentreSwap}) {
    EXPECT_NEAR(valid_area(*refined(field, way.options)), 1, 1e-12);
  }
}

TEST(RefineScales, DoNotChangeTheMesh) {
  // Powers of two keep all roundings.
  const double u_scale = 1048576, v_scale = 1.0 / 1024;
  const FunctionField field = four_point_field();
  const FunctionField scaled = testing::with_scaled_parameters(field, u_scale, v_scale);
  std::vector<Uv> nodes = testing::with_nodes(testing::kUnitSquare, field);
  for (Uv& p : nodes) p = {u_scale * p.u, v_scale * p.v};
  const auto delaunay = triangulate_boundary({nodes}, scaled).delaunay;
  refine(*delaunay, scaled);
  EXPECT_EQ(delaunay->n_faces(), refined(field, {})->n_faces());
}

/// Elements of aspect 1,000 whose direction turns by `turns` radians over the unit square.
FunctionField turning_field(double turns) {
  return FunctionField([turns](Uv p) {
    const double angle = turns * p.v;
    return testing::directed_metric({std::cos(angle), std::sin(angle)}, 0.3, 0.0003);
  });
}

TEST(RefineGivenUp, IsGivenUpAtThreeTimesThePredictedCount) {
  const FunctionField field = turning_field(30);
  const auto delaunay = testing::empty_square(field);
  const auto boundary = static_cast<double>(delaunay->n_faces());
  const RefineReport report = refine(*delaunay, field);
  EXPECT_TRUE(report.is_stopped);
  // √det M is the same everywhere.
  const double predicted = 1 / (0.3 * 0.0003) / (std::numbers::sqrt3 / 4);
  EXPECT_LT(static_cast<double>(delaunay->n_faces()) - boundary, 3.1 * predicted);
  EXPECT_NEAR(testing::valid_area(*delaunay), 1, 1e-12);
}

TEST(RefineGivenUp, IsNotFoundWhereElementsCanFollow) {
  for (const FunctionField& field :
       {testing::four_point_field(), testing::shock_field(1000), testing::ring_field(1e-4)}) {
    const auto delaunay = testing::empty_square(field);
    EXPECT_FALSE(refine(*delaunay, field).is_stopped);
  }
}

TEST(RefineOrder, PutsNeighboursNextToEachOther) {
  const FunctionField field = testing::isotropic_field(0.01);
  const auto delaunay = testing::empty_square(field);
  const std::size_t boundary = delaunay->n_vertices();
  refine(*delaunay, field);
  double sum = 0;
  const std::vector<Uv> at = positions(*delaunay);
  for (std::size_t i = boundary + 1; i < at.size(); ++i) {
    sum += std::hypot(at[i].u - at[i - 1].u, at[i].v - at[i - 1].v);
  }
  EXPECT_LT(sum / static_cast<double>(at.size() - boundary), 0.03);
}

}  // namespace
}  // namespace surfmesh
