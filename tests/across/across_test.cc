// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/across.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "support/assembled.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"
#include "surfmesh/across/dissolved_contours.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/topology.hh"
#include "surfmesh/quality/corners_beyond.hh"
#include "surfmesh/quality/statistics.hh"

/// Improvement of assembled triangles across contours, stage by stage.
namespace surfmesh {
namespace {

using std::numbers::pi;

/// A cylinder of radius 1 and height 1 as strips of different widths.
Model strips() {
  std::vector<testing::Shape> shapes;
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{
           {0, 0.3}, {0.3, 2}, {2, 2.2}, {2.2, 4}, {4, 2 * pi}}) {
    shapes.push_back(testing::cylinder(from, to));
  }
  return testing::model_of(shapes);
}

/// The triangles of a model before and after.
struct Improved {
  PolyMesh before, after;
  AcrossReport report;
};

Improved improve(const Model& model, double size) {
  Improved improved;
  testing::Assembled assembled = testing::assemble_with_size(model, size);
  improved.before = assembled.mesh;
  improved.after = assembled.mesh;
  const testing::UniformSizes sizes(model, size);
  improved.report = improve_across(improved.after, model, sizes);
  return improved;
}

/// Expect that corners on their patch lie where its surface has them, that others are told, and
/// that each vertex lies on the surface.
void expect_on_surface(const PolyMesh& mesh, const Model& model) {
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto patch_of = require(mesh, keys::face_patch);
  const detail::CornersBeyond is_beyond(mesh);
  double greatest = 0;
  std::size_t nowhere = 0;
  for (const VertexHandle vh : mesh.vertices()) {
    for (const HalfedgeHandle corner : mesh.vih_range(vh)) {
      if (mesh.is_boundary(corner) || is_beyond(corner)) continue;
      const Surface& surface = model.surface(mesh.property(patch_of, mesh.face_handle(corner)));
      const Uv uv = mesh.property(uv_of, corner);
      EXPECT_EQ(surface.domain().clamp(uv), uv);
      greatest =
          std::max(greatest,
                   (surface.evaluate(uv, Order::Position).point - to_eigen(mesh.point(vh))).norm());
    }
    if (!is_beyond.corner_on_patch(vh).is_valid()) ++nowhere;
  }
  EXPECT_LT(greatest, 1e-12);
  EXPECT_LT(nowhere, mesh.n_vertices() / 20);
}

std::size_t count_edges_on(const PolyMesh& mesh, const std::vector<char>& contours) {
  const auto contour_of = require(mesh, keys::edge_contour);
  std::size_t count = 0;
  for (const EdgeHandle eh : mesh.edges()) {
    const int contour = mesh.property(contour_of, eh);
    if (contour >= 0 && contours[static_cast<std::size_t>(contour)] != 0) ++count;
  }
  return count;
}

TEST(ImproveAcross, MakesTrianglesBetterAndKeepsTheTopology) {
  const Model model = strips();
  const Improved improved = improve(model, 0.1);
  testing::expect_valid(improved.after);
  const MeshTopology before = measure_topology(improved.before);
  const MeshTopology after = measure_topology(improved.after);
  EXPECT_EQ(after.euler, before.euler);
  EXPECT_EQ(after.boundary_edges, before.boundary_edges);
  EXPECT_EQ(after.components, before.components);
  EXPECT_GT(improved.report.faces, improved.before.n_faces() / 4);
  EXPECT_GE(measure_edges(improved.after).unit_fraction, 0.999);
  EXPECT_LT(measure_edges(improved.after).stddev, measure_edges(improved.before).stddev);
  EXPECT_GT(measure_quality(improved.after).mean, measure_quality(improved.before).mean);
  EXPECT_GE(measure_quality(improved.after).min, 0.75);
}

TEST(ImproveAcross, LeavesVerticesOnTheSurface) {
  const Model model = strips();
  const Improved improved = improve(model, 0.1);
  expect_on_surface(improved.after, model);
  for (const VertexHandle vh : improved.after.vertices()) {
    const Vec3 point = to_eigen(improved.after.point(vh));
    EXPECT_NEAR(point.head<2>().norm(), 1, 1e-12);
  }
}

TEST(ImproveAcross, SeesFacesOnSeveralPatchesAsTheyAreInSpace) {
  const Model model = strips();
  const Improved improved = improve(model, 0.1);
  const PolyMesh& mesh = improved.after;
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto metric_of = require(mesh, keys::corner_metric);
  const detail::CornersBeyond is_beyond(mesh);
  std::size_t beyond = 0;
  for (const FaceHandle fh : mesh.faces()) {
    if (!is_beyond.any_of(fh)) continue;
    ++beyond;
    for (const HalfedgeHandle tip : mesh.fh_range(fh)) {
      const HalfedgeHandle tail = mesh.prev_halfedge_handle(tip);
      const Uv step = mesh.property(uv_of, tip) - mesh.property(uv_of, tail);
      const double length = std::sqrt(squared_length(mesh.property(metric_of, tip), step));
      EXPECT_NEAR(0.1 * length, mesh.calc_edge_length(tip), 1e-9) << "the size is 0.1";
    }
  }
  EXPECT_GT(beyond, mesh.n_faces() / 20);
}

TEST(ImproveAcross, MarksNoEdgeOfDissolvedContours) {
  const Model model = strips();
  const Improved improved = improve(model, 0.1);
  const std::vector<char> is_dissolved = dissolved_contours(model);
  EXPECT_GT(count_edges_on(improved.before, is_dissolved), 0u);
  EXPECT_EQ(count_edges_on(improved.after, is_dissolved), 0u);
  std::vector<char> others;
  for (const char flag : is_dissolved) others.push_back(flag == 0);
  EXPECT_EQ(count_edges_on(improved.after, others), count_edges_on(improved.before, others));
}

TEST(ImproveAcross, HoldsContoursBetweenGroups) {
  Model model = strips();
  model.groups = {{"left", {0, 1, 2}}, {"right", {3, 4}}};
  const Improved improved = improve(model, 0.1);
  testing::expect_valid(improved.after);
  std::vector<char> between(model.contours.size(), 0);
  for (std::size_t c = 0; c < between.size(); ++c) {
    const auto& uses = model.contours[c].uses;
    between[c] = uses.size() == 2 && (uses[0].patch < 3) != (uses[1].patch < 3);
  }
  EXPECT_GT(count_edges_on(improved.after, between), 0u);
  EXPECT_EQ(count_edges_on(improved.after, between), count_edges_on(improved.before, between));
}

TEST(ImproveAcross, DoesNothingWhereNoContourIsDissolved) {
  const Model model = testing::model_of({testing::cylinder(0, 1)});
  const Improved improved = improve(model, 0.1);
  EXPECT_EQ(improved.report.faces, 0u);
  ASSERT_EQ(improved.after.n_vertices(), improved.before.n_vertices());
  for (const VertexHandle vh : improved.after.vertices()) {
    EXPECT_EQ(improved.after.point(vh), improved.before.point(vh));
  }
}

TEST(ImproveAcross, GoesThroughTheSeamsOfAPatch) {
  for (const Model& model : {testing::model_of({testing::whole_torus()}),
                             testing::model_of({testing::cylinder(0, 2 * pi)})}) {
    const Improved improved = improve(model, 0.15);
    testing::expect_valid(improved.after);
    EXPECT_EQ(measure_topology(improved.after).euler, measure_topology(improved.before).euler);
    EXPECT_GE(measure_quality(improved.after).min, 0.5);
    EXPECT_GE(measure_edges(improved.after).unit_fraction,
              measure_edges(improved.before).unit_fraction);
    expect_on_surface(improved.after, model);
  }
}

TEST(ImproveAcross, LeavesPolesAsTheyAre) {
  const Model model = testing::model_of({testing::sphere()});
  const Improved improved = improve(model, 0.2);
  testing::expect_valid(improved.after);
  EXPECT_EQ(measure_topology(improved.after).euler, 2);
  for (const double z : {-1.0, 1.0}) {
    const auto is_pole = [&](VertexHandle vh) {
      return (to_eigen(improved.after.point(vh)) - Vec3(0, 0, z)).norm() < 1e-12;
    };
    EXPECT_EQ(
        std::count_if(improved.after.vertices_begin(), improved.after.vertices_end(), is_pole), 1);
  }
  for (const VertexHandle vh : improved.after.vertices()) {
    EXPECT_NEAR(to_eigen(improved.after.point(vh)).norm(), 1, 1e-12);
  }
}

TEST(ImproveAcross, GoesOverPatchesThatAreTurned) {
  // The second square is seen from below.
  const auto turned = std::make_shared<test::PlanePatch>(Vec3(1, 1, 0), Vec3(0.1, 0, 0),
                                                         Vec3(0, -0.1, 0), Domain{0, 10, 0, 10});
  const Model model = testing::model_of({testing::rectangle(0, 0, 1, 1), turned});
  const Improved improved = improve(model, 0.07);
  testing::expect_valid(improved.after);
  expect_on_surface(improved.after, model);
  EXPECT_GE(measure_quality(improved.after).min, 0.6);
  double area = 0;
  for (const FaceHandle fh : improved.after.faces()) {
    EXPECT_GT(improved.after.calc_face_normal(fh)[2], 0);
    area += improved.after.calc_sector_area(improved.after.halfedge_handle(fh));
  }
  EXPECT_NEAR(area, 2, 1e-12);
}

/// More triangles than one piece holds, so that there are bands along the edges between pieces.
TEST(ImproveAcross, IsTheSameOnAnyNumberOfThreadsInSeveralPieces) {
  std::vector<testing::Shape> shapes;
  for (int i = 0; i < 32; ++i) {
    shapes.push_back(testing::cylinder(i * pi / 16, (i + 1) * pi / 16));
  }
  const Model model = testing::model_of(shapes);
  PolyMesh first;
  for (const int threads : {1, 2, 3}) {
    Improved improved;
    with_threads(threads, [&] { improved = improve(model, 0.02); });
    ASSERT_GT(improved.report.faces, 16384u);
    testing::expect_valid(improved.after);
    EXPECT_GE(measure_quality(improved.after).min, 0.6);
    if (threads == 1) {
      expect_on_surface(improved.after, model);
      first = improved.after;
      continue;
    }
    ASSERT_EQ(improved.after.n_vertices(), first.n_vertices());
    for (const VertexHandle vh : first.vertices()) {
      ASSERT_EQ(improved.after.point(vh), first.point(vh));
    }
    const MeshArrays now = mesh_arrays(improved.after), before = mesh_arrays(first);
    EXPECT_EQ(now.faces, before.faces);
    EXPECT_EQ(now.patches, before.patches);
    EXPECT_EQ(now.contours, before.contours);
    EXPECT_EQ(now.uvs, before.uvs);
    EXPECT_EQ(now.beyond, before.beyond);
  }
}

TEST(ImproveAcross, LeavesTipsAsTheyAre) {
  std::vector<testing::Shape> parts;
  for (int i = 0; i < 4; ++i) {
    parts.push_back(std::make_shared<test::Cone>(1, Domain{i * pi / 2, (i + 1) * pi / 2, 0, 1}));
  }
  const Model model = testing::model_of(parts);
  const Improved improved = improve(model, 0.1);
  testing::expect_valid(improved.after);
  EXPECT_EQ(measure_topology(improved.after).euler, measure_topology(improved.before).euler);
  const auto at_tip = [](const PolyMesh& mesh) {
    return std::count_if(mesh.vertices_begin(), mesh.vertices_end(),
                         [&](VertexHandle vh) { return mesh.point(vh).norm() < 1e-9; });
  };
  EXPECT_EQ(at_tip(improved.after), at_tip(improved.before));
}

TEST(ImproveAcross, PutsFacesInTheOrderOfTheirPatches) {
  const Improved improved = improve(strips(), 0.1);
  const auto patch_of = require(improved.after, keys::face_patch);
  int before = 0;
  std::set<int> patches;
  for (const FaceHandle fh : improved.after.faces()) {
    const int patch = improved.after.property(patch_of, fh);
    EXPECT_LE(before, patch);
    before = patch;
    patches.insert(patch);
  }
  EXPECT_EQ(patches.size(), 5u);
}

}  // namespace
}  // namespace surfmesh
