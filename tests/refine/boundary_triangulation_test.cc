// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/refine/boundary_triangulation.hh"

#include <gtest/gtest.h>

#include <numeric>

#include "support/domain_meshes.hh"
#include "support/errors.hh"
#include "support/expect_valid.hh"

namespace surfmesh {
namespace {

using testing::circle;
using testing::constant_field;
using testing::FunctionField;
using testing::kUnitSquare;
using testing::polygon_area;
using Loops = std::vector<std::vector<Uv>>;

std::vector<Uv> scaled(std::vector<Uv> loop, double u_scale, double v_scale) {
  for (Uv& p : loop) p = {u_scale * p.u, v_scale * p.v};
  return loop;
}

/// A comb: `teeth` slots from above, so that most of the box is near the boundary.
std::vector<Uv> comb(int teeth) {
  std::vector<Uv> loop = {{0, 0}, {1, 0}};
  for (int i = teeth; i > 0; --i) {
    const double right = double(i) / teeth, width = 1.0 / teeth;
    loop.push_back({right, 1});
    loop.push_back({right - 0.4 * width, 1});
    loop.push_back({right - 0.5 * width, 0.01});
    loop.push_back({right - 0.6 * width, 1});
  }
  loop.push_back({0, 1});
  return loop;
}

struct DomainCase {
  const char* name;
  Loops loops;
};

void PrintTo(const DomainCase& domain, std::ostream* out) { *out << domain.name; }

/// Domains by name: the outer loop counter-clockwise, holes clockwise.
std::vector<DomainCase> domains() {
  const std::vector<Uv> ell = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  return {{"Triangle", {{{0, 0}, {1, 0}, {0, 1}}}},
          {"Square", {kUnitSquare}},
          {"LShape", {ell}},
          {"RoundHole", {kUnitSquare, circle({0.5, 0.5}, 0.3, -24)}},
          {"TwoHoles", {kUnitSquare, circle({0.25, 0.5}, 0.2, -12), circle({0.75, 0.5}, 0.2, -17)}},
          {"HoleNearTheRim", {kUnitSquare, circle({0.5, 0.5}, 0.4999, -40)}},
          {"Sliver", {{{0, 0}, {1, 1e-7}, {2, 0}, {1, 1e-6}}}},
          {"ThinRectangle", {{{0, 0}, {1, 0}, {1, 1e-9}, {0, 1e-9}}}},
          {"ManyNodes", {circle({0, 0}, 1, 5000)}},
          {"Comb", {comb(40)}},
          {"FarFromTheOrigin", {{{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6 + 1, 1e6 + 1}, {1e6, 1e6 + 1}}}}};
}

class Boundary : public ::testing::TestWithParam<DomainCase> {};

void expect_triangulated(const Loops& loops, const FunctionField& field) {
  const auto delaunay = triangulate_boundary(loops, field).delaunay;
  double area = 0;
  std::size_t first = 0, segments = 0;
  for (const auto& loop : loops) {
    area += polygon_area(loop);
    EXPECT_EQ(testing::count_constrained(*delaunay, first, loop.size()), loop.size());
    first += loop.size();
  }
  for (std::size_t i = 0; i < delaunay->n_edges(); ++i) {
    segments += delaunay->is_constrained(EdgeHandle(static_cast<int>(i))) ? 1 : 0;
  }
  EXPECT_EQ(segments, first);
  EXPECT_EQ(delaunay->n_vertices(), first);
  EXPECT_NEAR(testing::valid_area(*delaunay), area, 1e-9 * area);
  testing::expect_valid(delaunay->mesh());
}

TEST_P(Boundary, IsFilledWithAllItsSegments) {
  expect_triangulated(GetParam().loops, constant_field({1, 0, 1}));
}

TEST_P(Boundary, IsFilledInAStrongMetric) {
  expect_triangulated(GetParam().loops, constant_field({1, 0, 1e6}));
  expect_triangulated(GetParam().loops, constant_field({1 + 1e6, 1e6 - 1, 1 + 1e6}));
}

TEST_P(Boundary, IsFilledAtUnequalScales) {
  Loops loops = GetParam().loops;
  for (auto& loop : loops) loop = scaled(loop, 1e6, 1e-3);
  expect_triangulated(loops, constant_field({1e-12, 0, 1e6}));
}

TEST_P(Boundary, HasItsNodesAsVerticesInTheirOrder) {
  std::vector<Uv> nodes;
  for (const auto& loop : GetParam().loops) nodes.insert(nodes.end(), loop.begin(), loop.end());
  const auto delaunay = triangulate_boundary(GetParam().loops, constant_field({1, 0, 1})).delaunay;
  EXPECT_EQ(testing::positions(*delaunay), nodes);
}

TEST_P(Boundary, IsTheSameWhicheverWayTheLoopsRun) {
  Loops turned = GetParam().loops;
  for (auto& loop : turned) std::reverse(loop.begin(), loop.end());
  const auto field = constant_field({1, 0, 1});
  EXPECT_NEAR(testing::valid_area(*triangulate_boundary(turned, field).delaunay),
              testing::valid_area(*triangulate_boundary(GetParam().loops, field).delaunay), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Domains, Boundary, ::testing::ValuesIn(domains()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(TriangulateBoundary, AsksForTheMetricOnceANode) {
  const FunctionField field = constant_field({1, 0, 1});
  triangulate_boundary({kUnitSquare, circle({0.5, 0.5}, 0.3, -24)}, field);
  EXPECT_EQ(field.queries(), 28u);
}

TEST(TriangulateBoundary, GivesEveryNodeItsMetric) {
  const FunctionField field = testing::four_point_field();
  const auto delaunay = testing::empty_square(field);
  for (std::size_t i = 0; i < delaunay->n_vertices(); ++i) {
    const VertexHandle vh(static_cast<int>(i));
    EXPECT_EQ(delaunay->metric(vh), field(delaunay->uv(vh)));
  }
}

TEST(TriangulateBoundary, LeavesNothingToSwap) {
  const auto delaunay = testing::empty_square(testing::shock_field(1000));
  EXPECT_EQ(swap_edges(*delaunay), 0u);
}

struct BadLoops {
  const char* name;
  Loops loops;
  const char* reason;  ///< what the error tells
};

void PrintTo(const BadLoops& bad, std::ostream* out) { *out << bad.name; }

class BadBoundary : public ::testing::TestWithParam<BadLoops> {};

TEST_P(BadBoundary, IsAGeometryErrorThatTellsThePlace) {
  const std::string error = error_of([] {
    triangulate_boundary(GetParam().loops, constant_field({1, 0, 1}));
  });
  EXPECT_EQ(error.substr(0, 10), "geometry: ");
  EXPECT_NE(error.find(GetParam().reason), std::string::npos) << error;
}

const std::vector<Uv> kInner = {{0.2, 0.2}, {0.2, 0.8}, {0.8, 0.8}, {0.8, 0.2}};

INSTANTIATE_TEST_SUITE_P(
    Loops, BadBoundary,
    ::testing::Values(
        BadLoops{"NodeTwice",
                 {{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}, {0, 1}, {0.5, 0.5}}},
                 "(u,v) = (0.5, 0.5)"},
        BadLoops{"NodeTwiceInARow", {{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}}, "(u,v) = (1, 0)"},
        BadLoops{"Eight", {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, "(u,v) = ("},
        BadLoops{"CrossingHole", {kUnitSquare, {{0.2, 0.2}, {0.2, 0.8}, {1.8, 0.5}}}, "(u,v) = ("},
        BadLoops{"HolesThatCross",
                 {kUnitSquare, kInner, {{0.5, 0.5}, {0.5, 0.9}, {0.9, 0.9}, {0.9, 0.5}}},
                 "(u,v) = ("},
        BadLoops{"HoleTouchesWithANode",
                 {kUnitSquare, {{0.5, 0}, {0.2, 0.5}, {0.8, 0.5}}},
                 "(u,v) = (0.5, 0)"},
        BadLoops{"HoleOnTheOuterLoop", {kUnitSquare, kUnitSquare}, "(u,v) = ("},
        BadLoops{"NodeOnAnotherSegment", {{{0, 0}, {1, 0}, {1, 1}, {0.5, 0}, {0, 1}}}, "(u,v) = ("},
        BadLoops{"Segment", {{{0, 0}, {1, 0}}}, ""},
        BadLoops{"Line", {{{0, 0}, {1, 0}, {2, 0}}}, ""},
        BadLoops{"SkewLine", {{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}, ""},
        BadLoops{"Point", {{{0.5, 0.5}}}, ""}, BadLoops{"Nothing", {}, "nothing inside"},
        BadLoops{"NotANumber", {{{0, 0}, {1, 0}, {NAN, 1}}}, "(u,v) = ("},
        BadLoops{"Infinite", {{{0, 0}, {1, 0}, {INFINITY, 1}}}, "(u,v) = ("}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace surfmesh
