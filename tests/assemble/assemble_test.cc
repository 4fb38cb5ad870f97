// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/assemble.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support/assembled.hh"
#include "support/expect_valid.hh"
#include "support/models.hh"
#include "support/notices.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

using testing::assemble_with_size;
using testing::Assembled;

struct Shape {
  const char* name;
  testing::MakeModel model;
  long euler;
  bool is_closed;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

std::vector<Shape> shapes() {
  return {{"Sphere", [] { return testing::sphere_of(1); }, 2, true},
          {"SphereOfTwo", [] { return testing::sphere_of(2); }, 2, true},
          {"SphereOfFive", [] { return testing::sphere_of(5); }, 2, true},
          {"Torus", [] { return testing::torus_of(1); }, 0, true},
          {"TorusOfTwo", [] { return testing::torus_of(2); }, 0, true},
          {"TorusOfThree", [] { return testing::torus_of(3); }, 0, true},
          {"Cylinder", [] { return testing::cylinder_of(1); }, 0, false},
          {"CylinderOfTwo", [] { return testing::cylinder_of(2); }, 0, false},
          {"Cone", [] { return testing::cone_of(1); }, 1, false},
          {"ConeOfTwo", [] { return testing::cone_of(2); }, 1, false},
          {"OppositeSquares", testing::opposite_squares, 1, false}};
}

/// From a thousand diagonals down to 0.02 of one.
std::vector<double> sizes() {
  std::vector<double> result = {1000, 30};
  for (double size = 3; size > 0.02; size *= 0.6) result.push_back(size);
  return result;
}

Vec3 point(const PolyMesh& mesh, VertexHandle vh) { return to_eigen(mesh.point(vh)); }

class AnySize : public ::testing::TestWithParam<std::tuple<Shape, double>> {
 protected:
  void SetUp() override { assembled_ = assemble_with_size(model(), size() * model().diagonal); }

  const Model& model() const { return model_; }
  double size() const { return std::get<1>(GetParam()); }
  const PolyMesh& mesh() const { return assembled_.mesh; }

  bool is_pole(const Vec3& p) const {
    return std::any_of(model().contours.begin(), model().contours.end(), [&](const Contour& c) {
      return c.is_degenerate && model().vertices[static_cast<std::size_t>(c.start)].position == p;
    });
  }

  Model model_ = std::get<0>(GetParam()).model();
  Assembled assembled_;
};

TEST_P(AnySize, MakesAProperMesh) {
  testing::expect_valid(mesh());
  const MeshTopology topology = measure_topology(mesh());
  EXPECT_EQ(topology.euler, std::get<0>(GetParam()).euler);
  EXPECT_EQ(topology.is_closed, std::get<0>(GetParam()).is_closed);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.split_vertices, 0u);
  EXPECT_TRUE(texts_of(assembled_.report.notices, Severity::Warning).empty());
}

TEST_P(AnySize, GivesCornersTheParametersOfTheirPlace) {
  const auto uv = require(mesh(), keys::corner_uv);
  const auto patch = require(mesh(), keys::face_patch);
  for (const auto fh : mesh().faces()) {
    const Surface& surface =
        *model().patches.at(static_cast<std::size_t>(mesh().property(patch, fh))).surface;
    for (const auto heh : mesh().fh_range(fh)) {
      const Vec3 p = point(mesh(), mesh().to_vertex_handle(heh));
      if (is_pole(p)) continue;
      const Vec3 q = surface.evaluate(mesh().property(uv, heh), Order::Position).point;
      EXPECT_LT((q - p).norm(), 1e-9 * model().diagonal);
    }
  }
}

TEST_P(AnySize, GivesCornersAMetric) {
  const auto metric = require(mesh(), keys::corner_metric);
  for (const auto heh : mesh().halfedges()) {
    if (mesh().is_boundary(heh)) continue;
    const Metric& m = mesh().property(metric, heh);
    EXPECT_GT(m.m11, 0);
    EXPECT_GT(m.m11 * m.m22 - m.m12 * m.m12, 0);
  }
}

TEST_P(AnySize, TellsTheContourOfEverySegment) {
  const auto contour = require(mesh(), keys::edge_contour);
  std::map<int, int> count;
  for (const auto eh : mesh().edges()) ++count[mesh().property(contour, eh)];
  for (std::size_t c = 0; c < model().contours.size(); ++c) {
    const int expected =
        model().contours[c].is_degenerate ? 0 : assembled_.nodes[c].segment_count();
    EXPECT_EQ(count[static_cast<int>(c)], expected) << model().contours[c].name;
  }
}

TEST_P(AnySize, HasContoursBetweenPatchesAndAtTheBoundary) {
  const auto contour = require(mesh(), keys::edge_contour);
  const auto patch = require(mesh(), keys::face_patch);
  for (const auto eh : mesh().edges()) {
    const bool is_open = mesh().is_boundary(eh);
    if (is_open ||
        mesh().property(patch, eh.h0().face()) != mesh().property(patch, eh.h1().face())) {
      EXPECT_GE(mesh().property(contour, eh), 0);
    }
  }
}

/// Small against the surface: chords of a coarser mesh cut through the body.
class FineSize : public AnySize {};

TEST_P(FineSize, TurnsNoTriangle) { EXPECT_EQ(assembled_.turned, 0u); }

std::string name_of(const ::testing::TestParamInfo<std::tuple<Shape, double>>& test) {
  const int thousandths = static_cast<int>(std::lround(1000 * std::get<1>(test.param)));
  return std::string(std::get<0>(test.param).name) + "Size" + std::to_string(thousandths);
}

INSTANTIATE_TEST_SUITE_P(Shapes, AnySize,
                         ::testing::Combine(::testing::ValuesIn(shapes()),
                                            ::testing::ValuesIn(sizes())),
                         name_of);

INSTANTIATE_TEST_SUITE_P(Shapes, FineSize,
                         ::testing::Combine(::testing::ValuesIn(shapes()),
                                            ::testing::Values(0.1, 0.07, 0.04, 0.02)),
                         name_of);

Vec3 normal(const PolyMesh& mesh, FaceHandle fh) {
  std::vector<Vec3> p;
  for (const VertexHandle vh : mesh.fv_range(fh)) p.push_back(point(mesh, vh));
  return (p[1] - p[0]).cross(p[2] - p[0]);
}

TEST(Assemble, OrientsNeighboursAlike) {
  const Assembled result = assemble_with_size(testing::opposite_squares(), 0.2);
  for (const FaceHandle fh : result.mesh.faces()) {
    EXPECT_GT(normal(result.mesh, fh).z(), 0);
  }
}

TEST(Assemble, DropsVerticesThatNoFaceHas) {
  Model model = testing::cylinder_of(2);
  const Assembled plain = assemble_with_size(model, 0.2);
  model.vertices.push_back({Vec3(7, 7, 7)});
  const Assembled result = assemble_with_size(model, 0.2);
  testing::expect_valid(result.mesh);
  ASSERT_EQ(result.mesh.n_vertices(), plain.mesh.n_vertices());
  EXPECT_EQ(result.mesh.n_faces(), plain.mesh.n_faces());
  for (const VertexHandle vh : plain.mesh.vertices()) {
    EXPECT_EQ(point(result.mesh, vh), point(plain.mesh, vh)) << vh.idx();
  }
  // No patch is cut into tiles, so those on contours are all that are shared.
  EXPECT_EQ(result.report.between_tiles.first, result.report.between_tiles.end);
  EXPECT_EQ(result.report.between_tiles.first, plain.report.between_tiles.first);
}

TEST(Assemble, KeepsTheParametersOfATurnedPatch) {
  const Assembled result = assemble_with_size(testing::opposite_squares(), 0.2);
  const PolyMesh& mesh = result.mesh;
  const auto uv = require(mesh, keys::corner_uv);
  const auto patch = require(mesh, keys::face_patch);
  for (const auto fh : mesh.faces()) {
    if (mesh.property(patch, fh) != 1) continue;
    for (const auto heh : mesh.fh_range(fh)) {
      const Vec3 p = point(mesh, mesh.to_vertex_handle(heh));
      EXPECT_NEAR(mesh.property(uv, heh).u, p.y(), 1e-14);
      EXPECT_NEAR(mesh.property(uv, heh).v, p.x() - 1, 1e-14);
    }
  }
}

TEST(Assemble, CutsAMobiusBandWithAWarning) {
  const Assembled result = assemble_with_size(testing::mobius_band(), 0.1);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(measure_topology(result.mesh).euler, 1);
  ASSERT_EQ(texts_of(result.report.notices, Severity::Warning).size(), 1u);
  EXPECT_NE(texts_of(result.report.notices, Severity::Warning)[0].find("cannot be oriented"),
            std::string::npos);
}

/// How many vertices lie at each position, for positions with more than one.
std::vector<std::size_t> repeated_positions(const PolyMesh& mesh) {
  std::map<std::array<double, 3>, std::size_t> count;
  for (const VertexHandle vh : mesh.vertices()) {
    const Vec3 p = point(mesh, vh);
    ++count[{p.x(), p.y(), p.z()}];
  }
  std::vector<std::size_t> result;
  for (const auto& [place, n] : count) {
    if (n > 1) result.push_back(n);
  }
  return result;
}

TEST(Assemble, CutsAMobiusBandAtEqualPositions) {
  const Assembled result = assemble_with_size(testing::mobius_band(), 0.1);
  EXPECT_EQ(repeated_positions(result.mesh), std::vector<std::size_t>(7, 2));
}

TEST(Assemble, CutsAnEdgeOfThreePatchesAtEqualPositions) {
  const Assembled result = assemble_with_size(testing::three_squares(), 0.1);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(measure_topology(result.mesh).components, 3u);
  EXPECT_EQ(repeated_positions(result.mesh), std::vector<std::size_t>(11, 3));
  EXPECT_EQ(texts_of(result.report.notices, Severity::Warning).size(), 1u);
}

TEST(Assemble, TakesApartPatchesThatMeetInAVertexOnlyWithAWarning) {
  const Assembled result =
      assemble_with_size(testing::model_of({testing::plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                            testing::plane({1, 1, 0}, {1, 0, 0}, {0, 1, 0})}),
                         0.2);
  testing::expect_valid(result.mesh);
  EXPECT_EQ(repeated_positions(result.mesh), std::vector<std::size_t>{2});
  ASSERT_EQ(texts_of(result.report.notices, Severity::Warning).size(), 1u);
  EXPECT_NE(texts_of(result.report.notices, Severity::Warning)[0].find(
                "in a point only: 1, the first at (1, 1, 0)"),
            std::string::npos)
      << texts_of(result.report.notices, Severity::Warning)[0];
}

TEST(Assemble, HasNoVertexWithoutATriangle) {
  for (const Model& model : {testing::sphere_of(2), testing::cone_of(1)}) {
    const Assembled result = assemble_with_size(model, 0.3);
    for (const VertexHandle vh : result.mesh.vertices()) {
      EXPECT_FALSE(result.mesh.is_isolated(vh));
    }
  }
}

TEST(Assemble, GivesTheSameMeshTwice) {
  const Model model = testing::torus_of(2);
  const Assembled first = assemble_with_size(model, 0.3), second = assemble_with_size(model, 0.3);
  const PolyMesh &a = first.mesh, &b = second.mesh;
  ASSERT_EQ(a.n_vertices(), b.n_vertices());
  ASSERT_EQ(a.n_faces(), b.n_faces());
  for (const VertexHandle vh : a.vertices()) EXPECT_EQ(a.point(vh), b.point(vh));
}

TEST(SplitImproperChords, SplitsNothingInAFineMesh) {
  for (const Model& model : {testing::torus_of(1), testing::cylinder_of(1)}) {
    EXPECT_EQ(assemble_with_size(model, 0.05 * model.diagonal).chords, 0u);
  }
}

TEST(SplitImproperChords, SplitsChordsOfACoarseTorus) {
  EXPECT_GT(assemble_with_size(testing::torus_of(1), 1000).chords, 0u);
}

}  // namespace
}  // namespace surfmesh
