// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/interpolating_cage.hh"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <random>

#include "cage/cages.hh"
#include "cage/meshes.hh"
#include "support/errors.hh"
#include "surfmesh/cage/limit_stencils.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/refine_cage.hh"
#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// The unit sphere as a mesh: an icosahedron, refined.
Cage sphere(int levels) {
  Cage cage = testing::icosahedron();
  for (int k = 0; k < levels; ++k) cage = refine_once(cage, Scheme::Loop).cage;
  for (Vec3& point : cage.points) point.normalize();
  return cage;
}

/// The points of a cage moved along the rays from the origin, by up to a share of themselves.
Cage with_noise(Cage cage, double share) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-share, share);
  for (Vec3& point : cage.points) point *= 1 + uniform(random);
  return cage;
}

/// Greatest distance between the corners of the limit surfaces of a cage and points of others.
double distance_at_corners(const Cage& cage, const std::vector<Vec3>& points) {
  const auto surfaces = make_limit_surfaces(cage, Scheme::Auto);
  double greatest = 0;
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    const Domain domain = surfaces[f]->domain();
    for (int k = 0; k < domain.corner_count(); ++k) {
      const Vec3 at = surfaces[f]->evaluate(domain.corner(k), Order::Position).point;
      const int vertex = cage.faces[f][static_cast<std::size_t>(k)];
      greatest = std::max(greatest, (at - points[static_cast<std::size_t>(vertex)]).norm());
    }
  }
  return greatest;
}

void expect_interpolation(const Cage& mesh) {
  const InterpolatingCage result = interpolating_cage(mesh);
  EXPECT_FALSE(result.is_least_squares);
  EXPECT_LT(result.distance, 1e-11 * diagonal(mesh));
  EXPECT_LT(result.iterations, 300);
  EXPECT_EQ(result.cage.faces, mesh.faces);
  EXPECT_LT(distance_at_corners(result.cage, mesh.points), 1e-5 * diagonal(mesh));
}

TEST(InterpolatingCage, PassesThroughTrianglesAndQuads) {
  expect_interpolation(sphere(2));
  expect_interpolation(testing::torus(12, 8));
  expect_interpolation(testing::halved_quads(testing::torus(12, 8)));
  expect_interpolation(testing::sheet(5, 4));
  expect_interpolation(testing::triangle_sheet(5, 4));
}

TEST(InterpolatingCage, PassesThroughCreasesAndCorners) {
  Cage mesh = testing::torus(12, 8);
  for (int i = 0; i < 12; ++i) mesh.creases.push_back({{i, (i + 1) % 12}, 10});
  for (int i = 24; i < 30; ++i) mesh.creases.push_back({{i, i + 1}, 1.5});
  mesh.corners = {{3, 10}, {40, 2}};
  expect_interpolation(mesh);
  mesh.creases.resize(12);
  expect_interpolation(testing::halved_quads(mesh));
}

TEST(InterpolatingCage, PassesThroughEdgesOfThreeFaces) { expect_interpolation(testing::fan()); }

/// Polygons are refined for their surfaces, so here the corners are looked for in the result.
TEST(InterpolatingCage, PassesThroughPolygons) {
  Cage mesh = testing::prism(7);
  const InterpolatingCage result = interpolating_cage(mesh);
  EXPECT_LT(result.distance, 1e-10);
  const RefinedCage refined = refine_once(result.cage, Scheme::CatmullClark);
  const auto surfaces = make_limit_surfaces(refined.cage, Scheme::CatmullClark);
  for (const Vec3& point : mesh.points) {
    double least = 1;
    for (const auto& surface : surfaces) {
      for (int k = 0; k < 4; ++k) {
        const Vec3 at = surface->evaluate(surface->domain().corner(k), Order::Position).point;
        least = std::min(least, (at - point).norm());
      }
    }
    EXPECT_LT(least, 1e-4);
  }
}

/// The points of a cage are found again from those of its limit surface.
TEST(InterpolatingCage, IsTheCageOfALimitSurface) {
  const Cage cage = testing::halved_quads(testing::torus(9, 7));
  Cage mesh = cage;
  const auto surfaces = make_limit_surfaces(cage, Scheme::Loop);
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      mesh.points[static_cast<std::size_t>(cage.faces[f][static_cast<std::size_t>(k)])] =
          surfaces[f]->evaluate(surfaces[f]->domain().corner(k), Order::Position).point;
    }
  }
  const InterpolatingCage result = interpolating_cage(mesh);
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    EXPECT_LT((result.cage.points[v] - cage.points[v]).norm(), 1e-4) << v;
  }
}

/// The limit surface of a cube's corners moved out by turns is the same, so none is the cage.
TEST(InterpolatingCage, TakesTheLeastMovesOfAPlainCube) {
  const InterpolatingCage result = interpolating_cage(testing::cube());
  EXPECT_LT(result.distance, 1e-10);
  // Moved alike: their size is what makes the surface larger.
  for (const Vec3& point : result.cage.points) {
    EXPECT_NEAR(point.cwiseAbs().minCoeff(), point.cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(InterpolatingCage, TellsTheDistanceThatRemains) {
  Cage mesh = testing::cube();
  mesh.points[7] *= 1.5;  // has a share in the mode that no surface has
  const InterpolatingCage result = interpolating_cage(mesh);
  EXPECT_TRUE(result.is_least_squares);
  EXPECT_FALSE(result.has_stopped);
  EXPECT_NEAR(result.distance, 0.5 * std::sqrt(3) / 8, 1e-9);
  EXPECT_NEAR(result.mean_distance, result.distance, 1e-9);
}

TEST(InterpolatingCage, TellsTheGreatestMove) {
  const Cage mesh = sphere(1);
  const InterpolatingCage result = interpolating_cage(mesh);
  double greatest = 0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    greatest = std::max(greatest, (result.cage.points[v] - mesh.points[v]).norm());
  }
  EXPECT_EQ(result.greatest_move, greatest);
  const auto moved = static_cast<std::size_t>(result.moved_vertex);
  EXPECT_EQ((result.cage.points[moved] - mesh.points[moved]).norm(), greatest);
  EXPECT_EQ(result.vertices, mesh.points.size());
}

TEST(InterpolatingCage, LeavesPointsWithoutFacesAlone) {
  Cage mesh = sphere(1);
  mesh.points.emplace_back(9, 9, 9);
  const InterpolatingCage result = interpolating_cage(mesh);
  EXPECT_EQ(result.cage.points.back(), Vec3(9, 9, 9));
  EXPECT_EQ(result.vertices + 1, mesh.points.size());
  const InterpolatingCage fitted = interpolating_cage(mesh, {.fit = Length::units(0.01)});
  EXPECT_LT((fitted.cage.points.back() - Vec3(9, 9, 9)).norm(), 1e-9);
  EXPECT_GT(fitted.distance, 0.005);
}

TEST(InterpolatingCage, StaysWithinTheFit) {
  const Cage mesh = with_noise(sphere(3), 0.01);
  for (const double fit : {0.001, 0.01, 0.02}) {
    const InterpolatingCage result = interpolating_cage(mesh, {.fit = Length::units(fit)});
    EXPECT_LE(result.distance, fit);
    EXPECT_GT(result.distance, 0.9 * fit);
    EXPECT_GT(result.fairness, 0);
    EXPECT_LT(distance_at_corners(result.cage, mesh.points), fit + 1e-4);
  }
}

/// Mean square distance of the limit surface at its vertices from the unit sphere.
double roughness(const Cage& cage) {
  double sum = 0;
  int count = 0;
  for (const auto& surface : make_limit_surfaces(cage, Scheme::Auto)) {
    const double radius = surface->evaluate({0, 0}, Order::Position).point.norm();
    sum += (radius - 1) * (radius - 1);
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(InterpolatingCage, LosesNoiseWithinTheFit) {
  const Cage mesh = with_noise(sphere(3), 0.01);
  const double noise = roughness(interpolating_cage(mesh).cage);
  EXPECT_LT(roughness(interpolating_cage(mesh, {.fit = Length::units(0.012)}).cage), noise / 2);
}

TEST(InterpolatingCage, KeepsCornersWithinTheFit) {
  Cage mesh = testing::triangle_sheet(6, 6);
  mesh.boundary = BoundaryRule::EdgeAndCorner;
  mesh.corners = {{0, 10}, {6, 10}, {42, 10}, {48, 10}};
  const InterpolatingCage result = interpolating_cage(mesh, {.fit = Length::units(0.05)});
  EXPECT_LE(result.distance, 0.05);
  // The surface reaches its cage there, as it does not at a border that is round.
  const std::vector<Vec3> limits = limit_points(result.cage, Scheme::Loop);
  for (const Cage::Corner& corner : mesh.corners) {
    const auto v = static_cast<std::size_t>(corner.vertex);
    EXPECT_LT((limits[v] - result.cage.points[v]).norm(), 1e-12) << v;
    EXPECT_LE((limits[v] - mesh.points[v]).norm(), 0.05) << v;
  }
  mesh.corners.clear();
  mesh.boundary = BoundaryRule::EdgeOnly;
  const Cage round = interpolating_cage(mesh, {.fit = Length::units(0.05)}).cage;
  EXPECT_GT((limit_points(round, Scheme::Loop)[0] - round.points[0]).norm(), 0.05);
}

TEST(InterpolatingCage, NamesTheFarthestVertex) {
  const Cage mesh = with_noise(sphere(2), 0.02);
  const InterpolatingCage result = interpolating_cage(mesh, {.fit = Length::units(0.01)});
  const std::vector<Vec3> limits = limit_points(result.cage, Scheme::Loop);
  const auto farthest = static_cast<std::size_t>(result.farthest_vertex);
  EXPECT_NEAR((limits[farthest] - mesh.points[farthest]).norm(), result.distance, 1e-12);
}

/// A fit that no weight reaches is found out after two of them.
TEST(InterpolatingCage, PassesThroughThePointsWhereNoWeightReachesTheFit) {
  const Cage mesh = with_noise(sphere(3), 0.01);
  const InterpolatingCage through = interpolating_cage(mesh);
  const InterpolatingCage result = interpolating_cage(mesh, {.fit = Length::units(1e-12)});
  EXPECT_EQ(result.fairness, 0);
  EXPECT_LT(result.distance, 1e-12);
  EXPECT_EQ(result.cage.points, through.cage.points);
  EXPECT_LT(result.iterations, 20 * through.iterations);
}

TEST(InterpolatingCage, TakesMeshesOfAnyTraits) {
  struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3f;
  };
  OpenMesh::TriMesh_ArrayKernelT<Traits> mesh;
  const Cage cage = sphere(1);
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Vec3& p : cage.points) {
    vertices.push_back(mesh.add_vertex(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())}));
  }
  for (const std::vector<int>& f : cage.faces) {
    mesh.add_face(vertices[static_cast<std::size_t>(f[0])],
                  vertices[static_cast<std::size_t>(f[1])],
                  vertices[static_cast<std::size_t>(f[2])]);
  }
  const InterpolatingCage result = interpolating_cage(mesh);
  EXPECT_LT(result.distance, 1e-11);
  EXPECT_NEAR(result.greatest_move, interpolating_cage(cage).greatest_move, 1e-6);
}

TEST(InterpolatingCage, RefusesAFitThatIsNone) {
  EXPECT_THROW(interpolating_cage(sphere(0), {.fit = Length::units(-1)}), Error);
  EXPECT_THROW(interpolating_cage(sphere(0), {.fit = Length::share(2)}), Error);
  EXPECT_THROW(interpolating_cage(Cage()), Error);
}

TEST(InterpolatingCage, PassesVerticesBy) {
  const Cage mesh = testing::sphere_mesh(2);
  const InterpolatingCage found = interpolating_cage(mesh, {.passed_by = {5, 17}});
  EXPECT_FALSE(found.is_least_squares);
  const std::vector<Vec3> limits = limit_points(found.cage, Scheme::Loop);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double distance = (limits[v] - mesh.points[v]).norm();
    if (v == 5 || v == 17) {
      EXPECT_EQ(found.cage.points[v], mesh.points[v]);
      EXPECT_GT(distance, 1e-3);
      EXPECT_LE(distance, found.distance * (1 + 1e-12));
    } else {
      EXPECT_LT(distance, 1e-11);
    }
  }
}

TEST(InterpolatingCage, RefusesToPassByWhatIsNotThere) {
  const Cage mesh = testing::sphere_mesh(1);
  EXPECT_EQ(error_of([&] { interpolating_cage(mesh, {.passed_by = {1000}}); }),
            "invalid input: vertex 1000 to pass by does not exist: there are 42");
}

}  // namespace
}  // namespace surfmesh
