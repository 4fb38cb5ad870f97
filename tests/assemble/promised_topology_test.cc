// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/promised_topology.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/assembled.hh"
#include "support/models.hh"
#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

using testing::assemble_with_size;

struct Expected {
  const char* name;
  testing::MakeModel model;
  std::size_t components;
  long euler;
  std::size_t open_contours;
};

void PrintTo(const Expected& shape, std::ostream* out) { *out << shape.name; }

std::vector<Expected> expected() {
  return {{"Sphere", [] { return testing::sphere_of(1); }, 1, 2, 0},
          {"SphereOfThree", [] { return testing::sphere_of(3); }, 1, 2, 0},
          {"Torus", [] { return testing::torus_of(1); }, 1, 0, 0},
          {"TorusOfThree", [] { return testing::torus_of(3); }, 1, 0, 0},
          {"Cylinder", [] { return testing::cylinder_of(1); }, 1, 0, 2},
          {"Cone", [] { return testing::cone_of(2); }, 1, 1, 2},
          {"Square", testing::unit_square, 1, 1, 4},
          {"SquareWithHole", [] { return testing::square_with_hole(0.5); }, 1, 0, 5},
          {"MobiusBandCut", testing::mobius_band, 1, 1, 3},
          {"ThreeSquaresCut", testing::three_squares, 3, 3, 10}};
}

class Promise : public ::testing::TestWithParam<Expected> {};

TEST_P(Promise, IsThatOfTheShape) {
  const PromisedTopology promise = promised_topology(GetParam().model());
  EXPECT_EQ(promise.components, GetParam().components);
  EXPECT_EQ(promise.euler, GetParam().euler);
  EXPECT_EQ(std::count(promise.is_open.begin(), promise.is_open.end(), 1),
            static_cast<long>(GetParam().open_contours));
}

TEST_P(Promise, IsKeptByTheMesh) {
  const Model model = GetParam().model();
  const testing::Assembled assembled = assemble_with_size(model, 0.3);
  for (const MeshFault& fault : compare_with_promise(assembled.mesh, model)) {
    ADD_FAILURE() << fault.kind << ": " << fault.places.front();
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Promise, ::testing::ValuesIn(expected()),
                         [](const auto& test) { return std::string(test.param.name); });

/// The kinds of faults of a mesh against another model.
std::vector<std::string> kinds(const PolyMesh& mesh, const Model& model) {
  std::vector<std::string> result;
  for (const MeshFault& fault : compare_with_promise(mesh, model)) result.push_back(fault.kind);
  return result;
}

/// A sphere of one patch, whose first face is taken out.
struct Sphere {
  Sphere() {
    mesh = assemble_with_size(model, 0.5).mesh;
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();
    mesh.request_halfedge_status();
    mesh.delete_face(FaceHandle(0), false);
    mesh.garbage_collection();
  }

  Model model = testing::sphere_of(1);
  PolyMesh mesh;
};

TEST(Comparison, FindsAHoleInAClosedMesh) {
  const Sphere sphere;
  const auto faults = compare_with_promise(sphere.mesh, sphere.model);
  ASSERT_EQ(kinds(sphere.mesh, sphere.model), (std::vector<std::string>{"open_edge", "euler"}));
  EXPECT_EQ(faults[0].count, 3u);
  EXPECT_EQ(faults[0].places[0].find("patch p0 at ("), 0u) << faults[0].places[0];
  EXPECT_EQ(faults[1].places[0], "1 instead of 2");
}

TEST(Comparison, FindsTheHoleWithoutContoursToo) {
  Sphere sphere;
  detach(sphere.mesh, keys::edge_contour);
  EXPECT_EQ(kinds(sphere.mesh, sphere.model), (std::vector<std::string>{"open_edge", "euler"}));
}

/// As where elements lie on several patches.
TEST(Comparison, LetsFacesOfOtherPatchesEndAtOpenContours) {
  const Model model = testing::model_of({testing::sphere(), testing::rectangle(2, 2, 3, 3)});
  PolyMesh mesh = assemble_with_size(model, 0.5).mesh;
  detach(mesh, keys::edge_contour);
  mesh.property(require(mesh, keys::face_patch)).data_vector().assign(mesh.n_faces(), 0);
  EXPECT_EQ(kinds(mesh, model), std::vector<std::string>());
  for (const VertexHandle vh : mesh.vertices()) {
    mesh.set_point(vh, mesh.point(vh) * 1.001);
  }
  EXPECT_EQ(kinds(mesh, model), std::vector<std::string>{"open_edge"});
}

TEST(Comparison, FindsVerticesInOnePlace) {
  const Model model = testing::sphere_of(1);
  PolyMesh mesh = assemble_with_size(model, 0.5).mesh;
  mesh.set_point(VertexHandle(7), mesh.point(VertexHandle(9)));
  EXPECT_EQ(kinds(mesh, model), (std::vector<std::string>{"duplicate_vertex"}));
}

TEST(Comparison, FindsAMissingComponent) {
  const Model square = testing::unit_square();
  const PolyMesh mesh = assemble_with_size(square, 0.5).mesh;
  EXPECT_EQ(kinds(mesh, testing::three_squares()),
            (std::vector<std::string>{"components", "euler"}));
}

TEST(Comparison, FindsSidesThatAreGluedBeyondTheModel) {
  const PolyMesh mesh = assemble_with_size(testing::opposite_squares(), 0.5).mesh;
  Model model = testing::opposite_squares();
  for (Contour& contour : model.contours) {
    if (contour.uses.size() == 2) contour.uses.push_back(contour.uses[0]);
  }
  EXPECT_EQ(kinds(mesh, model).front(), "closed_edge");
}

}  // namespace
}  // namespace surfmesh
