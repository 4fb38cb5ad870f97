// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/make_quads.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/cancelling.hh"
#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"
#include "surfmesh/quad/patch_geometry.hh"

namespace surfmesh {
namespace {

using std::numbers::pi;
using testing::circle;
using testing::FunctionField;
using testing::kUnitSquare;
using testing::with_nodes;

using Loops = std::vector<std::vector<Uv>>;

PatchQuads quads_of(const Loops& loops, const MetricField& field,
                    const RunContext& context = RunContext()) {
  std::vector<std::size_t> sizes;
  for (const auto& loop : loops) sizes.push_back(loop.size());
  return make_quads(triangulate_boundary(loops, field).delaunay, field, sizes, context);
}

/// What counts of a mesh of quads.
struct Figures {
  double least = 1, mean = 0;  ///< scaled Jacobian
  double unit_fraction = 0;    ///< of edges
  std::size_t triangles = 0;
};

double length_of(const PolyMesh& mesh, EdgeHandle eh) {
  const auto uv = require(mesh, keys::vertex_uv);
  const auto metric = require(mesh, keys::vertex_metric);
  const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
  const VertexHandle a = mesh.from_vertex_handle(heh), b = mesh.to_vertex_handle(heh);
  const Uv step = mesh.property(uv, b) - mesh.property(uv, a);
  return edge_length(std::sqrt(squared_length(mesh.property(metric, a), step)),
                     std::sqrt(squared_length(mesh.property(metric, b), step)));
}

Figures figures_of(PolyMesh& mesh, const MetricField& field) {
  Figures figures;
  const PatchGeometry geometry(mesh, field, 0);
  double sum = 0, units = 0;
  for (const FaceHandle fh : mesh.faces()) {
    if (mesh.valence(fh) != 4) ++figures.triangles;
    const double jacobian = geometry.measure(fh).least_jacobian;
    figures.least = std::min(figures.least, jacobian);
    sum += jacobian;
  }
  for (const EdgeHandle eh : mesh.edges()) {
    const double length = length_of(mesh, eh);
    units += length * length >= 0.5 && length * length <= 2 ? 1 : 0;
  }
  figures.mean = sum / static_cast<double>(mesh.n_faces());
  figures.unit_fraction = units / static_cast<double>(mesh.n_edges());
  return figures;
}

/// A domain with a metric, and what its mesh must reach.
struct QuadCase {
  const char* name;
  std::function<Loops(const FunctionField&)> loops;
  FunctionField field;
  double unit_fraction, mean, least;
};

void PrintTo(const QuadCase& example, std::ostream* out) { *out << example.name; }

/// Loops with an even number of nodes: a node more halves the last side of the first loop.
Loops with_even_nodes(const std::vector<std::vector<Uv>>& polygons, const FunctionField& field) {
  Loops loops;
  std::size_t count = 0;
  for (const auto& polygon : polygons) {
    loops.push_back(with_nodes(polygon, field));
    count += loops.back().size();
  }
  if (count % 2 == 1) loops[0].push_back(0.5 * (loops[0].back() + loops[0].front()));
  return loops;
}

std::vector<QuadCase> quad_cases() {
  const auto polygons = [](const std::vector<std::vector<Uv>>& sides) {
    return [sides](const FunctionField& field) { return with_even_nodes(sides, field); };
  };
  const auto rounds = [](const Loops& loops) {
    return [loops](const FunctionField&) { return loops; };
  };
  const std::vector<Uv> sheared = {{0, 0},
                                   {1, 0},
                                   {1 + std::cos(pi / 6), std::sin(pi / 6)},
                                   {std::cos(pi / 6), std::sin(pi / 6)}};
  const std::vector<Uv> hole = {{0.3, 0.3}, {0.3, 0.5}, {0.5, 0.5}, {0.5, 0.3}};
  const std::vector<Uv> other_hole = {{0.65, 0.6}, {0.65, 0.8}, {0.8, 0.8}, {0.8, 0.6}};
  return {
      {"Square", polygons({kUnitSquare}), testing::isotropic_field(0.05), 0.999, 0.999, 0.99},
      {"Disc", rounds({circle({0, 0}, 1, 62)}), testing::isotropic_field(0.1), 0.9, 0.93, 0.65},
      {"Ring", rounds({circle({0, 0}, 1, 62), circle({0, 0}, 0.4, -24)}),
       testing::isotropic_field(0.1), 0.92, 0.93, 0.65},
      {"SquareWithHoles", polygons({kUnitSquare, hole, other_hole}), testing::isotropic_field(0.04),
       0.9, 0.9, 0.3},
      {"ShearedCorners", polygons({sheared}), testing::isotropic_field(0.06), 0.9, 0.87, 0.15},
      {"Aspect100", polygons({kUnitSquare}), FunctionField([](Uv p) {
         return testing::directed_metric({1, 0}, 0.2 + 0.2 * p.v, 0.002 + 0.002 * p.v);
       }),
       0.9, 0.9, 0.5},
      {"Aspect5Across", polygons({kUnitSquare}),
       testing::constant_field(testing::directed_metric({std::cos(0.5), std::sin(0.5)}, 0.1, 0.02)),
       0.8, 0.8, 0.1},
      {"Shock", polygons({kUnitSquare}), testing::shock_field(20), 0.96, 0.95, 0.65},
      {"RingLayer", polygons({kUnitSquare}), testing::ring_field(0.004), 0.96, 0.9, 0.6},
      {"FourPoints", polygons({kUnitSquare}), testing::four_point_field(), 0.98, 0.97, 0.65},
  };
}

class MakeQuads : public ::testing::TestWithParam<QuadCase> {
 protected:
  MakeQuads() : loops_(GetParam().loops(GetParam().field)) {
    for (const auto& loop : loops_) boundary_.insert(boundary_.end(), loop.begin(), loop.end());
  }

  Loops loops_;
  std::vector<Uv> boundary_;
};

TEST_P(MakeQuads, FillsTheDomainWithGoodQuads) {
  const QuadCase& example = GetParam();
  const PatchQuads quads = quads_of(loops_, example.field);
  testing::expect_valid(*quads.mesh);
  const Figures figures = figures_of(*quads.mesh, example.field);
  EXPECT_EQ(figures.triangles, 0u);
  EXPECT_EQ(quads.report.triangles, 0u);
  EXPECT_FALSE(quads.report.is_given_up);
  EXPECT_GE(figures.unit_fraction, example.unit_fraction);
  EXPECT_GE(figures.mean, example.mean);
  EXPECT_GE(figures.least, example.least);
}

TEST_P(MakeQuads, KeepsTopologyAndBoundary) {
  const PatchQuads quads = quads_of(loops_, GetParam().field);
  const MeshTopology topology = measure_topology(*quads.mesh);
  EXPECT_EQ(topology.euler, 2 - static_cast<long>(loops_.size()));
  EXPECT_EQ(topology.boundary_edges, boundary_.size());
  EXPECT_EQ(topology.split_vertices, 0u);
  const auto uv = require(*quads.mesh, keys::vertex_uv);
  for (std::size_t v = 0; v < boundary_.size(); ++v) {
    const VertexHandle vh(static_cast<int>(v));
    EXPECT_EQ(quads.mesh->property(uv, vh), boundary_[v]);
    EXPECT_TRUE(quads.mesh->is_boundary(vh));
  }
}

TEST_P(MakeQuads, CoversTheAreaOfTheDomain) {
  const PatchQuads quads = quads_of(loops_, GetParam().field);
  const auto uv = require(*quads.mesh, keys::vertex_uv);
  double area = 0, domain = 0;
  for (const FaceHandle fh : quads.mesh->faces()) {
    std::vector<Uv> polygon;
    for (const VertexHandle vh : quads.mesh->fv_range(fh)) {
      polygon.push_back(quads.mesh->property(uv, vh));
    }
    area += testing::polygon_area(polygon);
    EXPECT_GT(testing::polygon_area(polygon), 0);
  }
  for (const auto& loop : loops_) domain += testing::polygon_area(loop);
  EXPECT_NEAR(area, domain, 1e-10);
}

TEST_P(MakeQuads, HasTheMetricOfTheFieldAtEveryVertex) {
  const PatchQuads quads = quads_of(loops_, GetParam().field);
  const auto uv = require(*quads.mesh, keys::vertex_uv);
  const auto metric = require(*quads.mesh, keys::vertex_metric);
  for (const VertexHandle vh : quads.mesh->vertices()) {
    EXPECT_EQ(quads.mesh->property(metric, vh), GetParam().field(quads.mesh->property(uv, vh)));
  }
}

INSTANTIATE_TEST_SUITE_P(Domains, MakeQuads, ::testing::ValuesIn(quad_cases()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(MakeQuads, MakesNothingButTheLatticeOfASquare) {
  const auto field = testing::isotropic_field(0.1);
  const PatchQuads quads = quads_of({with_nodes(kUnitSquare, field)}, field);
  EXPECT_EQ(quads.mesh->n_faces(), 100u);
  EXPECT_EQ(quads.report.changed, 0u);
  EXPECT_GT(figures_of(*quads.mesh, field).least, 0.999);
}

TEST(MakeQuads, LeavesOneTriangleWhereTheBoundaryIsOdd) {
  const auto field = testing::isotropic_field(0.1);
  const PatchQuads quads = quads_of({circle({0, 0}, 1, 63)}, field);
  EXPECT_EQ(quads.report.triangles, 1u);
  EXPECT_EQ(figures_of(*quads.mesh, field).triangles, 1u);
  testing::expect_valid(*quads.mesh);
}

TEST(MakeQuads, MakesOneQuadOfFourNodes) {
  const PatchQuads quads = quads_of({kUnitSquare}, testing::isotropic_field(1));
  EXPECT_EQ(quads.mesh->n_faces(), 1u);
  EXPECT_EQ(quads.mesh->n_vertices(), 4u);
}

TEST(MakeQuads, FillsPolygonsOfFewNodes) {
  for (const int nodes : {4, 6, 8, 10, 12}) {
    for (const double size : {0.3, 1.0, 3.0, 100.0}) {
      const auto field = testing::isotropic_field(size);
      const PatchQuads quads = quads_of({circle({0, 0}, 1, nodes)}, field);
      testing::expect_valid(*quads.mesh);
      const Figures figures = figures_of(*quads.mesh, field);
      EXPECT_EQ(figures.triangles, 0u) << nodes << " nodes, size " << size;
      EXPECT_GT(figures.least, 0) << nodes << " nodes, size " << size;
    }
  }
}

TEST(MakeQuads, CountsItsQueries) {
  const auto field = testing::isotropic_field([](Uv p) { return 0.03 + 0.05 * p.u; });
  const auto loops = with_even_nodes({kUnitSquare}, field);
  auto triangles = triangulate_boundary(loops, field).delaunay;
  const std::size_t before = field.queries();
  const std::vector<std::size_t> sizes = {loops[0].size()};
  const PatchQuads quads = make_quads(std::move(triangles), field, sizes, RunContext());
  EXPECT_EQ(quads.report.queries.total(), field.queries() - before);
}

TEST(MakeQuads, IsTheSameEveryTime) {
  const auto field = testing::shock_field(10);
  const auto loops = with_even_nodes({kUnitSquare}, field);
  const PatchQuads a = quads_of(loops, field), b = quads_of(loops, field);
  ASSERT_EQ(a.mesh->n_vertices(), b.mesh->n_vertices());
  const auto uv_a = require(*a.mesh, keys::vertex_uv), uv_b = require(*b.mesh, keys::vertex_uv);
  for (const VertexHandle vh : a.mesh->vertices()) {
    EXPECT_EQ(a.mesh->property(uv_a, vh), b.mesh->property(uv_b, vh));
  }
  EXPECT_EQ(a.report.tried, b.report.tried);
}

TEST(MakeQuads, IsTheSameInScaledParameters) {
  const auto field = testing::isotropic_field([](Uv p) { return 0.05 + 0.05 * p.u * p.v; });
  const auto scaled = testing::with_scaled_parameters(field, 1024, 0.25);
  const auto loops = with_even_nodes({kUnitSquare}, field);
  Loops wide = loops;
  for (Uv& p : wide[0]) p = {1024 * p.u, 0.25 * p.v};
  const PatchQuads a = quads_of(loops, field), b = quads_of(wide, scaled);
  EXPECT_NEAR(static_cast<double>(a.mesh->n_faces()), static_cast<double>(b.mesh->n_faces()),
              0.05 * static_cast<double>(a.mesh->n_faces()));
  EXPECT_NEAR(figures_of(*a.mesh, field).mean, figures_of(*b.mesh, scaled).mean, 0.03);
}

TEST(MakeQuads, EndsOnceItIsCancelled) {
  testing::Cancelling observer;
  const RunContext context(&observer);
  const auto field = testing::isotropic_field(0.1);
  EXPECT_EQ(error_of([&] { quads_of({with_nodes(kUnitSquare, field)}, field, context); }),
            testing::kCancelled);
}

}  // namespace
}  // namespace surfmesh
