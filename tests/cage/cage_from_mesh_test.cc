// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage_from_mesh.hh"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <limits>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/cage/cage_model.hh"

namespace surfmesh {
namespace {

using FloatMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

struct StatusTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using StatusMesh = OpenMesh::PolyMesh_ArrayKernelT<StatusTraits>;
using StatusTriMesh = OpenMesh::TriMesh_ArrayKernelT<StatusTraits>;

/// A mesh of the faces and points of a cage.
template <class Mesh>
Mesh mesh_of_cage(const Cage& cage) {
  using Scalar = typename OpenMesh::vector_traits<typename Mesh::Point>::value_type;
  Mesh mesh;
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Vec3& p : cage.points) {
    vertices.push_back(mesh.add_vertex(typename Mesh::Point(
        static_cast<Scalar>(p.x()), static_cast<Scalar>(p.y()), static_cast<Scalar>(p.z()))));
  }
  for (const std::vector<int>& face : cage.faces) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const int v : face) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    mesh.add_face(corners);
  }
  return mesh;
}

std::string fault(const FloatMesh& mesh, const CageFromMeshOptions& options = {}) {
  return error_of([&] { cage_from_mesh(mesh, options); });
}

TEST(CageFromMesh, GivesBackWhatTheMeshWasMadeOf) {
  for (const Cage& cage : {testing::torus(), testing::sheet(), testing::pentagon_prism()}) {
    const Cage copy = cage_from_mesh(mesh_of_cage<StatusMesh>(cage));
    EXPECT_EQ(copy.points, cage.points);
    EXPECT_EQ(copy.faces, cage.faces);
    EXPECT_TRUE(copy.creases.empty() && copy.corners.empty() && copy.holes.empty());
  }
}

TEST(CageFromMesh, TakesTriangleMeshes) {
  const Cage cage = testing::icosahedron();
  EXPECT_EQ(cage_from_mesh(mesh_of_cage<StatusTriMesh>(cage)).faces, cage.faces);
}

TEST(CageFromMesh, TakesFloatPointsExactly) {
  const FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::torus());
  const Cage cage = cage_from_mesh(mesh);
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    const auto p = mesh.point(OpenMesh::VertexHandle(static_cast<int>(v)));
    EXPECT_EQ(cage.points[v], Vec3(p[0], p[1], p[2]));
  }
}

TEST(CageFromMesh, ReadsSharpnessFromProperties) {
  FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::cube());
  OpenMesh::EProp<double> crease(0, mesh, "crease");
  OpenMesh::VProp<float> corner(0, mesh, "corner");
  const auto eh = mesh.edge_handle(5);
  crease[eh] = 2.5;
  corner[OpenMesh::VertexHandle(3)] = 1.5f;
  const Cage cage = cage_from_mesh(mesh, {.creases = "crease", .corners = "corner"});
  ASSERT_EQ(cage.creases.size(), 1u);
  const auto heh = mesh.halfedge_handle(eh, 0);
  EXPECT_EQ(cage.creases[0].edge[0], mesh.from_vertex_handle(heh).idx());
  EXPECT_EQ(cage.creases[0].edge[1], mesh.to_vertex_handle(heh).idx());
  EXPECT_EQ(cage.creases[0].sharpness, 2.5);
  ASSERT_EQ(cage.corners.size(), 1u);
  EXPECT_EQ(cage.corners[0].vertex, 3);
  EXPECT_EQ(cage.corners[0].sharpness, 1.5);
}

TEST(CageFromMesh, AsksFunctions) {
  const FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::cube());
  CageFromMeshOptions options;
  options.creases = [](OpenMesh::EdgeHandle) { return 3.0; };
  options.corners = [](OpenMesh::VertexHandle vh) { return vh.idx() == 1 ? 10.0 : 0.0; };
  options.holes = [](OpenMesh::FaceHandle fh) { return fh.idx() == 4; };
  options.boundary = BoundaryRule::EdgeAndCorner;
  const Cage cage = cage_from_mesh(mesh, options);
  EXPECT_EQ(cage.creases.size(), mesh.n_edges());
  EXPECT_EQ(cage.corners.size(), 1u);
  EXPECT_EQ(cage.holes, std::vector<int>{4});
  EXPECT_EQ(cage.boundary, BoundaryRule::EdgeAndCorner);
  EXPECT_EQ(model_from_cage(cage).patches.size(), 5u);
}

TEST(CageFromMesh, ReadsHolesFromPropertiesOfBool) {
  FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::cube());
  OpenMesh::FProp<bool> hole(false, mesh, "hole");
  hole[OpenMesh::FaceHandle(2)] = true;
  EXPECT_EQ(cage_from_mesh(mesh, {.holes = "hole"}).holes, std::vector<int>{2});
}

TEST(CageFromMesh, LeavesOutWhatIsDeleted) {
  StatusMesh mesh = mesh_of_cage<StatusMesh>(testing::sheet(3, 1));
  mesh.delete_face(mesh.face_handle(0), true);
  const auto everywhere = [](OpenMesh::EdgeHandle) { return 1.0; };
  const Cage cage = cage_from_mesh(mesh, {.creases = everywhere});
  const Cage sheet = testing::sheet(3, 1);
  ASSERT_EQ(cage.faces.size(), 2u);
  EXPECT_EQ(cage.points.size(), 6u);
  EXPECT_EQ(cage.creases.size(), 7u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(cage.points[static_cast<std::size_t>(cage.faces[0][k])],
              sheet.points[static_cast<std::size_t>(sheet.faces[1][k])]);
  }
  check(cage);
}

TEST(CageFromMesh, NamesPropertiesThatAreMissing) {
  FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::cube());
  OpenMesh::EProp<int> wrong_type(0, mesh, "sharp");
  EXPECT_EQ(fault(mesh, {.creases = "sharp"}),
            "missing property: the mesh has no edge property sharp of double or float");
  EXPECT_EQ(fault(mesh, {.corners = "tip"}),
            "missing property: the mesh has no vertex property tip of double or float");
  EXPECT_EQ(fault(mesh, {.holes = "gap"}),
            "missing property: the mesh has no face property gap of bool, char or int");
}

TEST(CageFromMesh, NamesElementsThatMakeNoSense) {
  FloatMesh mesh = mesh_of_cage<FloatMesh>(testing::cube());
  const auto negative = [](OpenMesh::EdgeHandle eh) { return eh.idx() == 4 ? -1.0 : 0.0; };
  EXPECT_EQ(fault(mesh, {.creases = negative}),
            "invalid input: edge 4 of the mesh: its sharpness is -1.000000, not 0 or more");
  const auto unset = [](OpenMesh::VertexHandle) { return kUnset; };
  EXPECT_EQ(fault(mesh, {.corners = unset}),
            "invalid input: vertex 0 of the mesh: its sharpness is nan, not 0 or more");
  mesh.point(OpenMesh::VertexHandle(2))[1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(fault(mesh), "invalid input: vertex 2 of the mesh: its position is not finite");
  EXPECT_EQ(fault(FloatMesh()), "invalid input: the mesh has no faces");
}

}  // namespace
}  // namespace surfmesh
