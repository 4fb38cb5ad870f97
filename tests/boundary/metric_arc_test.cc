// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/boundary/metric_arc.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/cancelling.hh"
#include "support/errors.hh"
#include "support/metric_fields.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::constant_field;
using testing::FunctionField;
using testing::isotropic_field;

/// The bound that the header tells.
constexpr double kArcError = 1e-3;

const SegmentCurve kAlongU({0, 0}, {1, 0});

CallableCurve circle(double radius) {
  return CallableCurve([=](double t) {
    return Uv{radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t)};
  });
}

TEST(MetricArc, InAConstantMetricIsTheLengthOfTheStep) {
  const SegmentCurve line({0, 0}, {3, 4});
  EXPECT_NEAR(MetricArc(line, constant_field({1, 0, 1})).length(), 5, 1e-13);
  EXPECT_NEAR(MetricArc(line, constant_field({4, 1, 9})).length(), std::sqrt(204), 1e-12);
}

TEST(MetricArc, EndsWithFewQueriesOnceItIsCancelled) {
  testing::Cancelling observer;
  const RunContext context(&observer);
  const auto field = isotropic_field(1e-5);
  EXPECT_EQ(error_of([&] { MetricArc(kAlongU, field, context); }), testing::kCancelled);
  EXPECT_LE(field.queries(), kStepsBetweenCancellation);
}

TEST(MetricArc, OfASizeThatGrowsLinearlyIsALogarithm) {
  for (const double slope : {0.1, 1.0, 10.0}) {
    const auto field = isotropic_field([=](Uv uv) { return 0.1 * (1 + slope * uv.u); });
    const double exact = 10 * std::log(1 + slope) / slope;
    EXPECT_NEAR(MetricArc(kAlongU, field).length(), exact, kArcError * exact) << slope;
  }
}

TEST(MetricArc, OfASizeThatGrowsGeometricallyIsExact) {
  // ∫ du / (0.01 100^u) = (100 − 1) / ln 100
  const auto field = isotropic_field([](Uv uv) { return 0.01 * std::pow(100, uv.u); });
  EXPECT_NEAR(MetricArc(kAlongU, field).length(), 99 / std::log(100), 1e-11);
}

TEST(MetricArc, OfASizeWithANarrowDipKeepsItsBound) {
  // 1/h = 1 + 100 / (1 + (u − c)²/w²): an arctangent.
  for (const double w : {0.1, 0.03, 0.01}) {
    const double c = 0.37;
    const auto field = isotropic_field(
        [=](Uv uv) { return 1 / (10 + 100 / (1 + (uv.u - c) * (uv.u - c) / (w * w))); });
    const double exact = 10 + 100 * w * (std::atan((1 - c) / w) + std::atan(c / w));
    EXPECT_NEAR(MetricArc(kAlongU, field).length(), exact, kArcError * exact) << w;
  }
}

TEST(MetricArc, OfACircleIsItsCircumference) {
  for (const double radius : {0.01, 1.0, 100.0}) {
    const double exact = 2 * pi * radius;
    EXPECT_NEAR(MetricArc(circle(radius), constant_field({1, 0, 1})).length(), exact,
                kArcError * exact)
        << radius;
  }
}

TEST(MetricArc, SeesACurveThatMeetsItsChordAtAllDyadicParameters) {
  for (const int periods : {4, 8, 16, 24, 32}) {
    const CallableCurve wave([=](double t) { return Uv{t, 0.1 * std::sin(2 * pi * periods * t)}; });
    double exact = 0;
    for (int i = 0; i < 20'000; ++i) {
      const Uv step = wave.evaluate((i + 1) / 20e3) - wave.evaluate(i / 20e3);
      exact += 2 * std::hypot(step.u, step.v);
    }
    EXPECT_NEAR(MetricArc(wave, isotropic_field(0.5)).length(), exact, 0.01 * exact) << periods;
  }
}

TEST(MetricArc, IsZeroAtTheStartAndTheLengthAtTheEnd) {
  const MetricArc arc(circle(3), constant_field({1, 0, 1}));
  EXPECT_EQ(arc.arc(0), 0);
  EXPECT_EQ(arc.arc(1), arc.length());
  EXPECT_EQ(arc.parameter(0), 0);
  EXPECT_EQ(arc.parameter(arc.length()), 1);
}

TEST(MetricArc, OutsideItsRangeIsThatOfTheEnds) {
  const MetricArc arc(circle(3), constant_field({1, 0, 1}));
  EXPECT_EQ(arc.arc(-0.1), 0);
  EXPECT_EQ(arc.arc(1.1), arc.length());
  EXPECT_EQ(arc.parameter(-1), 0);
  EXPECT_EQ(arc.parameter(1e9), 1);
}

TEST(MetricArc, GrowsWithTheParameter) {
  const auto field = isotropic_field([](Uv uv) { return 0.1 + 0.09 * std::sin(20 * uv.u); });
  const MetricArc arc(kAlongU, field);
  double last = 0;
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_GT(arc.arc(i / 1000.0), last);
    last = arc.arc(i / 1000.0);
  }
}

TEST(MetricArc, IsTheInverseOfItsParameter) {
  const auto field = isotropic_field([](Uv uv) { return 0.01 * std::pow(50, uv.u); });
  const MetricArc arc(kAlongU, field);
  for (int i = 0; i <= 100; ++i) {
    EXPECT_NEAR(arc.parameter(arc.arc(i / 100.0)), i / 100.0, 1e-12);
    const double length = arc.length() * i / 100;
    EXPECT_NEAR(arc.arc(arc.parameter(length)), length, 1e-12 * arc.length());
  }
}

TEST(MetricArc, BetweenStationsKeepsItsBound) {
  const auto field = isotropic_field([](Uv uv) { return 0.01 * std::pow(50, uv.u); });
  const MetricArc arc(kAlongU, field);
  for (int i = 0; i <= 997; ++i) {
    const double t = i / 997.0;
    const double exact = 100 * (1 - std::pow(50, -t)) / std::log(50);
    EXPECT_NEAR(arc.arc(t), exact, kArcError * arc.length());
  }
}

TEST(MetricArc, IsTheSameBackwards) {
  const auto field = isotropic_field([](Uv uv) { return 0.05 + 0.1 * uv.u * uv.u; });
  const SegmentCurve back({1, 0}, {0, 0});
  const double length = MetricArc(kAlongU, field).length();
  EXPECT_NEAR(MetricArc(back, field).length(), length, 2 * kArcError * length);
}

TEST(MetricArc, IsTheSameAtAnyScaleOfTheParameters) {
  const auto field = constant_field({4, 1, 9});
  const auto scaled = constant_field({4e-12, 1e-3, 9e6});
  const SegmentCurve line({0, 0}, {3, 4}), far({0, 0}, {3e6, 4e-3});
  EXPECT_NEAR(MetricArc(far, scaled).length(), MetricArc(line, field).length(), 1e-9);
}

TEST(MetricArc, AsksForTheMetricAtFourToEightPlacesAUnit) {
  const MetricArc longer(kAlongU, isotropic_field(0.001));
  EXPECT_LE(static_cast<double>(longer.queries().total()), 8 * longer.length());
  EXPECT_LE(MetricArc(kAlongU, isotropic_field(100)).queries().total(), 17U);
}

TEST(MetricArc, EndsOnALineOfInfiniteLength) {
  // ∫ du/u is infinite: the cuts have an end.
  const auto field = isotropic_field([](Uv uv) { return uv.u + 1e-100; });
  const MetricArc arc(kAlongU, field);
  EXPECT_TRUE(std::isfinite(arc.length()));
}

TEST(MetricArc, RefusesAMetricThatIsNotFiniteByItsPlace) {
  for (const Metric& bad : {Metric{kUnset, 0, 1}, Metric{1, kUnset, 1}, Metric{1, 0, INFINITY}}) {
    const FunctionField field([=](Uv uv) { return uv.u == 1 ? bad : Metric{1, 0, 1}; });
    const std::string error = error_of([&] { MetricArc(kAlongU, field); });
    EXPECT_EQ(error.rfind(name(ErrorCode::Geometry), 0), 0U) << error;
    EXPECT_NE(error.find("(u,v) = (1, 0)"), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace surfmesh
