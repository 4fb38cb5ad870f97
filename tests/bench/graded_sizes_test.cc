// SPDX-License-Identifier: BSD-3-Clause
#include "bench/graded_sizes.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/models.hh"
#include "surfmesh/sizes/model_sources.hh"

namespace surfmesh::judge {
namespace {

/// Two unit squares side by side, with sizes of the given sources alone; hmax is out of reach.
GradedSizes two_squares(double grade, const Sources& sources, SizeFields& fields) {
  static const Model model =
      testing::model_of({testing::rectangle(0, 0, 1, 1), testing::rectangle(1, 0, 2, 1)});
  Sizing sizing;
  sizing.grade = grade;
  sizing.curvature = 0;
  sizing.hmin = Length::units(0.001);
  sizing.hmax = Length::units(10);
  sizing.proximity = 0;
  sizing.features = false;
  const ResolvedSizing resolved = resolve(sizing, model.diagonal);
  const auto by_patch = model_sources(model, sources, resolved);
  std::vector<PatchGrid> grids;
  for (std::size_t p = 0; p < 2; ++p) {
    const Surface& surface = *model.patches[p].surface;
    fields.push_back(std::make_unique<SizeField>(surface, resolved, by_patch[p]));
    grids.push_back(make_grid(surface, 2500));
  }
  return GradedSizes(model, fields, resolved.grade, grids);
}

Sources everywhere(int patch, double size) {
  Sources sources;
  sources.everywhere.push_back({patch, Size::isotropic(Length::units(size))});
  return sources;
}

TEST(GradedSizes, GrowWithTheDistanceFromAContour) {
  SizeFields fields;
  const GradedSizes sizes = two_squares(1.5, everywhere(0, 0.05), fields);
  for (const double x : {1.0, 1.1, 1.33, 1.5, 1.9}) {
    EXPECT_NEAR(sizes.at(1, {x, 0.37}).h11, 0.05 + std::log(1.5) * (x - 1), 0.003) << x;
    EXPECT_NEAR(sizes.at(1, {x, 0.37}).h22, 0.05 + std::log(1.5) * (x - 1), 0.003) << x;
  }
}

TEST(GradedSizes, GrowFromAPointBetweenNodes) {
  Sources sources;
  sources.at.push_back({0, {0.503, 0.497}, Size::isotropic(Length::units(0.05))});
  SizeFields fields;
  const GradedSizes sizes = two_squares(1.5, sources, fields);
  for (const Uv uv : {Uv{0.1, 0.2}, Uv{0.8, 0.3}, Uv{1.2, 0.6}, Uv{1.8, 0.9}}) {
    const double distance = std::hypot(uv.u - 0.503, uv.v - 0.497);
    EXPECT_NEAR(sizes.at(uv.u > 1 ? 1 : 0, uv).h11, 0.05 + std::log(1.5) * distance, 0.01);
  }
}

TEST(GradedSizes, GiveTheMetricAreaOfAConstantSize) {
  SizeFields fields;
  const GradedSizes sizes = two_squares(1.5, everywhere(0, 0.05), fields);
  EXPECT_NEAR(sizes.metric_area(0), 400, 1e-9);
  // ∫ dx / (0.05 + x ln g)² from 0 to 1.
  const double exact = 1 / (0.05 * (0.05 + std::log(1.5)));
  EXPECT_NEAR(sizes.metric_area(1), exact, 0.02 * exact);
}

}  // namespace
}  // namespace surfmesh::judge
