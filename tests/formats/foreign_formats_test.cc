// SPDX-License-Identifier: BSD-3-Clause
//
// Whether other programs read the formats of viewers and solvers as they are meant: positions to
// the last bit (or digit), faces, patches, names and values are compared. Programs as in
// foreign_readers_test.cc, and calculix-ccx.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "formats/foreign_programs.hh"
#include "formats/named_example.hh"
#include "support/folders.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/option_range.hh"
#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

/// Defines compare(): faces as their points from the least one on, with their patches, must be
/// those of want.json, in any order.
constexpr const char* kCompare = R"(
import json, numpy
want = json.load(open("want.json"))
def as_single(x): return float(numpy.float32(x))
def face(points, ids, patch, rounded):
    p = [tuple(rounded(x) for x in points[i]) for i in ids]
    k = p.index(min(p))
    return (p[k:] + p[:k], patch)
def compare(name, points, faces, patches, rounded=float, wanted=want):
    faces, patches = list(faces), list(patches)
    assert len(faces) == len(patches), (len(faces), len(patches))
    got = sorted(face(points, f, int(p), rounded) for f, p in zip(faces, patches))
    right = sorted(face(wanted["points"], f, p, rounded)
                   for f, p in zip(wanted["faces"], wanted["patches"]))
    word = "same" if got == right else ("differ", got[:1], right[:1])
    print(name, len(points), len(faces), word)
def lines(points, pairs): return sorted(sorted(tuple(points[i]) for i in pair) for pair in pairs)
def nearest(points, bound):
    def distance(p, q): return sum((a - b) ** 2 for a, b in zip(p, q))
    near = [min(want["points"], key=lambda q: distance(p, q)) for p in points]
    print(max(abs(a - b) for p, q in zip(points, near) for a, b in zip(p, q)) < bound)
    return near
def compare_lines(name, points, pairs, contour):
    right = lines(want["points"], want["contours"][contour])
    print(name, len(pairs), lines(points, pairs) == right)
)";

/// Every number of corners, and how its example is made.
struct Corners {
  const char* name;
  int quad_every;
  int faces;
};

void PrintTo(const Corners& corners, std::ostream* out) { *out << corners.name; }

class ForeignFormat : public ::testing::TestWithParam<Corners> {
 protected:
  ForeignFormat() : mesh_(named_example(GetParam().quad_every)) {
    const MeshArrays arrays = mesh_arrays(mesh_);
    std::string points, faces, patches, contours[2];
    for (const Vec3& p : arrays.points) {
      points += fmt::format("{}[{},{},{}]", points.empty() ? "" : ",", p.x(), p.y(), p.z());
    }
    for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
      std::string face;
      for (const int v : arrays.faces[f]) face += fmt::format("{}{}", face.empty() ? "" : ",", v);
      faces += fmt::format("{}[{}]", faces.empty() ? "" : ",", face);
      patches += fmt::format("{}{}", patches.empty() ? "" : ",", arrays.patches[f]);
    }
    const auto contour_of = find(mesh_, keys::edge_contour);
    for (const EdgeHandle eh : mesh_.edges()) {
      if (mesh_.property(contour_of, eh) < 0) continue;
      std::string& text = contours[mesh_.property(contour_of, eh)];
      const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
      text += fmt::format("{}[{},{}]", text.empty() ? "" : ",", mesh_.from_vertex_handle(heh).idx(),
                          mesh_.to_vertex_handle(heh).idx());
    }
    write_text(
        folder_ / "want.json",
        fmt::format("{{\"points\":[{}],\"faces\":[{}],\"patches\":[{}],\"contours\":[[{}],[{}]"
                    "]}}",
                    points, faces, patches, contours[0], contours[1]));
  }

  void write(const std::string& name, const OutputOptions& options = {}) const {
    write_mesh(mesh_, folder_ / name, example_names(), options);
  }

  /// What a program prints, after kCompare.
  std::string printed(const std::string& program) {
    write_text(folder_ / "read.py", std::string(kCompare) + program);
    const std::string line = fmt::format("cd '{}' && PYTHONIOENCODING=utf-8 {} read.py >out 2>err",
                                         folder_.path().string(), kPython);
    EXPECT_EQ(std::system(line.c_str()), 0) << read_text(folder_ / "err");
    return read_text(folder_ / "out");
  }

  /// What compare() prints where all is right.
  std::string same(const std::string& name) const {
    return fmt::format("{} 25 {} same\n", name, GetParam().faces);
  }

  TestFolder folder_;
  PolyMesh mesh_;
};

constexpr const char* kVtk = R"(
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
for Reader, name in [(vtkXMLUnstructuredGridReader, "a.vtu"), (vtkUnstructuredGridReader, "a.vtk")]:
    reader = Reader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    def corners(c): return [c.GetPointId(k) for k in range(c.GetNumberOfPoints())]
    faces = [corners(grid.GetCell(i)) for i in range(grid.GetNumberOfCells())]
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    data, at = grid.GetCellData(), grid.GetPointData()
    patch = [int(data.GetArray("patch").GetValue(i)) for i in range(len(faces))]
    compare(name, points, faces, patch)
    print([data.GetArrayName(i) for i in range(data.GetNumberOfArrays())])
    print([at.GetArrayName(i) for i in range(at.GetNumberOfArrays())])
    whole = grid.GetFieldData()
    for i in range(whole.GetNumberOfArrays()):
        array = whole.GetArray(i)
        print(array.GetName(), [int(array.GetValue(k)) for k in range(array.GetNumberOfTuples())])
    u, contour = at.GetArray("u"), at.GetArray("contour")
    right = [u.GetValue(i) == p[0] for i, p in enumerate(points) if p[1] < 0.28]
    print(len(right), all(right), sum(u.GetValue(i) != u.GetValue(i) for i in range(len(points))))
    print(sum(int(contour.GetValue(i)) == 0 for i in range(len(points))))
    size = [data.GetArray("size").GetValue(i) for i in range(len(faces))]
    groups = set(data.GetArray("group").GetValue(i) for i in range(len(faces)))
    print(all(abs(s - 0.25) < 1e-9 for s in size), groups)
)";

TEST_P(ForeignFormat, VtkReadsVtuAndVtk) {
  if (!has_module("vtkmodules.vtkIOXML")) GTEST_SKIP() << "no VTK here";
  write("a.vtu");
  write("a.vtk");
  const std::string text =
      "['patch', 'group', 'quality', 'shape', 'size', 'stretch', 'length', 'u', 'v']\n"
      "['valence', 'u', 'v', 'contour']\n"
      "patch:left \"wing\" \xC3\xBC [0]\n"
      "group:all of it [0, 1]\n"
      "group:it's one [0]\n"
      "contour:the rim [1]\n"
      // The line in the middle has two u's but where x = y there.
      "10 True 5\n5\nTrue {0}\n";
  EXPECT_EQ(printed(kVtk), same("a.vtu") + text + same("a.vtk") + text);
}

constexpr const char* kMeshioVtk = R"(
import meshio
for name in ["a.vtu", "a.vtk"]:
    mesh = meshio.read(name)
    faces = [list(f) for block in mesh.cells for f in block.data]
    patches = [p for part in mesh.cell_data["patch"] for p in numpy.ravel(part)]
    compare(name, mesh.points, faces, patches)
)";

TEST_P(ForeignFormat, MeshioReadsVtuAndVtk) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  write("a.vtu");
  write("a.vtk");
  EXPECT_EQ(printed(kMeshioVtk), same("a.vtu") + same("a.vtk"));
}

constexpr const char* kGmsh = R"(
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open("a.msh")
tags, coordinates, _ = gmsh.model.mesh.getNodes()
place = {int(t): i for i, t in enumerate(tags)}
points = coordinates.reshape(-1, 3)
def elements(dim, tag):
    corners = {1: 2, 2: 3, 3: 4}
    for kind, _, nodes in zip(*gmsh.model.mesh.getElements(dim, tag)):
        for element in nodes.reshape(-1, corners[kind]): yield [place[int(n)] for n in element]
faces = [(f, tag - 1) for _, tag in gmsh.model.getEntities(2) for f in elements(2, tag)]
compare("a.msh", points, [f for f, _ in faces], [p for _, p in faces])
for dim, tag in gmsh.model.getEntities(1):
    compare_lines(tag, points, list(elements(1, tag)), tag - 1)
for dim, tag in gmsh.model.getPhysicalGroups():
    if gmsh.model.getPhysicalName(dim, tag): print(dim, gmsh.model.getPhysicalName(dim, tag),
          [int(t) for t in gmsh.model.getEntitiesForPhysicalGroup(dim, tag)])
nodes = [len(gmsh.model.mesh.getNodes(d, t)[0]) for d, t in gmsh.model.getEntities()]
_, at, values, _, parts = gmsh.view.getModelData(gmsh.view.getTags()[0], 0)
print(len(values), parts, all(abs(v[0] - 0.25) < 1e-9 for v in values))
)";

TEST_P(ForeignFormat, GmshReadsAllVersionsOfMsh) {
  if (!has_module("gmsh")) GTEST_SKIP() << "no module gmsh here";
  for (const OptionWord& word : ranges::kMsh.words) {
    const auto version = static_cast<MshVersion>(word.value);
    const bool is_old = word.word.front() == '2';
    write("a.msh", {.msh = version});
    const std::string names =
        is_old ? "1 the rim [2]\n2 all of it [1, 2]\n"
               : "1 the rim [2]\n2 left 'wing' \xC3\xBC [1]\n2 all of it [1, 2]\n2 it's one [1]\n";
    EXPECT_EQ(printed(kGmsh), same("a.msh") + "1 4 True\n2 16 True\n" + names + "25 1 True\n")
        << word.word;
  }
}

constexpr const char* kMeshioMsh = R"(
import meshio
mesh = meshio.read("a.msh")
tags = zip(mesh.cells, mesh.cell_data["gmsh:geometrical"])
patches = [p - 1 for b, part in tags if b.type != "line" for p in part]
faces = [list(f) for b in mesh.cells if b.type != "line" for f in b.data]
compare("a.msh", mesh.points, faces, patches)
print(sorted(mesh.field_data), len(mesh.point_data["size"]))
)";

TEST_P(ForeignFormat, MeshioReadsAllVersionsOfMsh) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  for (const OptionWord& word : ranges::kMsh.words) {
    write("a.msh", {.msh = static_cast<MshVersion>(word.value)});
    const std::string names =
        word.word.front() == '2'
            ? "['all of it', 'the rim'] 25\n"
            : "['all of it', \"it's one\", \"left 'wing' \xC3\xBC\", 'the rim'] 25\n";
    EXPECT_EQ(printed(kMeshioMsh), fmt::format("\n{}{}", same("a.msh"), names)) << word.word;
  }
}

constexpr const char* kMeshioMedit = R"(
import meshio
for name in ["a.mesh", "a.meshb"]:
    mesh = meshio.read(name)
    faces, patches = [], []
    for block, references in zip(mesh.cells, mesh.cell_data["medit:ref"]):
        if block.type == "line":
            for c in (0, 1): compare_lines(c, mesh.points, block.data[references == c + 1], c)
        else:
            faces += [list(f) for f in block.data]
            patches += [r - 1 for r in references]
    compare(name, mesh.points, faces, patches)
text = open("a.mesh", encoding="utf-8").read()
print([line for line in text.splitlines() if line.startswith("#")])
def section(name): return text.split("\n" + name + "\n")[1].split()
print(section("Corners")[0], "Ridges" in text)
sol = open("a.sol").read().split()
values = numpy.array([float(x) for x in sol[8:-1]]).reshape(-1, 6)
print(sol[:8], sol[-1], len(values))
print(numpy.allclose(values, [16, 0, 16, 0, 0, 16], atol=1e-5))
binary = numpy.frombuffer(open("a.solb", "rb").read()[40:-8])
print((binary.reshape(-1, 6) == values).all())
)";

TEST_P(ForeignFormat, MeshioReadsMeditFilesWithTheirMetric) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  write("a.mesh");
  write("a.meshb");
  const std::string contours = "0 4 True\n1 16 True\n";
  EXPECT_EQ(
      printed(kMeshioMedit),
      contours + same("a.mesh") + contours + same("a.meshb") +
          "['# patch 1 left \"wing\" \xC3\xBC', '# group 1 2: all of it', \"# group 1: it's one\", "
          "'# contour 2 the rim']\n"
          "2 False\n"
          "['MeshVersionFormatted', '2', 'Dimension', '3', 'SolAtVertices', '25', '1', '3'] "
          "End 25\nTrue\nTrue\n");
}

constexpr const char* kGlb = R"(
import struct
raw = open("a.glb", "rb").read()
magic, version, size, json_size, kind = struct.unpack_from("<4sIII4s", raw)
print(magic, version, size == len(raw), kind, json_size % 4)
tree = json.loads(raw[20:20 + json_size])
numbers = raw[28 + json_size:]
assert struct.unpack_from("<I4s", raw, 20 + json_size) == (len(numbers), b"BIN\0")
assert tree["buffers"][0]["byteLength"] == len(numbers)
def array(index):
    a = tree["accessors"][index]
    view = tree["bufferViews"][a["bufferView"]]
    columns = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[a["type"]]
    kind = {5126: numpy.float32, 5125: numpy.uint32}[a["componentType"]]
    return numpy.frombuffer(numbers, kind, a["count"] * columns,
                            view["byteOffset"] + a.get("byteOffset", 0)).reshape(-1, columns)
faces, patches = [], []
mesh = tree["meshes"][0]
for primitive in mesh["primitives"]:
    at = primitive["attributes"]
    points, normals = array(at["POSITION"]), array(at["NORMAL"])
    material = tree["materials"][primitive["material"]]
    print(material["name"], material["extras"])
    triangles = array(primitive["indices"]).reshape(-1, 3)
    faces += [list(t) for t in triangles]
    patches += [material["extras"]["patch"]] * len(triangles)
print(mesh["name"], tree["nodes"][0]["name"], len(points), len(normals))
print(numpy.allclose(normals, [0, 0, 1], atol=1e-6))
a = tree["accessors"][0]
print(a["min"] == points.min(0).tolist(), a["max"] == points.max(0).tolist())
split = {"points": want["points"], "faces": [], "patches": []}
for f, p in zip(want["faces"], want["patches"]):
    if len(f) == 3: parts = [f]
    else:
        q = numpy.array([want["points"][i] for i in f])
        if ((q[1] - q[3]) ** 2).sum() < ((q[0] - q[2]) ** 2).sum():
            parts = [[f[0], f[1], f[3]], [f[1], f[2], f[3]]]
        else:
            parts = [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]
    split["faces"] += parts
    split["patches"] += [p] * len(parts)
compare("a.glb", points, faces, patches, as_single, split)
if "TEXCOORD_0" in at: print(array(at["TEXCOORD_0"])[:, 0].max() == as_single(4 / 3))
)";

TEST_P(ForeignFormat, GlbHoldsTrianglesNormalsAndNames) {
  if (!has_module("numpy")) GTEST_SKIP() << "no numpy here";
  const std::string head =
      "b'glTF' 2 True b'JSON' 0\n"
      "left \"wing\" \xC3\xBC {'patch': 0, 'groups': ['all of it', \"it's one\"]}\n"
      "patch1 {'patch': 1, 'groups': ['all of it']}\n";
  // On a plane all normals are nearly equal, but those of either side of a contour differ; (u,v)
  // differ there as well, but where u = v.
  write("a.glb", {.uv = true});
  EXPECT_EQ(printed(kGlb), head + "a a 30 30\nTrue\nTrue True\na.glb 30 32 same\nTrue\n");
}

constexpr const char* kVtkGlb = R"(
from vtkmodules.vtkIOGeometry import vtkGLTFReader
reader = vtkGLTFReader()
reader.SetFileName("a.glb")
reader.Update()
found = reader.GetOutput().NewIterator()
faces = 0
while not found.IsDoneWithTraversal():
    faces += found.GetCurrentDataObject().GetNumberOfPolys()
    found.GoToNextItem()
print(faces)
)";

TEST_P(ForeignFormat, VtkReadsGlb) {
  if (!has_module("vtkmodules.vtkIOGeometry")) GTEST_SKIP() << "no VTK here";
  write("a.glb");
  EXPECT_EQ(printed(kVtkGlb), "32\n");
}

constexpr const char* kMeshioInp = R"(
import meshio
mesh = meshio.read("a.inp")
faces, patches = [], []
sets = mesh.cell_sets
names = {"left__wing___": 0, "PATCH_2": 1}
for i, block in enumerate(mesh.cells):
    of_face = {}
    for name, patch in names.items():
        for f in (sets[name][i] if i < len(sets[name]) else []): of_face[int(f)] = patch
    for f, corners in enumerate(block.data):
        faces.append(list(corners))
        patches.append(of_face[f])
compare("a.inp", nearest(mesh.points, 1e-23), faces, patches)
print(sorted(sets), sorted(mesh.point_sets), len(mesh.point_sets["the_rim"]))
text = open("a.inp", encoding="utf-8").read()
print([line for line in text.splitlines() if line.startswith("**")])
)";

TEST_P(ForeignFormat, MeshioReadsInp) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  // meshio does not read sets of sets: without groups.
  MeshNames names = example_names();
  names.groups.clear();
  write_mesh(mesh_, folder_ / "a.inp", names);
  EXPECT_EQ(printed(kMeshioInp),
            fmt::format("True\n{}", same("a.inp")) +
                "['PATCH_2', 'SURFACE', 'left__wing___'] ['the_rim'] 16\n"
                "['** patch left__wing___: left \"wing\" \xC3\xBC', '** patch PATCH_2: PATCH_2', "
                "'** contour the_rim: the rim']\n");
}

/// An analysis that includes the file: its rim is clamped, and each set is used.
constexpr const char* kAnalysis = R"(*INCLUDE, INPUT=a.inp
*MATERIAL, NAME=STEEL
*ELASTIC
210000, 0.3
*SHELL SECTION, ELSET=SURFACE, MATERIAL=STEEL
0.01
*BOUNDARY
the_rim, 1, 6
*STEP
*STATIC
*DLOAD
all_of_it, P, 1.0
it_s_one, P, 1.0
*EL PRINT, ELSET=it_s_one, TOTALS=ONLY
EVOL
*EL PRINT, ELSET=all_of_it, TOTALS=ONLY
EVOL
*END STEP
)";

TEST_P(ForeignFormat, CalculixRunsAnAnalysisOfInp) {
  if (std::system("command -v ccx >/dev/null 2>&1") != 0) GTEST_SKIP() << "no CalculiX here";
  write("a.inp");
  write_text(folder_ / "job.inp", kAnalysis);
  const std::string line =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 ccx job >out 2>&1", folder_.path().string());
  ASSERT_EQ(std::system(line.c_str()), 0) << read_text(folder_ / "out");
  const std::string out = read_text(folder_ / "out");
  EXPECT_NE(out.find("Job finished"), std::string::npos) << out;
  EXPECT_EQ(out.find("*ERROR"), std::string::npos) << out;
  const std::string totals = read_text(folder_ / "job.dat");
  EXPECT_NE(totals.find("IT_S_ONE"), std::string::npos) << totals;
  // Plates of (4/3) × (2/7) and (4/3) × (4/7), times the thickness.
  EXPECT_NE(totals.find("3.809"), std::string::npos) << totals;
  EXPECT_NE(totals.find("7.619"), std::string::npos) << totals;
}

constexpr const char* kMeshioBdf = R"(
import meshio
mesh = meshio.read("a.bdf")
faces = [list(f) for block in mesh.cells for f in block.data]
patches = [p - 1 for part in mesh.cell_data["nastran:ref"] for p in part]
compare("a.bdf", nearest(mesh.points, 4e-15), faces, patches)
head = open("a.bdf", encoding="utf-8").read().split("GRID*")[0]
print(head)
)";

TEST_P(ForeignFormat, MeshioReadsBdf) {
  if (!has_module("meshio")) GTEST_SKIP() << "no meshio here";
  write("a.bdf");
  const int in_first = GetParam().faces / 2;
  EXPECT_EQ(printed(kMeshioBdf),
            fmt::format("True\n{}", same("a.bdf")) +
                fmt::format("$ surfmesh\nSOL 101\nCEND\n"
                            "$HMSET        1        2 \"all of it\"\n"
                            "SET 1 = 1 THRU {},{} THRU {}\n"
                            "$HMSET        2        2 \"it's one\"\n"
                            "SET 2 = 1 THRU {}\n"
                            "$HMSET        3        1 \"the rim\"\n"
                            "SET 3 = 1,2,3,4,5,6,10,11,15,16,20,21,22,23,24,25\n"
                            "BEGIN BULK\n"
                            "$HMNAME COMP                   1\"left 'wing' \xC3\xBC\"\n\n",
                            in_first, in_first + 1, GetParam().faces, in_first));
}

INSTANTIATE_TEST_SUITE_P(Of, ForeignFormat,
                         ::testing::Values(Corners{"Triangles", 0, 32}, Corners{"Quads", 1, 16},
                                           Corners{"Both", 2, 24}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace surfmesh
