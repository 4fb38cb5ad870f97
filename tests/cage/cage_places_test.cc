// SPDX-License-Identifier: BSD-3-Clause
// Where points of surfaces lie on their cages, and what the corners of faces have to say there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/cage/cage_surface.hh"
#include "surfmesh/cage/face_weights.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/geometry/plane_surface.hh"

namespace surfmesh {
namespace {

using testing::split;
using testing::turned;

constexpr std::array kShares = {Uv{0.125, 0.25}, Uv{0.7, 0.2}, Uv{0.4, 0.55}, Uv{0, 0}, Uv{0.5, 0}};

/// Room for the rounding of a few operations on coordinates up to 5.
constexpr double kRounding = 1e-13;

/// What the corners of a face tell of a place: a mean of their points.
Vec3 point_of(const Cage& cage, const CagePlace& place) {
  const std::vector<double> weights = face_weights(cage, place);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, kRounding);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const int vertex = cage.faces[static_cast<std::size_t>(place.face)][i];
    sum += weights[i] * cage.points[static_cast<std::size_t>(vertex)];
  }
  return sum;
}

/// The surface is bilinear, or a plane with evenly spaced vertices: its points are the means.
void expect_means(const Cage& cage, const CageOptions& options) {
  const Model model = model_from_cage(cage, options);
  for (const Patch& patch : model.patches) {
    ASSERT_EQ(patch.cage->faces, cage.faces);
    const CellCount cells = patch.surface->cells();
    const bool is_triangle = patch.surface->domain().shape == Domain::Shape::Triangle;
    for (int cell = 0; cell < cells.u * cells.v; ++cell) {
      for (Uv uv : kShares) {
        if (is_triangle && uv.u + uv.v > 1) continue;
        uv = uv + Uv{static_cast<double>(cell % cells.u), static_cast<double>(cell / cells.u)};
        const CagePlace place = cage_place(*patch.surface, uv);
        EXPECT_TRUE(std::count(patch.cage_faces.begin(), patch.cage_faces.end(), place.face));
        const Vec3 point = patch.surface->evaluate(uv, Order::Position).point;
        EXPECT_LT((point_of(cage, place) - point).norm(), kRounding) << patch.name;
      }
    }
  }
}

/// A plane of evenly spaced points whose faces begin at any of their corners.
Cage plane_of_turned_quads(int m, int n) {
  Cage cage;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= m; ++i) cage.points.emplace_back(i, 0.5 * j, 0.25 * i);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      const int at = j * (m + 1) + i;
      cage.faces.push_back({at, at + 1, at + m + 2, at + m + 1});
      std::rotate(cage.faces.back().begin(), cage.faces.back().begin() + (i + 3 * j) % 4,
                  cage.faces.back().end());
    }
  }
  cage.boundary = BoundaryRule::EdgeAndCorner;
  return cage;
}

TEST(CagePlaces, AreOnFacesAsGiven) {
  for (const Cage& cage : {testing::cube(), testing::torus(), plane_of_turned_quads(3, 2)}) {
    expect_means(cage, {.scheme = Scheme::Bilinear});
  }
}

TEST(CagePlaces, AreInQuartersOfPolygons) {
  for (const Cage& cage :
       {testing::pentagon_prism(), testing::tetrahedron(), testing::triangle_sheet()}) {
    expect_means(cage, {.scheme = Scheme::Bilinear});
  }
}

TEST(CagePlaces, KnowHowFacesLieInBlocks) {
  const Cage cage = plane_of_turned_quads(4, 3);
  ASSERT_EQ(model_from_cage(cage).patches.size(), 1u);
  expect_means(cage, {});
  expect_means(cage, {.patches = PatchKind::Faces});
}

TEST(CagePlaces, AreOnFacesThatWereTurned) {
  const CageOptions options{.scheme = Scheme::Bilinear, .orient = true};
  expect_means(turned(testing::cube(), {2, 4}), options);
  expect_means(turned(testing::pentagon_prism(), {0, 3}), options);
  expect_means(turned(testing::icosahedron(), {1, 5, 6}), options);
}

TEST(CagePlaces, AreOnFacesAsTheyWereBeforeWelding) {
  const CageOptions options{.scheme = Scheme::Bilinear, .weld = Length::units(1e-6)};
  expect_means(split(testing::cube()), options);
  expect_means(split(testing::pentagon_prism()), options);
}

TEST(CagePlaces, LeaveOutSidesThatArePoints) {
  Cage cage = testing::pentagon_prism();
  for (std::vector<int>& face : cage.faces) face.insert(face.begin() + 1, face[1]);
  expect_means(cage, {.scheme = Scheme::Bilinear});
  // The side is a point once its ends are welded.
  Cage apart = cage;
  for (std::vector<int>& face : apart.faces) {
    apart.points.push_back(apart.points[static_cast<std::size_t>(face[1])]);
    face[1] = static_cast<int>(apart.points.size()) - 1;
  }
  expect_means(apart, {.scheme = Scheme::Bilinear, .weld = Length::units(1e-6)});
}

TEST(CagePlaces, SkipFacesThatAreLeftOut) {
  Cage cage = testing::cube();
  const auto& f = cage.faces;
  cage.faces = {f[0], {0, 1, 0, 2}, f[1], f[0], f[2], f[3], f[4], f[5]};
  expect_means(cage, {.scheme = Scheme::Bilinear});
}

TEST(CagePlaces, OfTrianglesAreBarycentric) {
  const Cage cage = testing::octahedron();
  const auto surfaces = make_limit_surfaces(cage, Scheme::Loop);
  const CagePlace place = cage_place(*surfaces[3], {0.25, 0.5});
  EXPECT_EQ(place.face, 3);
  EXPECT_EQ(place.part, -1);
  EXPECT_EQ(face_weights(cage, place), (std::vector{0.25, 0.25, 0.5}));
}

TEST(CagePlaces, OfOtherSurfacesAreOnNoFace) {
  const PlaneSurface plane(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {});
  EXPECT_EQ(cage_place(plane, {0.5, 0.5}).face, -1);
}

TEST(FaceWeights, RefusePlacesThatAreNotThere) {
  const Cage cage = testing::cube();
  const auto error = [&](const CagePlace& place) {
    return error_of([&] { face_weights(cage, place); });
  };
  EXPECT_NE(error({6, -1, {0, 0}, 4}).find("no such face"), std::string::npos);
  EXPECT_NE(error({0, 4, {0, 0}, 4}).find("not so many corners"), std::string::npos);
  EXPECT_NE(error({0, -1, {0, 0}, 2}).find("not so many corners"), std::string::npos);
}

}  // namespace
}  // namespace surfmesh
