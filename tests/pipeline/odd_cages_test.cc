// SPDX-License-Identifier: BSD-3-Clause
// Cages that are non-manifold, cannot be oriented or have sides that are points.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "cage/cages.hh"
#include "support/expect_valid.hh"
#include "support/notices.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

/// Cubes of edge 1 with their lower corners there, vertices in the same place being one.
Cage cubes_at(const std::vector<Vec3>& origins) {
  Cage cage;
  std::map<std::array<double, 3>, int> vertex_at;
  for (const Vec3& origin : origins) {
    for (std::vector<int> face : testing::cube().faces) {
      for (int& v : face) {
        const Vec3 p = origin + Vec3(v & 1 ? 1 : 0, v & 2 ? 1 : 0, v & 4 ? 1 : 0);
        const auto [entry, is_new] =
            vertex_at.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(cage.points.size()));
        if (is_new) cage.points.push_back(p);
        v = entry->second;
      }
      cage.faces.push_back(face);
    }
  }
  return cage;
}

/// Sheets that meet in an edge of length 2, each 1 × 2 quads.
Cage book(int sheets) {
  Cage cage;
  for (int z = 0; z <= 2; ++z) cage.points.emplace_back(0, 0, z);
  for (int k = 0; k < sheets; ++k) {
    const double a = 2 * M_PI * k / sheets;
    const int first = static_cast<int>(cage.points.size());
    for (int z = 0; z <= 2; ++z) cage.points.emplace_back(std::cos(a), std::sin(a), z);
    for (int z = 0; z < 2; ++z) cage.faces.push_back({z, first + z, first + z + 1, z + 1});
  }
  return cage;
}

/// A cube whose top is two quads around a vertex in the middle.
Cage cube_with_vertex_of_two_faces() {
  Cage cage = testing::cube();
  cage.points.emplace_back(0, 0, 1.5);
  cage.faces[1] = {4, 5, 7, 8};
  cage.faces.push_back({4, 8, 7, 6});
  return cage;
}

/// Quads around a vertex that each of them has twice: sides that are points.
Cage pole_of_quads() {
  Cage cage = testing::quad_fan(8);
  for (std::vector<int>& face : cage.faces) {
    std::rotate(face.begin(), std::find(face.begin(), face.end(), 0), face.end());
    face = {face[0], face[0], face[1], face[3]};
  }
  return cage;
}

struct OddCage {
  std::string name;
  Cage cage;
  std::size_t components;
  long euler;
  std::string warning;  ///< a part of the only one; empty for none
};

void PrintTo(const OddCage& odd, std::ostream* out) { *out << odd.name; }

struct Patches {
  const char* name;
  PatchKind kind;
};

void PrintTo(const Patches& patches, std::ostream* out) { *out << patches.name; }

class OddCages : public ::testing::TestWithParam<std::tuple<OddCage, Patches>> {};

TEST_P(OddCages, AreMeshedAndCutWhereNoHalfEdgeMeshFollows) {
  const auto& [odd, patches] = GetParam();
  const MeshResult result = mesh_model(model_from_cage(odd.cage, {.patches = patches.kind}));
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
  const MeshTopology topology = measure_topology(result.mesh);
  EXPECT_EQ(topology.components, odd.components);
  EXPECT_EQ(topology.euler, odd.euler);
  ASSERT_EQ(texts_of(result.report.notices, Severity::Warning).size(),
            odd.warning.empty() ? 0u : 1u);
  if (odd.warning.empty()) return;
  EXPECT_NE(texts_of(result.report.notices, Severity::Warning)[0].find(odd.warning),
            std::string::npos)
      << texts_of(result.report.notices, Severity::Warning)[0];
}

Cage with_holes(Cage cage, std::vector<int> holes) {
  cage.holes = std::move(holes);
  return cage;
}

const std::string kCut = "sides of faces are left open";
const std::string kTouch = "in a point only: 1, the first at";

INSTANTIATE_TEST_SUITE_P(
    Of, OddCages,
    ::testing::Combine(
        ::testing::Values(
            OddCage{"TwoCubesAtAVertex", cubes_at({{0, 0, 0}, {1, 1, 1}}), 2, 4, kTouch},
            OddCage{"TwoCubesAtAnEdge", cubes_at({{0, 0, 0}, {1, 1, 0}}), 2, 2, kCut},
            OddCage{"TwoCubesAtAFace", cubes_at({{0, 0, 0}, {1, 0, 0}}), 4, 4, kCut},
            OddCage{"ThreeSheetsAtAnEdge", book(3), 3, 3, kCut},
            OddCage{"FiveSheetsAtAnEdge", book(5), 5, 5, kCut},
            OddCage{"HolesThatTouch", with_holes(testing::sheet(4, 4), {5, 10}), 1, 0, kTouch},
            OddCage{"MobiusBand", testing::mobius_strip(10, 2), 1, 1, kCut},
            OddCage{"VertexOfTwoQuads", cube_with_vertex_of_two_faces(), 1, 2, ""},
            OddCage{"PoleOfQuads", pole_of_quads(), 1, 1, ""}),
        ::testing::Values(Patches{"AsBlocks", PatchKind::Blocks},
                          Patches{"AsFaces", PatchKind::Faces})),
    [](const auto& param) {
      return std::get<0>(param.param).name + std::get<1>(param.param).name;
    });

TEST(PoleOfQuads, HasItsVertexWhereTheCageHasIt) {
  // For a face with a vertex twice is no triangle: the side that is a point makes a corner of it.
  Cage cage = pole_of_quads();
  cage.points[0] = {0, 0, 1};
  const MeshResult result = mesh_model(model_from_cage(cage));
  double least = 1;
  for (const VertexHandle vh : result.mesh.vertices()) {
    least = std::min(least, (to_eigen(result.mesh.point(vh)) - cage.points[0]).norm());
  }
  EXPECT_LT(least, 1e-12);
}

/// Least 4√3 A / (l1² + l2² + l3²) of the triangles in space.
double least_shape(const PolyMesh& mesh) {
  double least = 1;
  for (const FaceHandle fh : mesh.faces()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(fh);
    const Vec3 a = to_eigen(mesh.point(mesh.from_vertex_handle(heh)));
    const Vec3 b = to_eigen(mesh.point(mesh.to_vertex_handle(heh))) - a;
    const Vec3 c = to_eigen(mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(heh)))) - a;
    const double lengths = b.squaredNorm() + c.squaredNorm() + (c - b).squaredNorm();
    least = std::min(least, 2 * std::sqrt(3) * b.cross(c).norm() / lengths);
  }
  return least;
}

/// A pyramid without its base, of triangles around its tip.
Cage open_pyramid(int n) {
  Cage cage;
  cage.points = {{0, 0, 1}};
  for (int i = 0; i < n; ++i) {
    cage.points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 0);
    cage.faces.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return cage;
}

TEST(PyramidOfManySides, HasNoTurnedElements) {
  // Elements far wider than the faces, which zigzag around the tip where they are refined.
  PipelineOptions options;
  options.sizing.curvature = 0;
  for (const Scheme scheme : {Scheme::CatmullClark, Scheme::Loop}) {
    const MeshResult result =
        mesh_model(model_from_cage(open_pyramid(100), {.scheme = scheme}), {}, options);
    testing::expect_valid(result.mesh);
    EXPECT_EQ(texts_of(result.report.notices), std::vector<std::string>{});
  }
}

/// Two pyramids on the same base.
Cage bipyramid(int n) {
  Cage cage = open_pyramid(n);
  const int tip = static_cast<int>(cage.points.size());
  cage.points.emplace_back(0, 0, -1);
  for (int i = 0; i < n; ++i) cage.faces.push_back({tip, 1 + (i + 1) % n, 1 + i});
  return cage;
}

TEST(VertexOfManyFaces, TakesTrianglesInProportionToItsFaces) {
  // Elements as small as ripples between the faces would be 100 to 2,000 for each of these faces.
  for (const int n : {32, 128}) {
    const Cage cage = bipyramid(n);
    for (const Scheme scheme : {Scheme::CatmullClark, Scheme::Loop}) {
      const MeshResult result = mesh_model(model_from_cage(cage, {.scheme = scheme}));
      testing::expect_valid(result.mesh);
      EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
      EXPECT_LT(result.mesh.n_faces(), 50 * cage.faces.size()) << n;
    }
  }
}

TEST(FaceOfManySides, IsMeshedWhereItsPartsAreNarrowerThanHmin) {
  // Nodes along the parts make many triangles, in next to no metric area.
  constexpr int sides = 800;
  Cage cage;
  cage.faces.emplace_back();
  for (int i = 0; i < sides; ++i) {
    cage.points.emplace_back(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), 0);
    cage.faces[0].push_back(i);
  }
  const MeshResult result = mesh_model(model_from_cage(cage));
  testing::expect_valid(result.mesh);
  EXPECT_EQ(texts_of(result.report.notices, Severity::Shortfall), std::vector<std::string>{});
}

TEST(PrismOfManySides, HasNoSliversBesideItsCentres) {
  // The parts of its ends are narrow quads around a vertex.
  PipelineOptions options;
  options.sizing.hmin = Length::share(0.005);
  options.sizing.hmax = Length::share(0.1);
  const MeshResult result = mesh_model(model_from_cage(testing::prism(16)), {}, options);
  EXPECT_GT(least_shape(result.mesh), 0.3);
}

}  // namespace
}  // namespace surfmesh
