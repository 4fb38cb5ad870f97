// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/improve/smooth_sweeps.hh"

#include <gtest/gtest.h>

#include "support/domain_meshes.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {
namespace {

using testing::FunctionField;
using testing::positions;

constexpr int kSweeps = 4;

std::unique_ptr<DelaunayMesh> refined_square(const FunctionField& field) {
  auto delaunay = testing::empty_square(field);
  refine(*delaunay, field);
  return delaunay;
}

/// Sweeps over all vertices, without any shortcut.
void smooth_all(DelaunayMesh& delaunay, const MetricField& field, Smoothing kind) {
  VertexMoves moves(delaunay, field);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < delaunay.n_vertices(); ++i) {
      moves.smooth(VertexHandle(static_cast<int>(i)), kind);
    }
  }
}

std::size_t smooth_sweeps(DelaunayMesh& delaunay, const MetricField& field, Smoothing kind) {
  VertexMoves moves(delaunay, field);
  return surfmesh::smooth_sweeps(delaunay, moves, kind, kSweeps);
}

TEST(SmoothSweeps, PassOverOnlyVerticesThatWouldStay) {
  for (const FunctionField& field :
       {testing::four_point_field(2), testing::shock_field(10, 0.02)}) {
    for (const Smoothing kind : {Smoothing::Best, Smoothing::Laplace, Smoothing::Element}) {
      const auto full = refined_square(field), quick = refined_square(field);
      smooth_all(*full, field, kind);
      smooth_sweeps(*quick, field, kind);
      EXPECT_EQ(positions(*quick), positions(*full));
    }
  }
}

TEST(SmoothSweeps, PassOverQuietVertices) {
  const auto field = testing::four_point_field(2);
  const auto delaunay = refined_square(field);
  EXPECT_LT(smooth_sweeps(*delaunay, field, Smoothing::Best), kSweeps * delaunay->n_vertices());
}

/// Smoothing by elements depends on more than the neighbours.
TEST(SmoothSweeps, LookAtAllVerticesWithElements) {
  const auto field = testing::four_point_field(2);
  const auto delaunay = refined_square(field);
  EXPECT_EQ(smooth_sweeps(*delaunay, field, Smoothing::Element), kSweeps * delaunay->n_vertices());
}

TEST(SmoothSweeps, LookAtEachVertexOnceWhereNoneMoves) {
  const auto field = testing::four_point_field();
  const auto delaunay = testing::empty_square(field);
  EXPECT_EQ(smooth_sweeps(*delaunay, field, Smoothing::Best), delaunay->n_vertices());
}

}  // namespace
}  // namespace surfmesh
