// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/smooth_quads.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "quad/grid_patch.hh"
#include "support/cancelling.hh"
#include "support/errors.hh"

namespace surfmesh {
namespace {

using testing::GridPatch;

/// Move the inner vertices of a grid at random, in each direction by up to so much.
void perturb(GridPatch& patch, double most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(-most, most);
  for (std::size_t v = patch.number.fixed(); v < patch.mesh.n_vertices(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    const double u = step(random);
    patch.put(vh, patch.uv(vh) + Uv{u, step(random)});
  }
}

/// The energy of the corners around a vertex.
double energy_at(const GridPatch& patch, VertexHandle vh, EnergyWeights weights) {
  std::vector<CornerTerms> star;
  EXPECT_TRUE(patch.geometry.collect(vh, star));
  double energy = 0;
  for (const CornerTerms& terms : star) energy += corner_energy(terms.at, weights);
  return energy;
}

/// The step at which the energy with the metrics held is least near 0, by descending over ever
/// finer lattices of steps: slow, but without derivatives.
ChartStep least_step(const GridPatch& patch, VertexHandle vh, EnergyWeights weights) {
  std::vector<CornerTerms> star;
  EXPECT_TRUE(patch.geometry.collect(vh, star));
  const auto energy = [&](ChartStep step) {
    double sum = 0;
    for (const CornerTerms& terms : star) sum += corner_energy(terms.after(step), weights);
    return sum;
  };
  ChartStep best;
  for (double size = 0.05; size > 1e-6;) {
    ChartStep next = best;
    for (const ChartStep d :
         {ChartStep{size, 0}, ChartStep{-size, 0}, ChartStep{0, size}, ChartStep{0, -size}}) {
      const ChartStep there{best.x + d.x, best.y + d.y};
      if (energy(there) < energy(next)) next = there;
    }
    if (next.x == best.x && next.y == best.y) size /= 2;
    best = next;
  }
  return best;
}

/// Newton steps with the right derivatives end where the energy is least, and square their distance
/// from there.
TEST(QuadSmoother, StepsToWhereTheEnergyIsLeast) {
  const Metric metric = testing::directed_metric({0.6, 0.8}, 1.2, 0.8);
  for (const EnergyWeights weights : {EnergyWeights{}, EnergyWeights{.size = 0.1},
                                      EnergyWeights{.size = 0.1, .is_steep = true}}) {
    GridPatch patch(3, 3, testing::constant_field(metric));
    perturb(patch, 0.1, 3);
    const VertexHandle vh = patch.vertex(1, 1);
    QuadSmoother smoother(patch.geometry);
    for (int i = 0; i < 20 && smoother.smooth(vh, weights) > 0; ++i) {
    }
    const ChartStep rest = least_step(patch, vh, weights);
    EXPECT_LT(std::hypot(rest.x, rest.y), 0.01);  // shorter steps are not worth their query
  }
}

TEST(QuadSmoother, ConvergesQuadratically) {
  GridPatch patch(3, 3);
  perturb(patch, 0.05, 7);
  const VertexHandle vh = patch.vertex(2, 1);
  patch.put(vh, patch.uv(vh) + Uv{0.1, -0.05});
  const ChartStep whole = least_step(patch, vh, {});
  const double before = std::hypot(whole.x, whole.y);
  QuadSmoother smoother(patch.geometry);
  ASSERT_GT(smoother.smooth(vh, {}), 0);
  const ChartStep rest = least_step(patch, vh, {});
  EXPECT_LT(std::hypot(rest.x, rest.y), 3 * before * before);
  EXPECT_GT(before, 0.05);
}

TEST(QuadSmoother, LowersTheEnergyOrStays) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    GridPatch patch(5, 5);
    perturb(patch, 0.9, seed);  // many quads are inverted
    QuadSmoother smoother(patch.geometry);
    for (std::size_t v = patch.number.fixed(); v < patch.mesh.n_vertices(); ++v) {
      const VertexHandle vh(static_cast<int>(v));
      const double before = energy_at(patch, vh, {});
      const Uv at = patch.uv(vh);
      const double length = smoother.smooth(vh, {});
      if (length == 0) {
        EXPECT_EQ(patch.uv(vh), at);
      } else {
        EXPECT_LT(energy_at(patch, vh, {}), before);
        EXPECT_NEAR(std::hypot(patch.uv(vh).u - at.u, patch.uv(vh).v - at.v), length, 1e-14);
        EXPECT_LE(length, 0.3 + 1e-14);
      }
    }
  }
}

TEST(QuadSmoother, StaysAtTheVertexOfALattice) {
  GridPatch patch(3, 3);
  EXPECT_EQ(QuadSmoother(patch.geometry).smooth(patch.vertex(1, 1), {}), 0);
  EXPECT_EQ(patch.geometry.queries().total(), 0u);
}

TEST(QuadSmoother, StaysWhereTheMetricIsSingular) {
  GridPatch patch(2, 2);
  patch.mesh.property(require(patch.mesh, keys::vertex_metric), patch.vertex(1, 1)) = {0, 0, 0};
  EXPECT_EQ(QuadSmoother(patch.geometry).smooth(patch.vertex(1, 1), {}), 0);
}

TEST(SmoothQuads, BringsAPerturbedLatticeBack) {
  for (const SmoothingAim aim : {SmoothingAim::Shape, SmoothingAim::BetterShape}) {
    GridPatch patch(8, 6);
    const std::vector<Uv> lattice = patch.positions();
    perturb(patch, 0.35, 11);
    smooth_quads(patch.mesh, patch.geometry, aim, 100, RunContext());
    for (std::size_t v = 0; v < lattice.size(); ++v) {
      const Uv at = patch.uv(VertexHandle(static_cast<int>(v)));
      EXPECT_LT(std::hypot(at.u - lattice[v].u, at.v - lattice[v].v), 0.06) << "vertex " << v;
    }
  }
}

TEST(SmoothQuads, UntanglesInvertedQuads) {
  GridPatch patch(6, 6);
  perturb(patch, 0.9, 5);
  EXPECT_LT(testing::least_jacobian(patch), 0);
  smooth_quads(patch.mesh, patch.geometry, SmoothingAim::BetterShape, 200, RunContext());
  EXPECT_GT(testing::least_jacobian(patch), 0.95);
}

TEST(SmoothQuads, LeavesTheBoundaryWhereItIs) {
  GridPatch patch(5, 4, testing::isotropic_field([](Uv p) { return 0.5 + 0.3 * p.u; }));
  const std::vector<Uv> before = patch.positions();
  smooth_quads(patch.mesh, patch.geometry, SmoothingAim::Shape, 10, RunContext());
  for (std::size_t v = 0; v < patch.number.fixed(); ++v) {
    EXPECT_EQ(patch.uv(VertexHandle(static_cast<int>(v))), before[v]);
  }
  EXPECT_NE(patch.positions(), before);
}

TEST(SmoothQuads, NeverLowersTheLeastJacobianOfAStarForTheWorstCorners) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    GridPatch patch(6, 6);
    perturb(patch, 0.6, seed);
    double least = testing::least_jacobian(patch);
    for (int sweep = 0; sweep < 10; ++sweep) {
      smooth_quads(patch.mesh, patch.geometry, SmoothingAim::WorstCorners, 1, RunContext());
      const double now = testing::least_jacobian(patch);
      EXPECT_GE(now, least);
      least = now;
    }
  }
}

TEST(SmoothQuads, MovesNothingForTheWorstCornersWhereAllAreGood) {
  GridPatch patch(6, 6);
  perturb(patch, 0.1, 2);
  ASSERT_GT(testing::least_jacobian(patch), 0.8);
  const std::vector<Uv> before = patch.positions();
  smooth_quads(patch.mesh, patch.geometry, SmoothingAim::WorstCorners, 10, RunContext());
  EXPECT_EQ(patch.positions(), before);
}

TEST(SmoothQuads, PassesOverWhatIsNotInUse) {
  GridPatch patch(3, 3);
  FaceCycles cycle;
  const std::vector<FaceHandle> old = {patch.face(0, 0), patch.face(1, 0), patch.face(1, 1),
                                       patch.face(0, 1)};
  const auto at = [&](int i, int j) { return patch.vertex(i, j); };
  cycle.add({at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1)});
  std::vector<FaceHandle> made;
  patch.editor.replace(old, cycle, made);
  ASSERT_FALSE(patch.editor.is_used(at(1, 1)));
  for (const SmoothingAim aim : {SmoothingAim::Shape, SmoothingAim::WorstCorners}) {
    smooth_quads(patch.mesh, patch.geometry, aim, 3, RunContext());
  }
  EXPECT_EQ(patch.uv(at(1, 1)), (Uv{1, 1}));
}

TEST(SmoothQuads, EndsOnceItIsCancelled) {
  GridPatch patch(3, 3);
  testing::Cancelling observer;
  const RunContext context(&observer);
  EXPECT_EQ(error_of([&] {
              for (int i = 0; i < 1000; ++i) {
                smooth_quads(patch.mesh, patch.geometry, SmoothingAim::Shape, 1, context);
              }
            }),
            testing::kCancelled);
}

}  // namespace
}  // namespace surfmesh
