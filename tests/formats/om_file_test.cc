// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <string_view>

#include <OpenMesh/Core/System/omstream.hh>
#include <cstring>

#include "formats/example_meshes.hh"
#include "support/errors.hh"
#include "support/folders.hh"
#include "support/notices.hh"
#include "surfmesh/formats/om_file.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

/// True if two meshes have the property and its values are the same bits (NaN equals NaN).
template <class Key>
bool is_same_property(const PolyMesh& a, const PolyMesh& b, const Key& key) {
  const auto& values_a = a.property(require(a, key)).data_vector();
  const auto& values_b = b.property(require(b, key)).data_vector();
  return values_a.size() == values_b.size() &&
         std::memcmp(values_a.data(), values_b.data(), values_a.size() * sizeof(values_a[0])) == 0;
}

bool is_same_connectivity(const PolyMesh& a, const PolyMesh& b) {
  if (a.n_vertices() != b.n_vertices() || a.n_faces() != b.n_faces()) return false;
  if (a.n_halfedges() != b.n_halfedges()) return false;
  for (const HalfedgeHandle heh : a.halfedges()) {
    if (a.to_vertex_handle(heh) != b.to_vertex_handle(heh)) return false;
    if (a.next_halfedge_handle(heh) != b.next_halfedge_handle(heh)) return false;
    if (a.face_handle(heh) != b.face_handle(heh)) return false;
  }
  return true;
}

PolyMesh large_example(int cells = 20) {
  PolyMesh mesh = wavy_grid(cells, 2);
  attach_result_properties(mesh);
  return mesh;
}

void expect_kept(const PolyMesh& mesh) {
  const TestFolder folder;
  write_mesh(mesh, folder / "a.om");
  const PolyMesh read = read_mesh(folder / "a.om").mesh;
  EXPECT_TRUE(is_same_connectivity(mesh, read));
  for (const VertexHandle vh : mesh.vertices()) EXPECT_EQ(mesh.point(vh), read.point(vh));
  EXPECT_TRUE(is_same_property(mesh, read, keys::face_patch));
  EXPECT_TRUE(is_same_property(mesh, read, keys::edge_contour));
  EXPECT_TRUE(is_same_property(mesh, read, keys::corner_uv));
  EXPECT_TRUE(is_same_property(mesh, read, keys::corner_metric));
}

TEST(OmFile, KeepsEverythingToTheLastBit) { expect_kept(large_example()); }

TEST(OmFile, KeepsPropertiesThatAreLargerThanAnyBuffer) { expect_kept(large_example(80)); }

TEST(OmFile, KeepsThePropertiesOfControlMeshes) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(3, 0);
  attach(mesh, keys::vertex_uv, Uv{0.1, -0.0});
  attach(mesh, keys::vertex_size, SizeTensor{1.0 / 3, 0, 2});
  attach(mesh, keys::edge_constrained, char(1));
  write_mesh(mesh, folder / "a.om");
  const PolyMesh read = read_mesh(folder / "a.om").mesh;
  EXPECT_TRUE(is_same_property(mesh, read, keys::vertex_uv));
  EXPECT_TRUE(is_same_property(mesh, read, keys::vertex_size));
  EXPECT_TRUE(is_same_property(mesh, read, keys::edge_constrained));
  EXPECT_FALSE(find(read, keys::face_patch).is_valid());
}

TEST(OmFile, KeepsNormals) {
  const TestFolder folder;
  PolyMesh mesh = large_example();
  attach(mesh, keys::corner_normal, Normal{1.0 / 3, -0.0, 1});
  write_mesh(mesh, folder / "a.om");
  EXPECT_TRUE(is_same_property(mesh, read_mesh(folder / "a.om").mesh, keys::corner_normal));
}

TEST(OmFile, IsTheSameWhenWrittenAgain) {
  const TestFolder folder;
  write_mesh(large_example(), folder / "a.om");
  write_mesh(read_mesh(folder / "a.om").mesh, folder / "b.om");
  EXPECT_EQ(read_text(folder / "a.om"), read_text(folder / "b.om"));
}

const MeshNames kOddNames = {{"", "the wing", std::string(100000, 'x')},
                             {{"all\n", {0, 2}}, {"", {}}}};

TEST(OmFile, KeepsNamesAndGroupsOfPatches) {
  const TestFolder folder;
  const PolyMesh mesh = large_example();
  write_mesh(mesh, folder / "a.om", kOddNames);
  const MeshFile read = read_mesh(folder / "a.om");
  EXPECT_EQ(read.names, kOddNames);
  EXPECT_TRUE(is_same_property(mesh, read.mesh, keys::corner_metric));
  EXPECT_TRUE(texts_of(read.notices).empty());
}

/// Files of before there were names in them, and programs that do not know of these.
TEST(OmFile, DiffersByOneChunkOnlyWhereThereAreNames) {
  const TestFolder folder;
  write_mesh(large_example(), folder / "a.om");
  write_mesh(large_example(), folder / "b.om", kOddNames);
  const std::string bare = read_text(folder / "a.om"), named = read_text(folder / "b.om");
  const std::size_t size = bare.size() - 2;
  EXPECT_EQ(named.substr(0, size), bare.substr(0, size));
  EXPECT_EQ(named.substr(named.size() - 2), bare.substr(size));
  EXPECT_EQ(named.substr(size + 2, 31), "\x0Asurf:names\x13surfmesh::MeshNames");
  EXPECT_EQ(parse_om(bare, "a.om").names, MeshNames());
}

TEST(OmFile, IsRefusedForNamesThatDoNotFit) {
  const TestFolder folder;
  write_mesh(wavy_grid(1, 0), folder / "a.om", {{"x"}, {{"y", {3}}}});
  const std::string bytes = read_text(folder / "a.om");
  const std::size_t value = bytes.find("surfmesh::MeshNames") + 19 + 4;
  for (std::size_t i = value; i + 2 < bytes.size(); ++i) {
    std::string wrong = bytes;
    wrong[i] = '\xff';
    const std::string error = error_of([&] { parse_om(wrong, "b.om"); });
    const bool is_letter = i == value + 8 || i == value + 17;
    const bool is_patch = i >= value + 22 && i < value + 25;
    EXPECT_EQ(error == "no error", is_letter || is_patch) << i - value << ' ' << error;
  }
}

TEST(OmFile, HoldsEmptyMeshesAndSingleVertices) {
  const TestFolder folder;
  PolyMesh mesh;
  write_mesh(mesh, folder / "a.om");
  EXPECT_EQ(read_mesh(folder / "a.om").mesh.n_vertices(), 0u);
  mesh.add_vertex({kUnset, 1, 2});
  write_mesh(mesh, folder / "a.om");
  EXPECT_EQ(read_mesh(folder / "a.om").mesh.n_vertices(), 1u);
}

TEST(OmFile, IsReadAndWrittenInSilence) {
  const TestFolder folder;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  write_mesh(large_example(), folder / "a.om");
  read_mesh(folder / "a.om");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(OmFile, LeavesTheStreamsOfOpenMeshAsTheyWere) {
  const TestFolder folder;
  omerr().disable();
  write_mesh(large_example(), folder / "a.om");
  read_mesh(folder / "a.om");
  EXPECT_TRUE(omlog().is_enabled());
  EXPECT_FALSE(omerr().is_enabled());
  omerr().enable();
}

TEST(OmFile, IsRefusedByItsFaults) {
  const TestFolder folder;
  const std::string path = (folder / "a.om").string();
  EXPECT_EQ(error_of([&] { read_mesh(path); }), "io: cannot read " + path + ": it does not exist");
  write_text(path, "solid");
  EXPECT_EQ(error_of([&] { read_mesh(path); }),
            "invalid input: " + path + ": this is not an .om file of a version that is read");
}

TEST(OmFile, IsRefusedForAPositionThatIsNotFinite) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  const double known = 12345.5, unset = std::numeric_limits<double>::quiet_NaN();
  mesh.point(VertexHandle(2))[0] = known;
  write_mesh(mesh, folder / "a.om");
  std::string bytes = read_text(folder / "a.om");
  const std::size_t at =
      bytes.find(std::string_view(reinterpret_cast<const char*>(&known), sizeof(known)));
  ASSERT_NE(at, std::string::npos);
  std::memcpy(bytes.data() + at, &unset, sizeof(unset));
  const std::string error = error_of([&] { parse_om(bytes, "b.om"); });
  EXPECT_TRUE(error.starts_with("invalid input: b.om: the position of vertex 2 is (nan, "))
      << error;
}

TEST(OmFile, IsRefusedWhereverItIsCut) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach_result_properties(mesh);
  write_mesh(mesh, folder / "a.om");
  const std::string bytes = read_text(folder / "a.om");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(error_of([&] { parse_om(bytes.substr(0, size), "b.om"); }), "no error") << size;
  }
}

TEST(OmFile, NeverBreaksAMeshByOneWrongByte) {
  const TestFolder folder;
  PolyMesh mesh = wavy_grid(1, 0);
  attach_result_properties(mesh);
  write_mesh(mesh, folder / "a.om");
  const std::string bytes = read_text(folder / "a.om");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char flip : {'\x01', '\x10', '\x80', '\xff'}) {
      std::string wrong = bytes;
      wrong[i] = static_cast<char>(wrong[i] ^ flip);
      const std::string error = error_of([&] { parse_om(wrong, "b.om"); });
      EXPECT_TRUE(error == "no error" || error.starts_with("invalid input: ")) << error;
    }
  }
}

/// A chunk of values of vertices.
std::string chunk_of_vertices(std::string_view name, std::string_view type,
                              std::string_view value) {
  std::string chunk = "\xC2";  // custom, of vertices, with a name
  chunk += '\0';
  for (const std::string_view word : {name, type}) {
    chunk += static_cast<char>(word.size());
    chunk += word;
  }
  for (unsigned i = 0; i < 4; ++i) chunk += static_cast<char>(value.size() >> (8 * i) & 255);
  return chunk.append(value);
}

/// OpenMesh took the length of a list as it stands: 4 GB for each vertex.
TEST(OmFile, LeavesOutValuesOfVaryingSizeAndSaysSo) {
  const TestFolder folder;
  const PolyMesh mesh = large_example(3);
  write_mesh(mesh, folder / "a.om");
  const std::string bytes = read_text(folder / "a.om");
  const std::string chunks =
      chunk_of_vertices("list", "std::vector<float>", std::string(400, '\x7f')) +
      chunk_of_vertices("label", "std::string", std::string(3, '\xff'));
  for (const std::size_t at : {bytes.size() - 2, bytes.find("surf:uv") - 3}) {
    const MeshFile file = parse_om(bytes.substr(0, at) + chunks + bytes.substr(at), "b.om");
    EXPECT_TRUE(is_same_connectivity(mesh, file.mesh));
    EXPECT_TRUE(is_same_property(mesh, file.mesh, keys::corner_uv));
    const std::vector<std::string> texts = texts_of(file.notices, Severity::Warning);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_NE(texts[0].find("b.om: the property list (and 1 more) is left out"), std::string::npos)
        << texts[0];
  }
}

/// OpenMesh stops the program at values of elements that come later.
TEST(OmFile, IsRefusedForValuesBeforeTheirElements) {
  const TestFolder folder;
  write_mesh(large_example(3), folder / "a.om");
  const std::string bytes = read_text(folder / "a.om");
  constexpr std::size_t kHeader = 16;
  for (const std::string_view name : {"surf:uv", "surf:contour", "surf:patch"}) {
    const std::size_t at = bytes.find(name) - 3;
    const std::string early =
        bytes.substr(0, kHeader) + bytes.substr(at, bytes.size() - at - 2) + bytes.substr(kHeader);
    EXPECT_NE(error_of([&] { parse_om(early, "b.om"); }).find("damaged"), std::string::npos)
        << name;
  }
}

/// Elements that are made twice are more than there are values.
TEST(OmFile, IsRefusedForElementsThatAreMadeTwice) {
  const TestFolder folder;
  write_mesh(large_example(3), folder / "a.om");
  const std::string bytes = read_text(folder / "a.om");
  constexpr std::size_t kHeader = 16;
  const std::size_t values = bytes.find("surf:patch") - 3;
  const std::string twice = bytes.substr(0, values) + bytes.substr(kHeader);
  EXPECT_NE(error_of([&] { parse_om(twice, "b.om"); }).find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace surfmesh
