// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/improve.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {
namespace {

using testing::edge_lengths;
using testing::FunctionField;
using testing::least_quality;
using testing::positions;
using testing::valid_area;

/// Down to this least quality vertices may be moved in favour of edge lengths.
constexpr double kGoodQuality = 0.8;

}  // namespace

void PrintTo(Smoothing kind, std::ostream* out) {
  *out << (kind == Smoothing::Best ? "Best" : kind == Smoothing::Laplace ? "Laplace" : "Element");
}

namespace {

std::unique_ptr<DelaunayMesh> refined(const FunctionField& field, const RefineOptions& options) {
  auto delaunay = testing::empty_square(field);
  refine(*delaunay, field, options);
  return delaunay;
}

struct Start {
  const char* name;
  FunctionField field;
  Placement placement;
};

void PrintTo(const Start& start, std::ostream* out) { *out << start.name; }

std::vector<Start> starts() {
  return {{"FourPoints", testing::four_point_field(), Placement::Frontal},
          {"FourPointsFine", testing::four_point_field(2), Placement::Frontal},
          {"FourPointsCircumcentre", testing::four_point_field(), Placement::Circumcentre},
          {"Stretched", testing::constant_field(testing::directed_metric({0.8, 0.6}, 0.1, 0.01)),
           Placement::Frontal},
          {"Shock10", testing::shock_field(10, 0.02), Placement::Frontal},
          {"Shock1000", testing::shock_field(1000), Placement::Frontal},
          {"Shock1000Circumcentre", testing::shock_field(1000), Placement::Circumcentre},
          {"Ring", testing::ring_field(1e-3), Placement::Frontal},
          {"ThinRing", testing::ring_field(1e-4), Placement::Frontal}};
}

class Improve : public ::testing::TestWithParam<Start> {
 protected:
  void SetUp() override {
    delaunay_ = refined(field(), {.placement = GetParam().placement});
    boundary_ = testing::with_nodes(testing::kUnitSquare, field()).size();
  }

  const FunctionField& field() const { return GetParam().field; }

  std::unique_ptr<DelaunayMesh> delaunay_;
  std::size_t boundary_ = 0;  ///< number of nodes
};

TEST_P(Improve, InvertsNoTriangle) {
  improve(*delaunay_, field());
  EXPECT_NEAR(valid_area(*delaunay_), 1, 1e-12);
  testing::expect_valid(delaunay_->mesh());
}

TEST_P(Improve, KeepsTheBoundary) {
  const std::vector<Uv> before = positions(*delaunay_);
  improve(*delaunay_, field());
  const std::vector<Uv> after = positions(*delaunay_);
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(boundary_),
                         after.begin()));
  EXPECT_EQ(testing::count_constrained(*delaunay_, 0, boundary_), boundary_);
}

TEST_P(Improve, CountsTheElementsThatComeAndGo) {
  const std::size_t vertices = delaunay_->n_vertices(), faces = delaunay_->n_faces();
  const ImproveReport report = improve(*delaunay_, field());
  EXPECT_EQ(delaunay_->n_vertices(), vertices + report.split - report.collapsed);
  EXPECT_EQ(delaunay_->n_faces(), faces + 2 * report.split - 2 * report.collapsed);
  EXPECT_EQ(delaunay_->mesh().n_faces(), delaunay_->n_faces());
}

TEST_P(Improve, KeepsTheLeastQualityOrMakesItGood) {
  const double before = least_quality(*delaunay_);
  improve(*delaunay_, field());
  EXPECT_GE(least_quality(*delaunay_), std::min(before, kGoodQuality));
}

TEST_P(Improve, RaisesTheMeanQuality) {
  const double before = testing::mean_quality(*delaunay_);
  improve(*delaunay_, field());
  EXPECT_GT(testing::mean_quality(*delaunay_), before);
}

TEST_P(Improve, LowersTheDeviationOfTheLengths) {
  const double before = edge_lengths(*delaunay_).deviation;
  improve(*delaunay_, field());
  EXPECT_LT(edge_lengths(*delaunay_).deviation, before);
}

TEST_P(Improve, GivesEveryVertexTheMetricOfItsPlace) {
  improve(*delaunay_, field());
  for (std::size_t i = 0; i < delaunay_->n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    EXPECT_EQ(delaunay_->metric(vh), field()(delaunay_->uv(vh)));
  }
}

TEST_P(Improve, CountsItsQueries) {
  const std::size_t before = field().queries();
  const ImproveReport report = improve(*delaunay_, field());
  EXPECT_EQ(report.queries.total(), field().queries() - before);
}

TEST_P(Improve, IsTheSameTwice) {
  const auto second = refined(field(), {.placement = GetParam().placement});
  EXPECT_EQ(improve(*delaunay_, field()), improve(*second, field()));
  EXPECT_EQ(positions(*delaunay_), positions(*second));
  EXPECT_EQ(testing::connectivity(*delaunay_), testing::connectivity(*second));
}

INSTANTIATE_TEST_SUITE_P(Starts, Improve, ::testing::ValuesIn(starts()),
                         [](const auto& test) { return std::string(test.param.name); });

/// A parallelogram of unit triangles.
std::unique_ptr<DelaunayMesh> perfect_mesh(int n) {
  std::vector<Uv> points;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      points.push_back({i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j});
      if (i == n || j == n) continue;
      const int a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({b, c, d});
    }
  }
  auto delaunay = std::make_unique<DelaunayMesh>(points, triangles);
  for (std::size_t i = 0; i < points.size(); ++i) {
    delaunay->metric(VertexHandle(static_cast<int>(i))) = {1, 0, 1};
  }
  return delaunay;
}

TEST(ImprovePerfect, ChangesNothing) {
  const auto delaunay = perfect_mesh(10);
  EXPECT_EQ(improve(*delaunay, testing::isotropic_field(1)), ImproveReport{});
}

TEST(ImprovePerfect, BringsAVertexBack) {
  const auto delaunay = perfect_mesh(10);
  const VertexHandle middle(5 * 11 + 5);
  const Uv place = delaunay->uv(middle);
  delaunay->uv(middle) = place + Uv{0.3, -0.2};
  improve(*delaunay, testing::isotropic_field(1), {.sweeps = 5});
  EXPECT_NEAR(delaunay->uv(middle).u, place.u, 0.02);
  EXPECT_NEAR(delaunay->uv(middle).v, place.v, 0.02);
}

TEST(ImproveOptionsTest, WithoutSmoothingAndRepairsDoNothing) {
  const FunctionField field = testing::four_point_field();
  const auto delaunay = refined(field, {});
  const std::vector<Uv> before = positions(*delaunay);
  EXPECT_EQ(improve(*delaunay, field, {.smoothing = Smoothing::Off, .repairs = 0}),
            ImproveReport{});
  EXPECT_EQ(positions(*delaunay), before);
}

TEST(ImproveOptionsTest, MoreSweepsLowerTheDeviation) {
  const FunctionField field = testing::four_point_field();
  double last = 1;
  for (const int sweeps : {1, 2, 4}) {
    const auto delaunay = refined(field, {});
    improve(*delaunay, field, {.sweeps = sweeps, .repairs = 0});
    const double deviation = edge_lengths(*delaunay).deviation;
    EXPECT_LT(deviation, last);
    last = deviation;
  }
}

/// Circumcentres in a stretched metric, smoothed, without repairs.
class SmoothingKinds : public ::testing::TestWithParam<Smoothing> {
 protected:
  const FunctionField field_ = testing::shock_field(10, 0.02);
  std::unique_ptr<DelaunayMesh> delaunay_ = refined(field_, {.placement = Placement::Circumcentre});
  const ImproveOptions options_ = {.smoothing = GetParam(), .repairs = 0};
};

TEST_P(SmoothingKinds, LowerTheDeviationByATenthAndRaiseTheQuality) {
  const double deviation = edge_lengths(*delaunay_).deviation;
  const double quality = testing::mean_quality(*delaunay_);
  const ImproveReport report = improve(*delaunay_, field_, options_);
  EXPECT_LT(edge_lengths(*delaunay_).deviation, 0.9 * deviation);
  EXPECT_GT(testing::mean_quality(*delaunay_), quality);
  EXPECT_GT(report.moved, delaunay_->n_vertices() / 2);
  EXPECT_NEAR(valid_area(*delaunay_), 1, 1e-12);
}

TEST_P(SmoothingKinds, GiveEveryVertexTheMetricOfItsPlace) {
  improve(*delaunay_, field_, options_);
  for (std::size_t i = 0; i < delaunay_->n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    ASSERT_EQ(delaunay_->metric(vh), field_(delaunay_->uv(vh)));
  }
}

TEST_P(SmoothingKinds, BringAVertexOfAPerfectMeshBack) {
  const auto delaunay = perfect_mesh(10);
  const VertexHandle middle(5 * 11 + 5);
  const Uv place = delaunay->uv(middle);
  delaunay->uv(middle) = place + Uv{0.3, -0.2};
  improve(*delaunay, testing::isotropic_field(1), {.smoothing = GetParam(), .sweeps = 8});
  EXPECT_NEAR(delaunay->uv(middle).u, place.u, 0.02);
  EXPECT_NEAR(delaunay->uv(middle).v, place.v, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SmoothingKinds,
                         ::testing::Values(Smoothing::Best, Smoothing::Laplace, Smoothing::Element),
                         ::testing::PrintToStringParamName());

TEST(Smoothing, ByANumberIsTheBestKindWithSoManySweeps) {
  const FunctionField field = testing::four_point_field();
  const auto by_number = refined(field, {}), by_kind = refined(field, {});
  EXPECT_EQ(improve(*by_number, field, {.smoothing = sweeps_of(4), .sweeps = 1}),
            improve(*by_kind, field, {.smoothing = Smoothing::Best, .sweeps = 4}));
  EXPECT_EQ(positions(*by_number), positions(*by_kind));
}

TEST(Smoothing, ByElementsAsksAtTheMiddlesOfTrianglesByLaplaceOnlyAtVertices) {
  const FunctionField field = testing::four_point_field();
  const auto asked = [&](Smoothing kind) {
    const auto delaunay = refined(field, {.placement = Placement::Circumcentre});
    const ImproveReport report =
        improve(*delaunay, field, {.smoothing = kind, .sweeps = 1, .repairs = 0});
    return static_cast<double>(report.queries.total()) /
           static_cast<double>(delaunay->n_vertices());
  };
  EXPECT_LT(asked(Smoothing::Laplace), 2.1);
  EXPECT_GT(asked(Smoothing::Element), 5);
  EXPECT_LT(asked(Smoothing::Element), 9);
}

TEST(ImproveOptionsTest, RepairsRaiseTheLeastQuality) {
  const FunctionField field = testing::four_point_field();
  const auto without = refined(field, {}), with = refined(field, {});
  improve(*without, field, {.repairs = 0});
  improve(*with, field, {.repairs = 3});
  EXPECT_GT(least_quality(*with), least_quality(*without));
}

TEST(ImproveOptionsTest, AreRefusedBelowZero) {
  for (const ImproveOptions& bad : {ImproveOptions{.sweeps = 0}, ImproveOptions{.repairs = -1},
                                    ImproveOptions{.smoothing = static_cast<Smoothing>(-4)}}) {
    EXPECT_EQ(error_of([&] { check(bad); }).substr(0, 14), "invalid option");
  }
}

TEST(ImproveFourPoints, ReachesTheFiguresOfThePrototype) {
  const FunctionField field = testing::four_point_field();
  const auto delaunay = refined(field, {});
  improve(*delaunay, field);
  EXPECT_LT(edge_lengths(*delaunay).deviation, 0.06);
  EXPECT_GT(edge_lengths(*delaunay).unit_fraction, 0.999);
  EXPECT_GT(testing::mean_quality(*delaunay), 0.99);
  EXPECT_GT(least_quality(*delaunay), 0.7);
}

TEST(ImproveDegenerate, LeavesADomainWithoutInnerVertices) {
  const FunctionField field = testing::isotropic_field(10);
  const auto delaunay = testing::empty_square(field);
  EXPECT_EQ(improve(*delaunay, field).moved, 0u);
}

TEST(ImproveDegenerate, KeepsTrianglesValidWhereSizesJump) {
  const FunctionField field =
      testing::isotropic_field([](Uv p) { return p.u < 0.5 ? 0.1 : 0.005; });
  const auto delaunay = refined(field, {.placement = Placement::Circumcentre});
  improve(*delaunay, field, {.sweeps = 5, .repairs = 5});
  EXPECT_NEAR(valid_area(*delaunay), 1, 1e-12);
}

}  // namespace
}  // namespace surfmesh
