// SPDX-License-Identifier: BSD-3-Clause
//
// Normals (vn) and parameters (vt) of the corners in OBJ files.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/meshes.hh"
#include "support/notices.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

using Texts = std::vector<std::string>;

/// A roof: two triangles, each with its own normal, and one (u,v) at the vertices of the ridge.
PolyMesh roof() {
  PolyMesh mesh =
      testing::mesh_of({{0, 0, 1}, {0, 1, 1}, {-1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  testing::attach_plane_properties(mesh);
  const auto normal = attach(mesh, keys::corner_normal);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    if (mesh.is_boundary(heh)) continue;
    mesh.property(normal, heh) = {mesh.face_handle(heh).idx() == 0 ? -0.6 : 0.6, 0, 0.8};
  }
  return mesh;
}

std::string written(const PolyMesh& mesh, const OutputOptions& options) {
  const TestFolder folder;
  write_mesh(mesh, folder / "a.obj", {}, options);
  return read_text(folder / "a.obj");
}

std::string part_of(const std::string& text, const std::string& from) {
  const std::size_t start = text.find(from);
  return start == text.npos ? "" : text.substr(start);
}

std::string after_points(const PolyMesh& mesh, const OutputOptions& options) {
  const std::string text = written(mesh, options);
  return text.substr(text.find("v 1 1 0\n") + 8);
}

TEST(ObjCorners, AreWrittenOnWishOnly) {
  EXPECT_EQ(part_of(written(roof(), {}), "\ng"), "\ng patch0\nf 1 2 3\nf 2 1 4\n");
  EXPECT_EQ(written(roof(), {}).find("vt"), std::string::npos);
}

TEST(ObjCorners, HaveOneLineForEqualValuesAtAVertex) {
  EXPECT_EQ(after_points(roof(), {.uv = true}),
            "vt 0 0\nvt 0 1\nvt -1 0\nvt 1 1\ng patch0\nf 1/1 2/2 3/3\nf 2/2 1/1 4/4\n");
}

TEST(ObjCorners, HaveALineForEachNormalOfAVertex) {
  const std::string normals =
      "vn -0.6 0 0.8\nvn 0.6 0 0.8\nvn 0.6 0 0.8\nvn -0.6 0 0.8\nvn -0.6 0 0.8\nvn 0.6 0 0.8\n";
  EXPECT_EQ(after_points(roof(), {.normals = true}),
            normals + "g patch0\nf 1//1 2//4 3//5\nf 2//3 1//2 4//6\n");
  EXPECT_EQ(after_points(roof(), {.normals = true, .uv = true}),
            "vt 0 0\nvt 0 1\nvt -1 0\nvt 1 1\n" + normals +
                "g patch0\nf 1/1/1 2/2/4 3/3/5\nf 2/2/3 1/1/2 4/4/6\n");
}

/// The numbers of corners lead to the values that the mesh has there.
TEST(ObjCorners, LeadToTheirValues) {
  std::istringstream text(written(roof(), {.normals = true, .uv = true}));
  std::vector<std::array<double, 3>> points, normals;
  std::vector<std::array<double, 2>> uvs;
  int face = -1;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v" || keyword == "vn") {
      auto& p = (keyword == "v" ? points : normals).emplace_back();
      words >> p[0] >> p[1] >> p[2];
    } else if (keyword == "vt") {
      auto& p = uvs.emplace_back();
      words >> p[0] >> p[1];
    } else if (keyword == "f") {
      ++face;
      std::size_t v = 0, t = 0, n = 0;
      for (char slash = 0; words >> v >> slash >> t >> slash >> n;) {
        EXPECT_EQ(uvs.at(t - 1)[0], points.at(v - 1)[0]);
        EXPECT_EQ(uvs.at(t - 1)[1], points.at(v - 1)[1]);
        EXPECT_EQ(normals.at(n - 1)[0], face == 0 ? -0.6 : 0.6);
      }
    }
  }
  EXPECT_EQ(face, 1);
  EXPECT_EQ(uvs.size(), 4u);
  EXPECT_EQ(normals.size(), 6u);
}

TEST(ObjCorners, LeaveTheMeshAsItIsWhenRead) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(9, 2);
  attach_result_properties(mesh);
  attach(mesh, keys::corner_normal, Normal{0, 0, 1});
  write_mesh(mesh, folder / "plain.obj");
  write_mesh(mesh, folder / "a.obj", {}, {.normals = true, .uv = true});
  const MeshFile file = read_mesh(folder / "a.obj");
  EXPECT_TRUE(file.notices.empty());
  EXPECT_EQ(file.unread, (Texts{"normals (vn)", "texture coordinates (vt)"}));
  write_mesh(file.mesh, folder / "b.obj", file.names);
  EXPECT_EQ(read_text(folder / "b.obj"), read_text(folder / "plain.obj"));
  EXPECT_TRUE(read_mesh(folder / "plain.obj").unread.empty());
  EXPECT_EQ(read_cage(folder / "a.obj").faces.size(), mesh.n_faces());
}

TEST(ObjCorners, MustHaveValues) {
  PolyMesh mesh = roof();
  const HalfedgeHandle corner = mesh.halfedge_handle(FaceHandle(1));
  mesh.property(require(mesh, keys::corner_normal), corner) = Normal();
  const std::string place = "geometry: a corner of face 1 at vertex " +
                            std::to_string(mesh.to_vertex_handle(corner).idx()) + " has no finite ";
  EXPECT_EQ(error_of([&] { written(mesh, {.normals = true}); }), place + "surf:normal");
  EXPECT_EQ(error_of([&] { written(mesh, {.uv = true}); }), "no error");
}

TEST(ObjCorners, AreNotLostWhereTheyAreWritten) {
  const PolyMesh mesh = roof();
  const std::string normals = "the normals of the corners";
  const std::string uv = "the parameters (u,v) of the corners";
  const std::string metric = "the metric of the corners";
  EXPECT_EQ(what_is_lost(mesh, "a.obj"), (Texts{normals, uv, metric}));
  EXPECT_EQ(what_is_lost(mesh, "a.obj", {}, {.normals = true}), (Texts{uv, metric}));
  EXPECT_EQ(what_is_lost(mesh, "a.obj", {}, {.normals = true, .uv = true}), Texts{metric});
  EXPECT_EQ(what_is_lost(mesh, "a.ply", {}, {.normals = true, .uv = true}),
            (Texts{normals, uv, metric}));
  EXPECT_EQ(what_is_lost(mesh, "a.om"), Texts());
}

TEST(ObjCorners, AreToldWhereTheyCannotBeWritten) {
  const OutputOptions both = {.normals = true, .uv = true};
  EXPECT_TRUE(unused_options(roof(), "a.obj", both).empty());
  EXPECT_TRUE(unused_options(roof(), "a.om", both).empty());
  EXPECT_TRUE(unused_options(roof(), "a.stl", {}).empty());
  const Notices notices = unused_options(roof(), "a.stl", both);
  EXPECT_EQ(texts_of(notices),
            (Texts{"normals has no effect on a.stl: normals of the corners are written to .obj, "
                   ".glb or .om",
                   "uv has no effect on a.stl: parameters (u,v) of the corners are written to "
                   ".obj, .glb or .om"}));
  EXPECT_EQ(notices.front().kind, NoticeKind::UnusedOption);
  EXPECT_EQ(texts_of(unused_options(wavy_grid(1, 0), "a.obj", both)),
            (Texts{"normals has no effect: the mesh has no normals of the corners",
                   "uv has no effect: the mesh has no parameters (u,v) of the corners"}));
}

}  // namespace
}  // namespace surfmesh
