// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/carry.hh"

#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <functional>
#include <set>

#include "cage/cages.hh"
#include "support/errors.hh"
#include "surfmesh/assemble/carry_texture.hh"
#include "surfmesh/cage/cage_from_mesh.hh"
#include "surfmesh/cage/cage_model.hh"
#include "surfmesh/model/append_model.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh {
namespace {

using DoubleMesh = OpenMesh::PolyMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using Colour = std::array<unsigned char, 3>;
using PlainTriMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// A mesh of the faces of a cage.
template <class Mesh>
Mesh mesh_of(const Cage& cage) {
  Mesh mesh;
  std::vector<OpenMesh::VertexHandle> vertices;
  for (const Vec3& p : cage.points) {
    vertices.push_back(mesh.add_vertex(typename Mesh::Point(
        static_cast<typename Mesh::Scalar>(p.x()), static_cast<typename Mesh::Scalar>(p.y()),
        static_cast<typename Mesh::Scalar>(p.z()))));
  }
  for (const std::vector<int>& face : cage.faces) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const int v : face) corners.push_back(vertices[static_cast<std::size_t>(v)]);
    mesh.add_face(corners);
  }
  return mesh;
}

/// An evenly spaced plane of triangles or quads: its limit surface is the plane, and values that
/// are linear there are linear in (u,v).
Cage plane(bool has_triangles, int m = 5, int n = 4) {
  Cage cage = has_triangles ? testing::triangle_sheet(m, n) : testing::sheet(m, n);
  for (Vec3& point : cage.points) point.z() = 0.5 * point.x();
  cage.boundary = BoundaryRule::EdgeAndCorner;
  return cage;
}

Cage cage_of(const DoubleMesh& mesh) {
  return cage_from_mesh(mesh, {.boundary = BoundaryRule::EdgeAndCorner});
}

PipelineOptions with_size(double size) {
  PipelineOptions options;
  options.sizing.size = Length::units(size);
  return options;
}

double distance(const OpenMesh::Vec3d& a, const OpenMesh::Vec3d& b) { return (a - b).norm(); }

/// The values of a result are the points where they are, where that `counts`.
void expect_points(const DoubleMesh& mesh, const Model& model, const PipelineOptions& options,
                   double tolerance, const std::function<bool(const OpenMesh::Vec3d&)>& counts) {
  DoubleMesh source = mesh;
  OpenMesh::VProp<OpenMesh::Vec3d> at_vertices(source, "place");
  OpenMesh::HProp<OpenMesh::Vec3d> at_corners(source, "corner place");
  for (const auto vh : source.vertices()) at_vertices[vh] = source.point(vh);
  for (const auto heh : source.halfedges()) at_corners[heh] = source.point(heh.to());
  MeshResult result = mesh_model(model, {}, options);
  PropertyCarrier carrier(source, model, result.mesh);
  EXPECT_EQ(carrier.vertices<OpenMesh::Vec3d>("place"), 0u);
  EXPECT_EQ(carrier.corners<OpenMesh::Vec3d>("corner place"), 0u);
  OpenMesh::VProp<OpenMesh::Vec3d> vertices(result.mesh, "place");
  OpenMesh::HProp<OpenMesh::Vec3d> corners(result.mesh, "corner place");
  double greatest = 0;
  for (const auto vh : result.mesh.vertices()) {
    if (!counts(result.mesh.point(vh))) continue;
    greatest = std::max(greatest, distance(vertices[vh], result.mesh.point(vh)));
    for (const auto heh : vh.incoming_halfedges()) {
      if (heh.is_boundary()) continue;
      greatest = std::max(greatest, distance(corners[heh], result.mesh.point(vh)));
    }
  }
  EXPECT_LE(greatest, tolerance);
}

void expect_points(const DoubleMesh& mesh, const Model& model, const PipelineOptions& options,
                   double tolerance) {
  expect_points(mesh, model, options, tolerance, [](const OpenMesh::Vec3d&) { return true; });
}

TEST(Carry, IsExactForWhatIsBilinear) {
  for (const Cage& cage : {testing::cube(), testing::pentagon_prism(), testing::sheet()}) {
    const auto mesh = mesh_of<DoubleMesh>(cage);
    const Model model = model_from_cage(cage_of(mesh), {.scheme = Scheme::Bilinear});
    expect_points(mesh, model, with_size(0.3), 1e-12);
  }
}

TEST(Carry, IsExactForLinearValuesOnBlocks) {
  const auto mesh = mesh_of<DoubleMesh>(plane(false));
  const Model model = model_from_cage(cage_of(mesh));
  ASSERT_EQ(model.patches.size(), 1u);
  expect_points(mesh, model, with_size(0.4), 1e-12);
}

/// Where the corners of the plane are rounded, values are not linear.
TEST(Carry, FindsCornersBeyondThePatchOfTheirFace) {
  const auto mesh = mesh_of<DoubleMesh>(plane(true, 10, 8));
  const Model model = model_from_cage(cage_of(mesh));
  for (const double size : {0.3, 0.6, 0.9}) {
    const PipelineOptions options = with_size(size);
    const MeshResult result = mesh_model(model, {}, options);
    const auto beyond = find(result.mesh, keys::corner_beyond);
    ASSERT_TRUE(beyond.is_valid());
    const auto& is_beyond = result.mesh.property(beyond).data_vector();
    ASSERT_GT(std::count(is_beyond.begin(), is_beyond.end(), 1), 20);
    expect_points(mesh, model, options, 1e-9, [](const OpenMesh::Vec3d& point) {
      return point[0] > 2 && point[0] < 8 && point[1] > 2 && point[1] < 6;
    });
  }
}

/// Each face of the cube has a number of its own at its corners.
TEST(Carry, KeepsSeamsAlongContours) {
  auto mesh = mesh_of<DoubleMesh>(testing::cube());
  OpenMesh::HProp<float> number(mesh, "number");
  for (const auto heh : mesh.halfedges()) number[heh] = static_cast<float>(heh.face().idx());
  const Model model = model_from_cage(cage_from_mesh(mesh), {.scheme = Scheme::Bilinear});
  MeshResult result = mesh_model(model, {}, with_size(0.5));
  EXPECT_EQ(PropertyCarrier(mesh, model, result.mesh).corners<float>("number"), 0u);
  OpenMesh::HProp<float> carried(result.mesh, "number");
  const auto patch_of = require(result.mesh, keys::face_patch);
  for (const auto face : result.mesh.faces()) {
    const auto patch = static_cast<std::size_t>(result.mesh.property(patch_of, face));
    for (const auto heh : face.halfedges()) {
      EXPECT_EQ(carried[heh], static_cast<float>(model.patches[patch].cage_faces.front()));
    }
  }
}

TEST(Carry, TakesLabelsOfTheNearestCorner) {
  auto mesh = mesh_of<PlainTriMesh>(testing::icosahedron());
  OpenMesh::VProp<int> label(mesh, "label");
  OpenMesh::VProp<Colour> colour(mesh, "colour");
  for (const auto vh : mesh.vertices()) {
    label[vh] = 100 + vh.idx();
    colour[vh] = {static_cast<unsigned char>(vh.idx()), 0, 9};
  }
  const Model model = model_from_cage(cage_from_mesh(mesh), {.scheme = Scheme::Bilinear});
  MeshResult result = mesh_model(model, {}, with_size(0.3));
  PropertyCarrier carrier(mesh, model, result.mesh);
  EXPECT_EQ(carrier.vertices<int>("label") + carrier.vertices<Colour>("colour"), 0u);
  OpenMesh::VProp<int> carried(result.mesh, "label");
  OpenMesh::VProp<Colour> colours(result.mesh, "colour");
  std::set<int> seen;
  for (const auto vh : result.mesh.vertices()) {
    seen.insert(carried[vh]);
    ASSERT_EQ(carried[vh], 100 + colours[vh][0]);
    const auto p = mesh.point(OpenMesh::VertexHandle(carried[vh] - 100));
    const double own = distance(OpenMesh::Vec3d(p[0], p[1], p[2]), result.mesh.point(vh));
    for (const auto other : mesh.vertices()) {
      const auto q = mesh.point(other);
      EXPECT_GE(distance(OpenMesh::Vec3d(q[0], q[1], q[2]), result.mesh.point(vh)), own - 0.1);
    }
  }
  EXPECT_EQ(seen.size(), mesh.n_vertices());
}

TEST(Carry, FindsOpenMeshsOwnTextureCoordinates) {
  auto mesh = mesh_of<PlainTriMesh>(testing::octahedron());
  mesh.request_halfedge_texcoords2D();
  for (const auto heh : mesh.halfedges()) {
    mesh.set_texcoord2D(heh, OpenMesh::Vec2f(mesh.point(heh.to())[0], mesh.point(heh.to())[1]));
  }
  const Model model = model_from_cage(cage_from_mesh(mesh), {.scheme = Scheme::Bilinear});
  MeshResult result = mesh_model(model, {}, with_size(0.4));
  result.mesh.request_halfedge_texcoords2D();
  const std::string name = mesh.property(mesh.halfedge_texcoords2D_pph()).name();
  EXPECT_EQ(PropertyCarrier(mesh, model, result.mesh).corners<OpenMesh::Vec2f>(name), 0u);
  for (const auto heh : result.mesh.halfedges()) {
    const auto& p = result.mesh.point(heh.to());
    EXPECT_NEAR(result.mesh.texcoord2D(heh)[0], p[0], 1e-6);
    EXPECT_NEAR(result.mesh.texcoord2D(heh)[1], p[1], 1e-6);
  }
}

TEST(Carry, CountsElementsThatAreDeletedAsTheCageDoes) {
  auto mesh = mesh_of<DoubleMesh>(testing::cube());
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  const auto extra = mesh.add_vertex({5, 5, 5});
  const auto face = mesh.add_face(mesh.add_vertex({7, 5, 5}), mesh.add_vertex({5, 7, 5}), extra);
  mesh.delete_face(face);
  mesh.delete_face(OpenMesh::FaceHandle(0));
  const Model model = model_from_cage(cage_from_mesh(mesh), {.scheme = Scheme::Bilinear});
  expect_points(mesh, model, with_size(0.5), 1e-12);
}

TEST(Carry, TellsWhatIsNotOnTheCage) {
  auto mesh = mesh_of<DoubleMesh>(testing::cube());
  OpenMesh::VProp<double> one(mesh, "one");
  OpenMesh::VProp<OpenMesh::Vec3d> way(mesh, "way");
  for (const auto vh : mesh.vertices()) {
    one[vh] = 1;
    way[vh] = {0, 0, 1};
  }
  Model model = model_from_cage(cage_from_mesh(mesh), {.scheme = Scheme::Bilinear});
  Cage other = testing::cube();
  for (Vec3& point : other.points) point.x() += 10;
  append(model, model_from_cage(other), "other:");
  MeshResult result = mesh_model(model, {}, with_size(1));
  EXPECT_EQ(error_of([&] { PropertyCarrier(mesh, model, result.mesh); }),
            "invalid input: the model has several cages: tell which one the mesh is");
  PropertyCarrier carrier(mesh, model, result.mesh, model.patches[0].cage.get());
  const std::size_t missing = carrier.vertices<double>("one");
  OpenMesh::VProp<double> carried(result.mesh, "one");
  std::size_t zeros = 0;
  for (const auto vh : result.mesh.vertices()) {
    EXPECT_DOUBLE_EQ(carried[vh], result.mesh.point(vh)[0] < 5 ? 1 : 0);
    zeros += carried[vh] == 0;
  }
  EXPECT_EQ(missing, zeros);
  EXPECT_EQ(carrier.vertices<OpenMesh::Vec3d>("way"), zeros);
  OpenMesh::VProp<OpenMesh::Vec3d> ways(result.mesh, "way");
  for (const auto vh : result.mesh.vertices()) {
    EXPECT_EQ(ways[vh], OpenMesh::Vec3d(0, 0, carried[vh]));
  }
  EXPECT_GT(zeros, 0u);
}

TEST(Carry, ChecksItsInput) {
  const auto mesh = mesh_of<DoubleMesh>(testing::cube());
  const auto other = mesh_of<DoubleMesh>(testing::octahedron());
  Model model = model_from_cage(cage_from_mesh(mesh));
  MeshResult result = mesh_model(model, {}, with_size(1));
  EXPECT_EQ(error_of([&] { PropertyCarrier(other, model, result.mesh); }),
            "invalid input: the mesh is not the one that the cage was made of");
  PropertyCarrier carrier(mesh, model, result.mesh);
  EXPECT_EQ(error_of([&] { carrier.vertices<double>("heat"); }),
            "missing property: the mesh has no vertex property heat of this type");
  EXPECT_EQ(error_of([&] { carrier.corners<int>("side"); }),
            "missing property: the mesh has no halfedge property side of this type");
  for (Patch& patch : model.patches) patch.cage = nullptr;
  EXPECT_EQ(error_of([&] { PropertyCarrier(mesh, model, result.mesh); }),
            "invalid input: the model has no cage");
}

/// The cube with a square of its own in the texture for each face but the last one.
Cage cube_with_texture() {
  Cage cage = testing::cube();
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    std::vector<int>& corners = cage.texture.faces.emplace_back();
    for (int i = 0; i < 4; ++i) {
      corners.push_back(f < 5 ? static_cast<int>(cage.texture.points.size()) : -1);
      if (f < 5) {
        cage.texture.points.push_back(Uv{2 * static_cast<double>(f), 0} + Domain().corner(i));
      }
    }
  }
  return cage;
}

TEST(CarryTexture, IsThatOfTheFaceOfTheCage) {
  const Model model = model_from_cage(cube_with_texture(), {.scheme = Scheme::Bilinear});
  MeshResult result = mesh_model(model, {}, with_size(0.5));
  const std::size_t count = carry_texture(model, result.mesh);
  const auto texture_of = require(result.mesh, keys::corner_texture);
  const auto uv_of = require(result.mesh, keys::corner_uv);
  const auto patch_of = require(result.mesh, keys::face_patch);
  std::size_t with_texture = 0;
  for (const auto face : result.mesh.faces()) {
    const int patch = result.mesh.property(patch_of, face);
    const int of_cage = model.patch(patch).cage_faces.front();
    with_texture += of_cage < 5;
    for (const auto heh : face.halfedges()) {
      const Uv texture = result.mesh.property(texture_of, heh);
      if (of_cage == 5) {
        EXPECT_TRUE(std::isnan(texture.u));
        continue;
      }
      const Uv uv = result.mesh.property(uv_of, heh);
      EXPECT_NEAR(texture.u, 2 * of_cage + uv.u, 1e-12);
      EXPECT_NEAR(texture.v, uv.v, 1e-12);
    }
  }
  EXPECT_EQ(count, with_texture);
}

TEST(CarryTexture, IsNoneWhereTheCageHasNone) {
  const Model model = model_from_cage(testing::cube());
  MeshResult result = mesh_model(model, {}, with_size(1));
  EXPECT_EQ(carry_texture(model, result.mesh), 0u);
  EXPECT_FALSE(find(result.mesh, keys::corner_texture).is_valid());
}

}  // namespace
}  // namespace surfmesh
