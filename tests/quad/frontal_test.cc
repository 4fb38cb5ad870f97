// SPDX-License-Identifier: BSD-3-Clause
// The frontal method by itself, before quads are cleaned, and with everything that follows.
#include "surfmesh/quad/frontal.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

#include "support/cancelling.hh"
#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/metric_fields.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/improve/improve.hh"
#include "surfmesh/quad/compact_patch.hh"
#include "surfmesh/quad/make_quads.hh"
#include "surfmesh/quad/patch_geometry.hh"
#include "surfmesh/refine/refine.hh"

namespace surfmesh {

/// Outside of the unnamed namespace, where GoogleTest finds it.
void PrintTo(QuadFront front, std::ostream* out) {
  *out << to_text(ranges::kQuadFront, static_cast<double>(front));
}

namespace {

using testing::circle;
using testing::FunctionField;
using Loops = std::vector<std::vector<Uv>>;

std::vector<std::size_t> sizes_of(const Loops& loops) {
  std::vector<std::size_t> sizes;
  for (const std::vector<Uv>& loop : loops) sizes.push_back(loop.size());
  return sizes;
}

/// A domain with its metric.
struct DomainCase {
  const char* name;
  FunctionField field;
  Loops loops;
};

void PrintTo(const DomainCase& domain, std::ostream* out) { *out << domain.name; }

std::unique_ptr<DelaunayMesh> triangles_of(const DomainCase& domain) {
  auto delaunay = triangulate_boundary(domain.loops, domain.field).delaunay;
  refine(*delaunay, domain.field);
  improve(*delaunay, domain.field);
  return delaunay;
}

struct Quads {
  std::unique_ptr<PolyMesh> mesh;
  FrontalReport report;
};

Quads converted(const DomainCase& domain, QuadFront front) {
  Quads result;
  result.mesh = triangles_of(domain)->release();
  FaceEditor editor(*result.mesh);
  const std::vector<std::size_t> sizes = sizes_of(domain.loops);
  const FrontalInput input{domain.field, sizes, front};
  result.report = convert_frontal(*result.mesh, editor, input, RunContext());
  compact_patch(*result.mesh, editor);
  return result;
}

PatchQuads finished(const DomainCase& domain, QuadFront front) {
  const std::vector<std::size_t> sizes = sizes_of(domain.loops);
  return convert_to_quads(triangles_of(domain), {domain.field, sizes, front}, RunContext());
}

/// The corners of all faces, by their numbers.
std::vector<int> corners_of(const PolyMesh& mesh) {
  std::vector<int> corners;
  for (const FaceHandle fh : mesh.faces()) {
    for (const VertexHandle vh : mesh.fv_range(fh)) corners.push_back(vh.idx());
  }
  return corners;
}

std::vector<Uv> places_of(const PolyMesh& mesh) {
  const auto uv = require(mesh, keys::vertex_uv);
  std::vector<Uv> places;
  for (const VertexHandle vh : mesh.vertices()) places.push_back(mesh.property(uv, vh));
  return places;
}

std::size_t count_faces(const PolyMesh& mesh, unsigned corners) {
  std::size_t count = 0;
  for (const FaceHandle fh : mesh.faces()) count += mesh.valence(fh) == corners ? 1 : 0;
  return count;
}

double least_jacobian(const DomainCase& domain, PolyMesh& mesh) {
  const PatchGeometry geometry(mesh, domain.field, mesh.n_vertices());
  double least = 1;
  for (const FaceHandle fh : mesh.faces()) {
    least = std::min(least, geometry.measure(fh).least_jacobian);
  }
  return least;
}

double mean_jacobian(const DomainCase& domain, PolyMesh& mesh) {
  const PatchGeometry geometry(mesh, domain.field, mesh.n_vertices());
  double sum = 0;
  for (const FaceHandle fh : mesh.faces()) sum += geometry.measure(fh).least_jacobian;
  return sum / static_cast<double>(mesh.n_faces());
}

/// The standard deviation of the metric lengths of the edges.
double deviation(const PolyMesh& mesh) {
  const auto uv = require(mesh, keys::vertex_uv);
  const auto metric = require(mesh, keys::vertex_metric);
  double sum = 0, squares = 0;
  for (const EdgeHandle eh : mesh.edges()) {
    const VertexHandle a = mesh.to_vertex_handle(mesh.halfedge_handle(eh, 0));
    const VertexHandle b = mesh.to_vertex_handle(mesh.halfedge_handle(eh, 1));
    const double length = fast_edge_length(mesh.property(uv, a), mesh.property(metric, a),
                                           mesh.property(uv, b), mesh.property(metric, b));
    sum += length;
    squares += length * length;
  }
  const auto count = static_cast<double>(mesh.n_edges());
  return std::sqrt(squares / count - sum / count * sum / count);
}

DomainCase four_points() {
  const FunctionField field = testing::four_point_field();
  return {"FourPoints", field, {testing::with_nodes(testing::kUnitSquare, field)}};
}

/// Both loops are odd, so a front that meets itself must mind the triangles behind.
DomainCase ring_of_odd_loops() {
  return {"RingOfOddLoops",
          testing::isotropic_field(0.1),
          {circle({0, 0}, 1, 63), circle({0.2, 0}, 0.5, -31)}};
}

std::vector<DomainCase> domains() {
  const FunctionField shock = testing::shock_field(10);
  return {
      four_points(),
      ring_of_odd_loops(),
      {"Shock", shock, {testing::with_nodes(testing::kUnitSquare, shock)}},
      {"Disc", testing::isotropic_field(0.1), {circle({0, 0}, 1, 62)}},
      {"Strip",
       testing::isotropic_field(1),
       {testing::with_nodes({{0, 0}, {20, 0}, {20, 1.5}, {0, 1.5}}, testing::isotropic_field(1))}}};
}

constexpr std::array kFronts = {QuadFront::LeeLo, QuadFront::QMorph, QuadFront::Mixed};

const char* name_of(QuadFront front) {
  constexpr std::array names = {"LeeLo", "QMorph", "Mixed"};
  return names[static_cast<std::size_t>(front)];
}

class Frontal : public ::testing::TestWithParam<std::tuple<DomainCase, QuadFront>> {
 protected:
  const DomainCase& domain() const { return std::get<0>(GetParam()); }
  QuadFront front() const { return std::get<1>(GetParam()); }
};

TEST_P(Frontal, MakesQuadsOnly) {
  const Quads quads = converted(domain(), front());
  EXPECT_EQ(quads.report.triangles, 0U);
  EXPECT_EQ(count_faces(*quads.mesh, 4), quads.mesh->n_faces());
}

TEST_P(Frontal, InvertsNoQuadBeforeCleaning) {
  const Quads quads = converted(domain(), front());
  EXPECT_GT(least_jacobian(domain(), *quads.mesh), 0);
}

TEST_P(Frontal, InvertsNoQuadAfterCleaning) {
  const PatchQuads quads = finished(domain(), front());
  EXPECT_EQ(quads.report.triangles, 0U);
  EXPECT_GT(least_jacobian(domain(), *quads.mesh), 0.3);
}

TEST_P(Frontal, KeepsTheBoundary) {
  const Quads quads = converted(domain(), front());
  std::vector<Uv> nodes;
  for (const auto& loop : domain().loops) nodes.insert(nodes.end(), loop.begin(), loop.end());
  const std::vector<Uv> places = places_of(*quads.mesh);
  EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), places.begin()));
  std::size_t boundary_edges = 0;
  for (const EdgeHandle eh : quads.mesh->edges()) {
    boundary_edges += quads.mesh->is_boundary(eh) ? 1 : 0;
  }
  EXPECT_EQ(boundary_edges, nodes.size());
}

TEST_P(Frontal, KeepsTheEulerNumber) {
  const Quads quads = converted(domain(), front());
  EXPECT_EQ(measure_topology(*quads.mesh).euler, 2 - static_cast<long>(domain().loops.size()));
  EXPECT_TRUE(find_faults(*quads.mesh).empty());
}

TEST_P(Frontal, IsTheSameEachTime) {
  const Quads first = converted(domain(), front()), second = converted(domain(), front());
  EXPECT_EQ(corners_of(*first.mesh), corners_of(*second.mesh));
  EXPECT_EQ(places_of(*first.mesh), places_of(*second.mesh));
}

INSTANTIATE_TEST_SUITE_P(OfDomains, Frontal,
                         ::testing::Combine(::testing::ValuesIn(domains()),
                                            ::testing::ValuesIn(kFronts)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) +
                                  name_of(std::get<1>(test.param));
                         });

class FrontalExample : public ::testing::TestWithParam<QuadFront> {};

/// The paper's table 1 has 0.19 to 0.25, by the quads' own metric.
TEST_P(FrontalExample, DeviatesLessThanInThePaper) {
  const DomainCase domain = four_points();
  EXPECT_LT(deviation(*converted(domain, GetParam()).mesh), 0.23);
  EXPECT_LT(deviation(*finished(domain, GetParam()).mesh), 0.12);
}

TEST_P(FrontalExample, GetsBetterByCleaning) {
  const DomainCase domain = four_points();
  EXPECT_GT(mean_jacobian(domain, *finished(domain, GetParam()).mesh),
            mean_jacobian(domain, *converted(domain, GetParam()).mesh));
}

TEST_P(FrontalExample, LeavesOneTriangleBetweenOddBoundaries) {
  const DomainCase odd = {"Disc", testing::isotropic_field(0.1), {circle({0, 0}, 1, 63)}};
  const PatchQuads quads = finished(odd, GetParam());
  EXPECT_EQ(quads.report.triangles, 1U);
  EXPECT_EQ(count_faces(*quads.mesh, 3), 1U);
  EXPECT_EQ(count_faces(*quads.mesh, 4) + 1, quads.mesh->n_faces());
}

INSTANTIATE_TEST_SUITE_P(OfFronts, FrontalExample, ::testing::ValuesIn(kFronts),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST(FrontalWays, MergeOrAdvance) {
  const DomainCase domain = four_points();
  const FrontalReport lee_lo = converted(domain, QuadFront::LeeLo).report;
  const FrontalReport q_morph = converted(domain, QuadFront::QMorph).report;
  const FrontalReport mixed = converted(domain, QuadFront::Mixed).report;
  EXPECT_EQ(lee_lo.advanced, 0U);
  EXPECT_GT(q_morph.advanced, 9 * q_morph.merged);
  EXPECT_GT(q_morph.advanced, mixed.advanced);
  EXPECT_GT(mixed.advanced, mixed.merged);
}

TEST(FrontalWays, MakeASquareLatticeOfASquare) {
  const FunctionField field = testing::isotropic_field(0.1);
  const DomainCase domain = {"Square", field, {testing::with_nodes(testing::kUnitSquare, field)}};
  const PatchQuads quads = finished(domain, QuadFront::QMorph);
  EXPECT_NEAR(static_cast<double>(quads.mesh->n_faces()), 100, 12);
  EXPECT_GT(mean_jacobian(domain, *quads.mesh), 0.97);
}

TEST(FrontalRun, IsCancelled) {
  testing::Cancelling observer;
  const DomainCase domain = four_points();
  auto mesh = triangles_of(domain)->release();
  FaceEditor editor(*mesh);
  const std::vector<std::size_t> sizes = sizes_of(domain.loops);
  EXPECT_EQ(error_of([&] {
              convert_frontal(*mesh, editor, {domain.field, sizes, QuadFront::Mixed},
                              RunContext(&observer));
            }),
            testing::kCancelled);
}

}  // namespace
}  // namespace surfmesh
