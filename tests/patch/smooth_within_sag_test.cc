// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch/smooth_within_sag.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/assembled.hh"
#include "support/domain_meshes.hh"
#include "support/models.hh"
#include "surfmesh/geometry/callable_surface.hh"
#include "surfmesh/patch/corner_triangles.hh"
#include "surfmesh/patch/sag_meter.hh"
#include "surfmesh/patch_mesh/patch_mesh.hh"
#include "surfmesh/patch_mesh/turned_triangles.hh"

namespace surfmesh::detail {
namespace {

/// A wave across, straight along, meshed without improvement.
class SmoothWithinSag : public ::testing::Test {
 protected:
  SmoothWithinSag() {
    const auto nodes = place_contour_nodes(model_, {&field_}).contours;
    PatchResult result = mesh_patch(
        {.surface = model_.surface(0),
         .field = field_,
         .boundary = collect_boundary(model_, 0, nodes, NodeNumbers(model_, nodes), field_),
         .improve = {.smoothing = Smoothing::Off, .repairs = 0}});
    patch_ = reopen_patch(std::move(result.mesh), model_.surface(0), field_);
  }

  double greatest_sag() const {
    const SagMeter meter(model_.surface(0), 0);
    double greatest = 0;
    for (const CornerTriangle& t : triangles()) greatest = std::max(greatest, meter.sag_of(t));
    return greatest;
  }

  double least_shape() const { return shape_of(triangles()); }

  CornerTriangles triangles() const {
    CornerTriangles result;
    for (const FaceHandle fh : testing::faces_of(*patch_.delaunay)) {
      const TriangleVertices v = vertices(patch_.delaunay->mesh(), fh);
      result.push_back({corner_of(patch_, v[0]), corner_of(patch_, v[1]), corner_of(patch_, v[2])});
    }
    return result;
  }

  Model model_ = testing::model_of({make_callable_surface({0, 6, 0, 3}, [](auto u, auto v) {
    return std::array{u, v, 0.5 * sin(2 * u)};
  })});
  testing::SpaceSizeField field_{model_.surface(0), 0.2};
  TriangulatedPatch patch_;
};

TEST_F(SmoothWithinSag, RaisesMeanAndLeastQuality) {
  const double mean = testing::mean_quality(*patch_.delaunay), least = least_shape();
  smooth_within_sag(patch_, 1);
  EXPECT_GT(testing::mean_quality(*patch_.delaunay), mean + 0.003);
  EXPECT_GT(least_shape(), std::max(0.5, least));
  EXPECT_EQ(find_turned_triangles(patch_).count, 0u);
}

TEST_F(SmoothWithinSag, BringsNoTriangleBeyondTheAim) {
  const double before = greatest_sag();
  smooth_within_sag(patch_, before);
  EXPECT_LE(greatest_sag(), before);
}

TEST_F(SmoothWithinSag, ChangesNothingWhereNothingIsNearEnough) {
  const std::vector<Uv> before = testing::positions(*patch_.delaunay);
  smooth_within_sag(patch_, 0);
  EXPECT_EQ(testing::positions(*patch_.delaunay), before);
}

TEST_F(SmoothWithinSag, EvaluatesWhatItMoves) {
  smooth_within_sag(patch_, 1);
  for (std::size_t v = 0; v < patch_.delaunay->n_vertices(); ++v) {
    const Uv uv = patch_.delaunay->uv(VertexHandle(static_cast<int>(v)));
    EXPECT_EQ(patch_.points[v], model_.surface(0).evaluate(uv, Order::Position).point);
  }
}

}  // namespace
}  // namespace surfmesh::detail
