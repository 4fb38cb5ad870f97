// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/hand_made.hh"
#include "support/errors.hh"
#include "support/models.hh"
#include "support/waves.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/geometry/curve_polyline.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/model/finish_model.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/sizes/boundary_pieces.hh"
#include "surfmesh/sizes/features.hh"
#include "surfmesh/sizes/model_sources.hh"
#include "surfmesh/sizes/proximity.hh"

namespace surfmesh {
namespace {

using testing::model_of;
using testing::rectangle;

Sizing sizing_for_gaps(double hmax, double proximity = 1) {
  Sizing result = testing::sizing_of(0, 1e-4, hmax, 2);
  result.grade = 1.5;
  result.proximity = proximity;
  return result;
}

std::vector<PlacedSize> gaps(const Model& model, double hmax, double proximity = 1) {
  const Sizing own = sizing_for_gaps(hmax, proximity);
  return proximity_sizes(model, resolve(own, 1))[0];
}

/// Size across a gap in which one row of unit triangles fits.
constexpr double kOfOneRow = 2 / std::numbers::sqrt3;

/// A tube of 16 × 4 quads whose seam is not joined: its vertices are there twice.
Model unjoined_tube() {
  constexpr int columns = 16, rows = 4;
  Cage cage;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double angle = 2 * std::numbers::pi * (i % columns) / columns;
      cage.points.emplace_back(std::cos(angle), std::sin(angle), j);
    }
  }
  const auto at = [](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return model_from_cage(cage);
}

// Pieces of sides without a distance were halved to the end, and minutes went by.
TEST(Proximity, SeesNoGapWhereSidesCoincideThatAreNotJoined) {
  const Model model = unjoined_tube();
  const Sizing own = testing::sizing_of(0, 1e-3, 0.5, 2);
  for (const auto& sizes : proximity_sizes(model, resolve(own, model.diagonal))) {
    EXPECT_TRUE(sizes.empty());
  }
}

/// A disc of radius 1.
Model disc() {
  const auto circle = std::make_shared<CallableCurve>([](double t) {
    const double angle = 2 * std::numbers::pi * t;
    return Uv{std::cos(angle), std::sin(angle)};
  });
  return model_from_patches({{"p", rectangle(-2, -2, 2, 2), {{"rim"}}}},
                            {{"rim", nullptr, {{"p", circle}}}});
}

// Each of thousands of corners was compared with all within reach, as none faced it.
TEST(Proximity, LooksAtFewPiecesOfABoundaryWithNothingOpposite) {
  const Model model = disc();
  const detail::BoundaryPieces pieces(model, {0}, 1e-5, 1e-3, 0.5);
  std::size_t offered = 0;
  const auto accept = [&](const detail::BoundaryPoint&) {
    ++offered;
    return false;
  };
  for (const detail::BoundaryPiece& piece : pieces.all()) {
    pieces.nearest(piece.middle, {piece.inward, -0.5, 0.5}, accept);
  }
  EXPECT_GT(pieces.all().size(), 500u);
  EXPECT_LT(offered, 2 * pieces.all().size());
}

TEST(Proximity, IsTheSizeOfARowThatFillsAStrip) {
  const auto sizes = gaps(model_of({rectangle(0, 0, 3, 0.1)}), 1);
  ASSERT_FALSE(sizes.empty());
  for (const PlacedSize& placed : sizes) {
    EXPECT_NEAR(placed.at_from.along, kOfOneRow * 0.1, 1e-12);
    EXPECT_NEAR(placed.at_from.across, kOfOneRow * 0.2, 1e-12);
    EXPECT_NEAR(std::abs(placed.to.y() - placed.from.y()), 0.1, 1e-12);
    EXPECT_NEAR(placed.to.x(), placed.from.x(), 1e-12);
  }
}

TEST(Proximity, CoversTheWholeStrip) {
  const auto sizes = gaps(model_of({rectangle(0, 0, 3, 0.1)}), 1);
  for (double x = 0; x <= 3; x += 0.01) {
    EXPECT_TRUE(std::any_of(sizes.begin(), sizes.end(), [x](const PlacedSize& placed) {
      return std::abs(placed.from.x() - x) <= placed.radius;
    })) << x;
  }
}

TEST(Proximity, DividesByTheNumberOfElements) {
  for (const PlacedSize& placed : gaps(model_of({rectangle(0, 0, 3, 0.1)}), 0.7, 4)) {
    EXPECT_NEAR(placed.at_from.along, kOfOneRow * 0.025, 1e-12);
  }
}

TEST(Proximity, IsNothingWhereSizesAreSmallerOrItIsOff) {
  EXPECT_TRUE(gaps(model_of({rectangle(0, 0, 3, 0.1)}), 0.09).empty());
  EXPECT_TRUE(gaps(model_of({rectangle(0, 0, 3, 0.1)}), 1, 0).empty());
  EXPECT_FALSE(gaps(model_of({rectangle(0, 0, 3, 0.1)}), 0.09, 2).empty());
}

TEST(Proximity, IsTheGapBesideAHole) {
  double least = 1;
  for (const PlacedSize& placed : gaps(testing::square_with_hole(0.9), 1)) {
    least = std::min(least, placed.at_from.along);
  }
  EXPECT_NEAR(least, kOfOneRow * 0.1, 0.01);
}

TEST(Proximity, IsTheDistanceToTheNearestOfManyPieces) {
  int count = 0;
  for (const PlacedSize& placed : gaps(testing::square_with_hole(0.9), 0.5)) {
    if (placed.from.norm() > 0.95) continue;  // not on the hole
    ++count;
    const double x = std::abs(placed.from.x()), y = std::abs(placed.from.y());
    EXPECT_NEAR(placed.at_from.along, kOfOneRow * (1 - std::max(x, y)), 1e-12) << x << " " << y;
  }
  EXPECT_GT(count, 30);
}

/// Half a ring of radius 1 with a width.
Model half_ring(double width) {
  return model_of({make_callable_surface(Domain{0, std::numbers::pi, 0, 1}, [=](auto u, auto v) {
    return std::array{(1 - width * v) * cos(u), (1 - width * v) * sin(u), 0 * u};
  })});
}

TEST(Proximity, IsTheWidthOfACurvedStripWhateverHmax) {
  for (const double width : {0.05, 1e-3, 1e-5}) {
    for (const double hmax : {0.1, 0.4, 1.0}) {
      Sizing own = sizing_for_gaps(hmax);
      own.hmin = Length::units(1e-7);
      const auto sizes = proximity_sizes(half_ring(width), resolve(own, 1))[0];
      double covered = 0;
      for (const PlacedSize& placed : sizes) {
        EXPECT_NEAR(placed.at_from.along, kOfOneRow * width, 0.06 * width) << hmax;
        if (placed.from.norm() > 1 - 0.1 * width) covered += 2 * placed.radius;
      }
      EXPECT_NEAR(covered, std::numbers::pi, 0.01 + 4 * width) << width << " " << hmax;
    }
  }
}

TEST(Proximity, GoesAcrossPatchesThatASmoothContourJoins) {
  // Two halves of a strip along its middle line: the gap is the whole.
  const Model model = model_of({rectangle(0, 0, 3, 0.05), rectangle(0, 0.05, 3, 0.1)});
  const Sizing own = sizing_for_gaps(1);
  for (const auto& sizes : proximity_sizes(model, resolve(own, 1))) {
    ASSERT_FALSE(sizes.empty());
    for (const PlacedSize& placed : sizes) {
      EXPECT_NEAR(placed.at_from.along, kOfOneRow * 0.1, 1e-12);
    }
  }
}

TEST(Proximity, IsNotInACornerOfAStraightAndACurvedSide) {
  // An arc of radius 1 and a chord of it that meet at 40°.
  const double half = 40 * std::numbers::pi / 180;
  const auto segment = make_callable_surface(Domain{-half, half, 0, 1}, [=](auto u, auto v) {
    return std::array{sin(u), cos(half) * (1 - v) + cos(u) * v, 0 * u};
  });
  for (const double hmax : {0.02, 0.1, 0.5, 2.0}) {
    EXPECT_TRUE(gaps(model_of({segment}), hmax).empty()) << hmax;
  }
}

TEST(ClampWarning, CountsSourcesAndTables) {
  const Model model = model_of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)});
  const SizeBounds bounds = resolve(sizing_for_gaps(0.5), 1).bounds;
  Sources sources;
  sources.everywhere = {{0, testing::size_of(0.2)}};
  EXPECT_FALSE(clamp_notice(model, sources, bounds).has_value());
  sources.everywhere = {{0, testing::size_of(2)}, {1, testing::size_of(2)}};
  EXPECT_EQ(clamp_notice(model, sources, bounds)->text,
            "1 size of sources is brought into the bounds hmin = 0.0001 and hmax = 0.5");
  sources.tables = {{1, {{{1, 0}, {}, {1, 0, 1}}, {{2, 1}, {}, {9, 0, 9}}}}};
  EXPECT_EQ(clamp_notice(model, sources, bounds)->text,
            "2 sizes of sources are brought into the bounds hmin = 0.0001 and hmax = 0.5");
}

TEST(Proximity, IsNotAcrossAHole) {
  EXPECT_TRUE(gaps(testing::square_with_hole(0.1), 0.5).empty());
}

TEST(Proximity, IsNotInAnOrdinaryCorner) {
  // The triangle (0,0), (1,0), (1,0.6) as a patch: a corner of 31° at its pole.
  const auto wedge = make_callable_surface(Domain{0, 1, 0, 1}, [](auto u, auto v) {
    return std::array{u, 0.6 * u * v, 0 * u};
  });
  for (const PlacedSize& placed : gaps(model_of({wedge}), 2)) {
    EXPECT_GT(placed.at_from.along, 0.2);
  }
}

std::vector<PlacedSize> features_of(double radius, double hmax, double grade) {
  const CallableSpaceCurve circle([=](double t) -> Vec3 {
    const double angle = 2 * std::numbers::pi * t;
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
  });
  Sizing own = sizing_for_gaps(hmax);
  own.grade = grade;
  return feature_sizes(circle, resolve(own, 1));
}

TEST(Features, HaveTheLengthOfAShortContour) {
  const double whole = 2 * std::numbers::pi * 0.01;
  const auto sizes = features_of(0.01, 0.5, 1.5);
  ASSERT_FALSE(sizes.empty());
  for (const PlacedSize& placed : sizes) {
    EXPECT_NEAR(placed.at_from.along, whole, 0.05 * whole);
    EXPECT_EQ(placed.at_from.along, placed.at_to.across);
  }
}

TEST(Features, AreNoneOfALongContour) { EXPECT_TRUE(features_of(0.1, 0.5, 1.5).empty()); }

TEST(Features, ReachAnElementWithoutGradation) {
  for (const PlacedSize& placed : features_of(0.01, 0.5, 0)) {
    EXPECT_NEAR(placed.radius, 0.5 * placed.at_from.along, 1e-12);
  }
}

TEST(CurvePolyline, StaysNearTheCurve) {
  const CallableSpaceCurve circle([](double t) -> Vec3 {
    return {std::cos(7 * t), std::sin(7 * t), t};
  });
  for (const double tolerance : {0.1, 0.01, 1e-3}) {
    const auto points = curve_polyline(circle, tolerance);
    EXPECT_EQ(points.front().t, 0);
    EXPECT_EQ(points.back().t, 1);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec3 middle = circle.evaluate(0.5 * (points[i - 1].t + points[i].t));
      const Vec3 chord = points[i].point - points[i - 1].point;
      EXPECT_LE((middle - points[i - 1].point).cross(chord).norm() / chord.norm(), tolerance);
    }
  }
}

TEST(CurvePolyline, HasTheLengthOfTheCurve) {
  const CallableSpaceCurve circle([](double t) -> Vec3 {
    return {std::cos(6 * t), std::sin(6 * t), 0};
  });
  EXPECT_NEAR(length(curve_polyline(circle, 1e-5)), 6, 1e-3);
}

/// A line of forty parts, straight but for a bump in the first quarter of one of them.
class LineWithBump : public SpaceCurve {
 public:
  Vec3 evaluate(double t) const override {
    const double inside = 40 * t - 17.02;
    const double height = inside > 0 && inside < 0.25 ? std::sin(4 * std::numbers::pi * inside) : 0;
    return {40 * t, 0.1 * height * height, 0};
  }
  std::vector<double> breaks() const override { return even_breaks(40); }
};

TEST(CurvePolyline, SeesWhatIsInEachPart) {
  double greatest = 0;
  for (const CurvePoint& point : curve_polyline(LineWithBump(), 0.01)) {
    greatest = std::max(greatest, point.point.y());
  }
  EXPECT_GT(greatest, 0.05);
}

TEST(ModelSources, GoToAllPatchesOfAContour) {
  // Two half cylinders: their rims are curved, the joints between them are smooth and straight.
  const double pi = std::numbers::pi;
  const Model model = model_of({testing::cylinder(0, pi), testing::cylinder(pi, 2 * pi)});
  Sizing own;
  own.proximity = 0;
  own.features = false;
  for (const PatchSources& sources : model_sources(model, {}, resolve(own, model.diagonal))) {
    ASSERT_EQ(sources.trees.size(), 1u);
    for (const PlacedSize& placed : sources.trees[0]->sizes()) {
      EXPECT_NEAR(placed.at_from.along, 0.25, 1e-6);
    }
  }
}

TEST(ModelSources, HaveNothingOfContoursThatIsOff) {
  const Model model = model_of({testing::cylinder(0, 1)});
  Sizing own;
  own.contour_curvature = own.features = false;
  own.proximity = 0;
  EXPECT_TRUE(model_sources(model, {}, resolve(own, model.diagonal))[0].trees.empty());
  own.contour_curvature = true;
  own.curvature = 0;
  EXPECT_TRUE(model_sources(model, {}, resolve(own, model.diagonal))[0].trees.empty());
}

TEST(ModelSources, ShareWhatIsNearAPlaceInSpace) {
  Sources sources;
  sources.near.push_back({{Vec3::Zero()}, {testing::size_of(0.1)}});
  Sizing own = sizing_for_gaps(0.01);
  const auto all = model_sources(testing::model_of({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)}),
                                 sources, resolve(own, 1));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].trees.at(0), all[1].trees.at(0));
}

TEST(ModelSources, NeedARadiusNearAPlaceWithoutGradation) {
  Sources sources;
  sources.near.push_back({{Vec3(1, 2, 3)}, {testing::size_of(0.1)}});
  Sizing own = sizing_for_gaps(1);
  own.grade = 0;
  const Model model = model_of({rectangle(0, 0, 1, 1)});
  EXPECT_NE(error_of([&] {
              model_sources(model, sources, resolve(own, model.diagonal));
            }).find("near (1, 2, 3)"),
            std::string::npos);
  sources.near[0].wish.radius = testing::units(0.1);
  EXPECT_EQ(error_of([&] { model_sources(model, sources, resolve(own, model.diagonal)); }),
            "no error");
}

/// A square of side 10, and a round hole in it that touches its lower side in a corner of both.
Model square_with_touching_hole() {
  testing::HandMade made;
  const int patch = made.add_patch(testing::rectangle(0, 0, 10, 10));
  const auto corners = made.corners_at({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}});
  made.add_loop(patch, corners);
  const int hole = made.add_contour(corners[1].first, corners[1].first);
  made.model.contour(hole).uses.push_back(
      {patch, std::make_shared<CallableCurve>([](double t) {
         const double angle = -2 * std::numbers::pi * t - std::numbers::pi / 2;
         return t == 0 || t == 1 ? Uv{5, 0} : Uv{5 + 2 * std::cos(angle), 2 + 2 * std::sin(angle)};
       })});
  made.model.patch(patch).loops.push_back({{hole, 0}});
  finish(made.model);
  return made.model;
}

TEST(ProximitySizes, AreNoneInACusp) {
  const Sizing sizing_for_gaps{.hmin = Length::units(0.001), .hmax = Length::units(0.5)};
  const Model model = square_with_touching_hole();
  const auto sizes = proximity_sizes(model, resolve(sizing_for_gaps, model.diagonal));
  EXPECT_TRUE(sizes.at(0).empty());
}

}  // namespace
}  // namespace surfmesh
