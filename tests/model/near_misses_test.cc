// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/near_miss_notices.hh"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "support/analytic.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/geometry/callable_surface.hh"

namespace surfmesh {
namespace {

using testing::count_shared;

using Patches = std::vector<PatchInput>;

constexpr double kGap = 1e-6;

/// The surface z = 0.2 sin(3u) v over [u0, u0+1] × [v0, v0+1], each point moved by `shift(v)`.
template <class Shift>
PatchInput bent(const std::string& name, double u0, double v0, Shift shift) {
  return {name, make_callable_surface({u0, u0 + 1, v0, v0 + 1}, [=](auto u, auto v) {
            const auto moved = shift(v);
            return std::array{u + moved[0], v + moved[1], 0.2 * sin(3.0 * u) * v + moved[2]};
          })};
}

PatchInput bent(const std::string& name, double u0, double v0) {
  return bent(name, u0, v0, [](auto v) { return std::array{0.0 * v, 0.0 * v, 0.0 * v}; });
}

/// Two such patches side by side, the second of which is moved.
template <class Shift>
Patches two(Shift shift) {
  return {bent("l", 0, 0), bent("r", 1, 0, shift)};
}

Patches moved_by(const Vec3& by) {
  return two([by](auto v) {
    return std::array{by.x() + 0.0 * v, by.y() + 0.0 * v, by.z() + 0.0 * v};
  });
}

PatchInput rectangle_patch(const std::string& name, double x0, double y0, double x1, double y1) {
  return {name, std::make_shared<test::PlanePatch>(Vec3(x0, y0, 0), Vec3(x1 - x0, 0, 0),
                                                   Vec3(0, y1 - y0, 0), Domain{})};
}

Model model_of(const Patches& patches, double joining) {
  return model_from_patches(patches, {}, {Length::units(joining)});
}

Model model_of(const Patches& patches) { return model_from_patches(patches); }

double length_of(const Model& model, const Contour& contour) {
  constexpr int steps = 32;
  double length = 0;
  for (int i = 0; i < steps; ++i) {
    length += (model.point(contour.uses[0], double(i + 1) / steps) -
               model.point(contour.uses[0], double(i) / steps))
                  .norm();
  }
  return length;
}

/// No contour is hardly longer than the joining, nor joins a patch with itself.
void expect_no_scraps(const Model& model) {
  for (const Contour& contour : model.contours) {
    EXPECT_GT(length_of(model, contour), 3 * model.joining) << contour.name;
    std::set<int> patches;
    for (const ContourUse& use : contour.uses) {
      EXPECT_TRUE(patches.insert(use.patch).second) << contour.name;
    }
  }
}

/// The joining that a notice advises; 0 for none.
double advised_joining(const Notice& notice) {
  const std::string words = "joining = ";
  const std::size_t at = notice.text.find(words);
  return at == std::string::npos ? 0 : std::stod(notice.text.substr(at + words.size()));
}

/// The greatest joining that is advised. Each unjoined side has to be told as a shortfall with one.
double greatest_advice(const Model& model) {
  double greatest = 0;
  for (const Notice& notice : model.notices) {
    EXPECT_EQ(notice.kind, NoticeKind::UnjoinedSides);
    EXPECT_EQ(notice.severity, Severity::Shortfall);
    EXPECT_GT(advised_joining(notice), model.joining) << notice.text;
    greatest = std::max(greatest, advised_joining(notice));
  }
  return greatest;
}

/// Two patches with one contour between them, all the way.
bool is_joined_whole(const Model& model) {
  return model.vertices.size() == 6 && model.contours.size() == 7 && count_shared(model) == 1;
}

/// Expect two patches joined all the way, or a notice whose advice does that.
void expect_joined_or_told(const Patches& patches, double joining) {
  SCOPED_TRACE(joining);
  const Model model = model_of(patches, joining);
  expect_no_scraps(model);
  const double advised = greatest_advice(model);
  if (model.notices.empty()) {
    EXPECT_TRUE(is_joined_whole(model));
    return;
  }
  EXPECT_FALSE(is_joined_whole(model));
  const Model joined = model_of(patches, advised);
  EXPECT_TRUE(is_joined_whole(joined)) << model.notices[0].text;
  EXPECT_EQ(texts_of(joined.notices), std::vector<std::string>());
  expect_no_scraps(joined);
}

/// Joinings around a gap, some of them to a rounding, as shares of it.
std::vector<double> shares_around_one() {
  std::vector<double> shares = {1 - 1e-10, 1 - 1e-13, 1, 1 + 1e-13, 1 + 1e-10, 1.1, 1.5, 2};
  for (int i = 0; i < 50; ++i) shares.push_back(0.02 + 0.02 * i);
  return shares;
}

// With 9e-7, the corners were glued over a part of a millionth, and the mesh was folded there.
TEST(Joining, OfSidesApartInHeightIsWholeOrTold) {
  for (const double share : shares_around_one()) {
    expect_joined_or_told(moved_by({0, 0, kGap}), share * kGap);
  }
  EXPECT_EQ(count_shared(model_of(moved_by({0, 0, kGap}), 0.9 * kGap)), 0);
}

TEST(Joining, OfSidesApartInAnyDirectionIsWholeOrTold) {
  for (int i = 0; i < 24; ++i) {
    const double z = (2 * i + 1) / 24.0 - 1, angle = 2.4 * i;
    const double r = std::sqrt(1 - z * z);
    const Vec3 by = kGap * Vec3(r * std::cos(angle), r * std::sin(angle), z);
    SCOPED_TRACE(i);
    for (const double share : shares_around_one())
      expect_joined_or_told(moved_by(by), share * kGap);
  }
}

// The middle is within the joining, or the corners are, or one of them.
TEST(Joining, OfSidesApartByMoreInPlacesIsWholeOrTold) {
  const auto at_one_end = two([](auto v) { return std::array{0.0 * v, 0.0 * v, kGap * v}; });
  const auto at_the_other = two([](auto v) {
    return std::array{kGap * (1.0 - v), 0.0 * v, 0.3 * kGap * (1.0 - v)};
  });
  const auto in_the_middle = two([](auto v) {
    return std::array{0.0 * v, 0.0 * v, 4.0 * kGap * v * (1.0 - v)};
  });
  const auto at_both_ends = two([](auto v) {
    const auto x = 2.0 * v - 1.0;
    return std::array{kGap * x * x, 0.0 * v, 0.5 * kGap * x * x};
  });
  const auto in_waves = two([](auto v) {
    return std::array{0.0 * v, 0.0 * v, kGap * sin(20.0 * v)};
  });
  const auto stretched = two([](auto v) { return std::array{0.0 * v, kGap * v, 0.0 * v}; });
  for (const Patches& patches :
       {at_one_end, at_the_other, in_the_middle, at_both_ends, in_waves, stretched}) {
    for (const double share : shares_around_one()) expect_joined_or_told(patches, share * kGap);
  }
}

// The middle was joined, with scraps as short as the gap at the ends, and nothing told.
TEST(Joining, TellsOfSidesThatAreShiftedAlongEachOther) {
  for (const double gap : {5e-9, kGap, 9e-5}) {
    const Patches patches = {bent("l", 0, 0), bent("r", 1, gap)};
    SCOPED_TRACE(gap);
    expect_joined_or_told(patches, 2.9e-9);
    const Model model = model_of(patches);
    ASSERT_EQ(model.notices.size(), gap < 1e-8 ? 1u : 2u);
    EXPECT_LT(advised_joining(model.notices[0]), 3 * gap);
  }
}

TEST(Joining, NamesTheEndsThatAreNearlyOne) {
  const Model model =
      model_of({rectangle_patch("l", 0, 0, 1, 1), rectangle_patch("r", 1, 1e-5, 2, 1)});
  ASSERT_EQ(model.notices.size(), 1u);
  const Notice& notice = model.notices[0];
  EXPECT_EQ(notice.text,
            "sides end 1e-05 from each other on l:u1, more than 2.24e-09: the contour l:u1#0 is "
            "left between them; joining = 2e-05 joins them");
  EXPECT_EQ(model.contour(notice.contour).name, "l:u1#0");
  ASSERT_TRUE(notice.point.has_value());
  EXPECT_NEAR((*notice.point - Vec3(1, 0, 0)).norm(), 0, 1e-12);
}

// The end of b is the same vertex as that of a, which is too far to divide the side of l.
TEST(Joining, SaysThatOnlyEndsAreApart) {
  const Patches patches = {rectangle_patch("l", 0, 0, 1, 2),
                           rectangle_patch("a", 1 + 1.2 * kGap, 0, 2, 1),
                           rectangle_patch("b", 1 + 0.4 * kGap, 1, 2, 2)};
  const Model model = model_of(patches, kGap);
  ASSERT_EQ(model.notices.size(), 2u);
  EXPECT_EQ(model.notices[1].text,
            "contours l:u1 and b:u0 are not joined: they are within 1e-06 of each other, but their "
            "ends are not; joining = 2e-06 joins them");
  EXPECT_EQ(texts_of(model_of(patches, 2 * kGap).notices), std::vector<std::string>());
}

// Both sides of a short piece may be joined, and yet be short by mistake.
TEST(Joining, TellsOfRowsOfPatchesThatAreShifted) {
  const Patches patches = {rectangle_patch("a", 0, 0, 1, 1), rectangle_patch("b", 0, 1, 1, 2),
                           rectangle_patch("c", 1, kGap, 2, 1 + kGap),
                           rectangle_patch("d", 1, 1 + kGap, 2, 2 + kGap)};
  const Model model = model_of(patches);
  EXPECT_EQ(model.notices.size(), 3u);
  const Model joined = model_of(patches, greatest_advice(model));
  EXPECT_EQ(joined.vertices.size(), 9u);
  EXPECT_EQ(count_shared(joined), 4);
  EXPECT_EQ(texts_of(joined.notices), std::vector<std::string>());
}

/// A gap that is told as sides along each other is not told at its ends again.
TEST(Joining, TellsOfASlotOnce) {
  const Model model =
      model_of({rectangle_patch("l", 0, 0, 1, 1), rectangle_patch("a", 1, 0, 2, 0.5),
                rectangle_patch("b", 1, 0.5 + kGap, 2, 1)});
  EXPECT_EQ(texts_of(model.notices).size(), 1u);
}

TEST(Joining, LeavesPatchesThatAreNarrow) {
  for (const double width : {1e-7, 1e-6, 5e-5}) {
    Patches patches = {rectangle_patch("l", 0, 0, 1, 1), rectangle_patch("narrow", 1, 0, 2, width),
                       rectangle_patch("r", 1, width, 2, 1)};
    for (int i = 0; i < 2; ++i) {
      const Model model = model_of(patches);
      EXPECT_EQ(texts_of(model.notices), std::vector<std::string>()) << width;
      EXPECT_EQ(count_shared(model), 3) << width;
      std::reverse(patches.begin(), patches.end());
    }
  }
}

TEST(Joining, LeavesRowsOfShortSidesThatAreStaggered) {
  Patches patches = {rectangle_patch("far", 0, 10, 1, 11)};
  for (int i = 0; i < 4; ++i) {
    const double y = 1e-3 * i;
    patches.push_back(rectangle_patch(fmt::format("l{}", i), 0, y, 1e-3, y + 1e-3));
    patches.push_back(rectangle_patch(fmt::format("r{}", i), 1e-3, y + 5e-5, 2e-3, y + 1.05e-3));
  }
  EXPECT_EQ(texts_of(model_of(patches).notices), std::vector<std::string>());
}

/// A surface that is moved.
std::shared_ptr<const Surface> moved(const std::shared_ptr<const Surface>& surface,
                                     const Vec3& by) {
  return std::make_shared<test::Placed>(surface, 1, by);
}

/// Expect as many vertices and contours as without a gap, or a notice whose advice does that. The
/// second patch is moved.
void expect_closed_or_told(const Patches& exact) {
  const Model whole = model_of(exact);
  ASSERT_TRUE(whole.notices.empty());
  const auto is_whole = [&](const Model& model) {
    return model.vertices.size() == whole.vertices.size() &&
           model.contours.size() == whole.contours.size();
  };
  for (int i = 0; i < 6; ++i) {
    const double z = (2 * i + 1) / 6.0 - 1, angle = 2.4 * i, r = std::sqrt(1 - z * z);
    Patches patches = exact;
    const Vec3 by = kGap * Vec3(r * std::cos(angle), r * std::sin(angle), z);
    patches[1].surface = moved(patches[1].surface, by);
    for (const double share : shares_around_one()) {
      SCOPED_TRACE(fmt::format("{} {}", i, share));
      const Model model = model_of(patches, share * kGap);
      for (const Contour& contour : model.contours) {
        if (contour.is_degenerate) continue;
        EXPECT_GT(length_of(model, contour), 3 * model.joining) << contour.name;
      }
      if (model.notices.empty()) {
        EXPECT_TRUE(is_whole(model));
        continue;
      }
      const Model joined = model_of(patches, greatest_advice(model));
      EXPECT_TRUE(is_whole(joined)) << model.notices[0].text;
      EXPECT_EQ(texts_of(joined.notices), std::vector<std::string>());
    }
  }
}

TEST(Joining, OfClosedSidesIsWholeOrTold) {
  using std::numbers::pi;
  expect_closed_or_told({{"a", std::make_shared<test::Cylinder>(1, Domain{0, 2 * pi, 0, 1})},
                         {"b", std::make_shared<test::Cylinder>(1, Domain{1, 1 + 2 * pi, 1, 2})}});
}

TEST(Joining, OfHalvesOfASphereIsWholeOrTold) {
  using std::numbers::pi;
  expect_closed_or_told(
      {{"a", std::make_shared<test::Sphere>(1, Domain{0, pi, -pi / 2, pi / 2})},
       {"b", std::make_shared<test::Sphere>(1, Domain{-pi, 0, -pi / 2, pi / 2})}});
}

TEST(Joining, OfAQuarterOfATorusIsWholeOrTold) {
  using std::numbers::pi;
  const auto part = [](double u, double v) {
    return std::make_shared<test::Torus>(2, 0.5, Domain{u, u + pi, v, v + pi});
  };
  expect_closed_or_told(
      {{"a", part(0, 0)}, {"b", part(pi, 0)}, {"c", part(0, pi)}, {"d", part(pi, pi)}});
}

TEST(Joining, OfTJunctionsIsWholeOrTold) {
  expect_closed_or_told({rectangle_patch("l", 0, 0, 1, 1), rectangle_patch("a", 1, 0, 2, 0.4),
                         rectangle_patch("b", 1, 0.4, 2, 1), rectangle_patch("c", 0, 1, 2, 2)});
}

/// The end of a side is within the joining of both sides of a sharp corner, and many joinings from
/// it: these are not a seam.
TEST(Joining, NeverFoldsASharpCorner) {
  const PatchInput sharp = {
      "sharp", make_callable_surface({0, 1, 0, 1}, [](auto u, auto v) {
        return std::array{u + v - 0.98 * u * v, 0.05 * v - 0.025 * u * v, 0.0 * u};
      })};
  const PatchInput beside = {"beside",
                             std::make_shared<test::PlanePatch>(Vec3(8e-6, 2e-7, 0), Vec3(0, 0, 1),
                                                                Vec3(0, -1, 0.5), Domain{})};
  const Model model = model_of({sharp, beside}, 1e-6);
  EXPECT_EQ(side_uses(model, "sharp:u0").size(), 2u);
  EXPECT_EQ(side_uses(model, "sharp:v0").size(), 2u);
  expect_no_scraps(model);
}

}  // namespace
}  // namespace surfmesh
