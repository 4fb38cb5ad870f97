// SPDX-License-Identifier: BSD-3-Clause
// Limit surfaces beside those of OpenSubdiv's Far, which shares no evaluation with Bfr.
#include <gtest/gtest.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include <cmath>
#include <memory>
#include <random>

#include "cage/cages.hh"
#include "surfmesh/cage/face_evaluator.hh"
#include "surfmesh/cage/limit_surface.hh"
#include "surfmesh/cage/primvar.hh"
#include "surfmesh/cage/subdivision.hh"

namespace surfmesh {
namespace {

namespace Bfr = OpenSubdiv::Bfr;
namespace Far = OpenSubdiv::Far;

constexpr int kLevel = 8;

/// Points of the unit square or triangle: corners, sides and inside.
std::vector<Uv> lattice_points(const Domain& domain) {
  std::vector<Uv> result;
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const Uv uv{i / 8.0, j / 8.0};
      if (domain.shape == Domain::Shape::Rectangle || i + j <= 8) result.push_back(uv);
    }
  }
  return result;
}

/// Points of all faces by Far's limit stencils, those of a face after each other.
std::vector<Vec3> far_points(const Cage& cage, const std::vector<Uv>& at) {
  const CageTopology topology = make_topology(cage, resolve_scheme(cage, Scheme::Auto));
  Far::TopologyRefiner::AdaptiveOptions options(kLevel);
  options.useInfSharpPatch = true;  // sharp edges are exact, not near to it
  topology.refiner->RefineAdaptive(options);
  std::vector<double> u, v;
  for (const Uv uv : at) {
    u.push_back(uv.u);
    v.push_back(uv.v);
  }
  using Factory = Far::LimitStencilTableFactoryReal<double>;
  Factory::LocationArrayVec locations(cage.faces.size());
  for (std::size_t f = 0; f < locations.size(); ++f) {
    locations[f].ptexIdx = static_cast<int>(f);
    locations[f].numLocations = static_cast<int>(at.size());
    locations[f].s = u.data();
    locations[f].t = v.data();
  }
  const std::unique_ptr<const Far::LimitStencilTableReal<double>> stencils(
      Factory::Create(*topology.refiner, locations));
  std::vector<Primvar> points, result(at.size() * cage.faces.size());
  for (const Vec3& point : cage.points) points.push_back({point});
  stencils->UpdateValues(points.data(), result.data());
  std::vector<Vec3> positions;
  for (const Primvar& primvar : result) positions.push_back(primvar.point);
  return positions;
}

/// Far isolates corners of the boundary in another way, which makes a difference at level 8.
constexpr double kFarLevelError = 1e-5;

void expect_far_limit(const Cage& cage) {
  const auto surfaces = make_limit_surfaces(cage, Scheme::Auto, kLevel);
  const std::vector<Uv> at = lattice_points(surfaces[0]->domain());
  const std::vector<Vec3> wanted = far_points(cage, at);
  ASSERT_EQ(wanted.size(), surfaces.size() * at.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Uv uv = at[i % at.size()];
    const Vec3 point = surfaces[i / at.size()]->evaluate(uv, Order::Position).point;
    EXPECT_LT((point - wanted[i]).norm(), kFarLevelError)
        << "face " << i / at.size() << " at " << uv.u << " " << uv.v;
  }
}

Cage moved_at_random(Cage cage, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  for (Vec3& point : cage.points) {
    point += Vec3(uniform(random), uniform(random), uniform(random));
  }
  return cage;
}

/// Two quads that share two edges.
Cage two_quads() {
  Cage cage;
  cage.points = {{0, 0, 2}, {0, 0, 0}, {2, 0, 0}, {0.5, 0, 0.7}, {2, 0, 2}};
  cage.faces = {{0, 1, 2, 3}, {3, 2, 4, 0}};
  return cage;
}

/// Three quads between the same two vertices: a closed surface with three vertices of two faces.
Cage three_slices() {
  Cage cage;
  cage.points = {{0, 0, 1}, {1, 0, 0.2}, {0.3, 0, -1}, {-0.5, 0.8, -0.3}, {-0.5, -0.8, 0.4}};
  cage.faces = {{0, 1, 2, 3}, {0, 3, 2, 4}, {0, 4, 2, 1}};
  return cage;
}

/// Faces with two vertices of two faces, between the same two vertices at a boundary.
Cage slices_in_a_sheet() {
  Cage cage;
  cage.points = {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}, {0.7, 0.3, 0.7}, {1.3, -0.4, 1.2}};
  cage.faces = {{0, 1, 2, 4}, {0, 4, 2, 5}, {0, 5, 2, 3}};
  return cage;
}

/// Two triangles back to back within others, for Loop's scheme.
Cage triangles_back_to_back() {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0.2}, {0.3, 1, 0}, {0.4, 0.3, 1}};
  cage.faces = {{0, 1, 2}, {2, 1, 3}, {3, 1, 0}, {0, 2, 3}};
  cage.points.emplace_back(0.5, 0.2, -0.7);
  cage.faces[0] = {0, 1, 4};
  cage.faces.push_back({0, 4, 1});
  return cage;
}

TEST(FarLimit, IsThatAtInnerVerticesOfTwoFaces) {
  for (const Cage& cage : {two_quads(), three_slices(), slices_in_a_sheet(), testing::pillow(),
                           triangles_back_to_back()}) {
    expect_far_limit(cage);
    for (unsigned seed = 1; seed <= 3; ++seed) expect_far_limit(moved_at_random(cage, seed));
  }
}

/// Triangles around a vertex.
Cage triangle_fan(int n) {
  Cage cage;
  cage.points = {{0, 0, 1}};
  for (int i = 0; i < n; ++i) {
    cage.points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0.1 * (i % 3));
    cage.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return cage;
}

TEST(FarLimit, IsThatAtTaggedInnerVerticesOfTwoFaces) {
  for (const double sharpness : {0.6, 1.5, 10.0}) {
    Cage cage = two_quads();
    cage.creases = {{{2, 3}, sharpness}};
    expect_far_limit(cage);
    cage.creases.push_back({{0, 3}, sharpness});
    expect_far_limit(cage);
    cage = two_quads();
    cage.corners = {{3, sharpness}};
    expect_far_limit(cage);
    cage = three_slices();
    cage.creases = {{{0, 1}, sharpness}, {{1, 2}, sharpness}};
    expect_far_limit(cage);
  }
}

TEST(FarLimit, IsThatAtVerticesOfManyFaces) {
  expect_far_limit(moved_at_random(testing::quad_fan(40), 1));
  expect_far_limit(moved_at_random(triangle_fan(40), 1));
}

TEST(SharedEvaluators, AgreeWithBfrInAllDerivatives) {
  for (const Cage& cage : {testing::quad_fan(9), triangle_fan(9)}) {
    const CageTopology topology = make_topology(cage, resolve_scheme(cage, Scheme::Auto));
    std::vector<int> faces;
    for (std::size_t f = 0; f < cage.faces.size(); ++f) faces.push_back(static_cast<int>(f));
    const auto shared = make_shared_evaluators(*topology.refiner, cage.points, faces, kLevel);
    Bfr::SurfaceFactory::Options options;
    options.SetApproxLevelSmooth(kLevel);
    options.SetApproxLevelSharp(kLevel);
    const Bfr::RefinerSurfaceFactory<> factory(*topology.refiner, options);
    for (const int f : faces) {
      Bfr::Surface<double> surface;
      factory.InitVertexSurface(f, &surface);
      const auto alone = make_bfr_evaluator(surface, cage.points);
      for (const Uv uv : {Uv{0.3, 0.1}, Uv{0.06, 0.04}, Uv{0.2, 0.7}}) {
        const Jet a = shared[static_cast<std::size_t>(f)]->evaluate(uv, Order::Second);
        const Jet b = alone->evaluate(uv, Order::Second);
        EXPECT_LT((a.point - b.point).norm(), 1e-13);
        EXPECT_LT((a.du - b.du).norm() + (a.dv - b.dv).norm(), 1e-11);
        const auto difference = [&](double sign) {
          return (a.duu - sign * b.duu).norm() + (a.duv - sign * b.duv).norm() +
                 (a.dvv - sign * b.dvv).norm();
        };
        // Bfr gives all second derivatives with the other sign where a part of a triangle is
        // turned.
        const bool is_loop = cage.faces[0].size() == 3;
        EXPECT_LT(is_loop ? std::min(difference(1), difference(-1)) : difference(1), 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace surfmesh
