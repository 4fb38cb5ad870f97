// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "arrays.hh"
#include "bindings.hh"
#include "clean_names.hh"
#include "held_mesh.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/quality/mesh_field.hh"

namespace surfmesh::python {
namespace {

/// OpenMesh's own points; the array keeps the mesh.
py::array points(const py::object& self) {
  const PolyMesh& mesh = self.cast<const HeldMesh&>().mesh();
  const auto count = static_cast<py::ssize_t>(mesh.n_vertices());
  constexpr auto kDouble = static_cast<py::ssize_t>(sizeof(double));
  static_assert(sizeof(PolyMesh::Point) == 3 * sizeof(double));
  const double* const first = count > 0 ? mesh.points()->data() : nullptr;
  py::array_t<double> array({count, py::ssize_t{3}}, {3 * kDouble, kDouble}, first, self);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// The vertices of the faces that have so many corners, in their order.
py::array faces_of(const HeldMesh& held, unsigned corners) {
  const PolyMesh& mesh = held.mesh();
  std::vector<int> vertices;
  vertices.reserve(corners * mesh.n_faces());
  for (const FaceHandle fh : mesh.faces()) {
    if (mesh.valence(fh) != corners) continue;
    for_each_vertex_of(mesh, fh, [&](int vertex) { vertices.push_back(vertex); });
  }
  vertices.shrink_to_fit();
  return to_array(std::move(vertices), corners);
}

std::size_t corner_count(const PolyMesh& mesh) {
  std::size_t count = 0;
  for (const HalfedgeHandle heh : mesh.halfedges()) count += mesh.is_boundary(heh) ? 0 : 1;
  return count;
}

/// Call `visit` with each corner of all faces, in their order.
template <class Visitor>
void for_all_corners(const PolyMesh& mesh, Visitor visit) {
  for (const FaceHandle fh : mesh.faces()) for_each_corner(mesh, fh, visit);
}

py::array corners(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  std::vector<int> vertices;
  vertices.reserve(corner_count(mesh));
  for_all_corners(
      mesh, [&](HalfedgeHandle heh) { vertices.push_back(mesh.to_vertex_handle(heh).idx()); });
  return to_array(std::move(vertices));
}

py::array offsets(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  std::vector<std::int64_t> first = {0};
  first.reserve(mesh.n_faces() + 1);
  for (const FaceHandle fh : mesh.faces()) {
    first.push_back(first.back() + static_cast<std::int64_t>(mesh.valence(fh)));
  }
  return to_array(std::move(first));
}

/// Values of the corners in rows; none if the mesh does not have the property. `take` writes those
/// of one.
template <std::size_t width, class Value, class Take>
py::object of_corners(const PolyMesh& mesh, const PropertyKey<HalfedgeHandle, Value>& key,
                      Take take) {
  const auto values = find(mesh, key);
  if (!values.is_valid()) return py::none();
  py::array_t<double> rows({corner_count(mesh), width});
  double* next = rows.mutable_data();
  for_all_corners(mesh, [&](HalfedgeHandle heh) {
    take(mesh.property(values, heh), next);
    next += width;
  });
  return rows;
}

py::object uv(const HeldMesh& held) {
  return of_corners<2>(held.mesh(), keys::corner_uv, [](const Uv& uv, double* row) {
    row[0] = uv.u;
    row[1] = uv.v;
  });
}

py::object metric(const HeldMesh& held) {
  return of_corners<3>(held.mesh(), keys::corner_metric, [](const Metric& m, double* row) {
    row[0] = m.m11;
    row[1] = m.m12;
    row[2] = m.m22;
  });
}

py::object normals(const HeldMesh& held) {
  return of_corners<3>(held.mesh(), keys::corner_normal, [](const Normal& n, double* row) {
    row[0] = n.x;
    row[1] = n.y;
    row[2] = n.z;
  });
}

py::array beyond(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  const auto is_beyond = find(mesh, keys::corner_beyond);
  py::array_t<bool> array(static_cast<py::ssize_t>(corner_count(mesh)));
  bool* next = array.mutable_data();
  for_all_corners(mesh, [&](HalfedgeHandle heh) {
    *next++ = is_beyond.is_valid() && mesh.property(is_beyond, heh) != 0;
  });
  return array;
}

py::object patch(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  const auto patches = find(mesh, keys::face_patch);
  if (!patches.is_valid()) return py::none();
  return to_array(std::vector<int>(mesh.property(patches).data_vector()));
}

/// Both ends and the contour of each edge that lies on one.
py::array contour_edges(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  const auto contours = find(mesh, keys::edge_contour);
  std::vector<int> rows;
  if (contours.is_valid()) {
    for (const EdgeHandle eh : mesh.edges()) {
      const int contour = mesh.property(contours, eh);
      if (contour < 0) continue;
      const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
      rows.insert(rows.end(),
                  {mesh.from_vertex_handle(heh).idx(), mesh.to_vertex_handle(heh).idx(), contour});
    }
  }
  return to_array(std::move(rows), 3);
}

/// The vertex of which each is a copy, or itself.
py::array original(const HeldMesh& held) {
  const PolyMesh& mesh = held.mesh();
  const auto originals = find(mesh, keys::vertex_original);
  std::vector<int> result(mesh.n_vertices());
  for (const VertexHandle vh : mesh.vertices()) {
    result[index(vh)] = originals.is_valid() ? mesh.property(originals, vh) : vh.idx();
  }
  return to_array(std::move(result));
}

py::array field(const HeldMesh& held, const std::string& name) {
  std::vector<double> values;
  {
    const py::gil_scoped_release release;
    values = measure_field(held.mesh(), held.names(), find_mesh_field(name).field);
  }
  return to_array(std::move(values));
}

std::vector<std::string> fields(const HeldMesh& held) {
  std::vector<std::string> names;
  for (const FieldDescription& field : mesh_fields()) {
    if (has_field(held.mesh(), held.names(), field.field)) names.emplace_back(field.name);
  }
  return names;
}

py::list groups(const HeldMesh& held) {
  py::list list;
  for (const Group& group : held.names().groups) {
    list.append(py::make_tuple(clean_text(group.name), group.patches));
  }
  return list;
}

/// Write the mesh. Returns notices of what is otherwise in the file.
Notices write(const HeldMesh& held, const std::filesystem::path& path, bool has_uv,
              bool has_normals) {
  const py::gil_scoped_release release;
  OutputOptions options;
  options.uv = has_uv;
  options.normals = has_normals;
  Notices notices = unused_options(held.mesh(), path, options);
  append(changed_names(held.mesh(), path, held.names()), notices);
  write_mesh(held.mesh(), path, held.names(), options);
  return notices;
}

std::shared_ptr<HeldMesh> read_held_mesh(const std::filesystem::path& path) {
  const py::gil_scoped_release release;
  return std::make_shared<HeldMesh>(std::unique_ptr<const MeshFile>(new MeshFile(read_mesh(path))));
}

py::object report_text(const HeldMesh& held) {
  if (!held.report()) return py::none();
  return py::str(to_json(*held.report()));
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<HeldMesh, std::shared_ptr<HeldMesh>>(module, "HeldMesh",
                                                  "A half-edge mesh that C++ holds.")
      .def("points", &points, "Positions (n, 3), without a copy; read only.")
      .def("faces_of", &faces_of, py::arg("corners"), "Vertices of faces of so many corners.")
      .def("corners", &corners, "Vertices of all faces, one after the other.")
      .def("offsets", &offsets, "First corner of each face, and their number.")
      .def("uv", &uv, "Parameters of the corners (c, 2), or None.")
      .def("metric", &metric, "Metric of the corners (c, 3), or None.")
      .def("normals", &normals, "Normals of the corners (c, 3), or None.")
      .def("beyond", &beyond, "True for corners beyond their patch.")
      .def("patch", &patch, "Patch of each face, or None.")
      .def("contour_edges", &contour_edges, "Edges on contours (k, 3): both ends, contour.")
      .def("original", &original, "The vertex of which each is a copy, or itself.")
      .def("field", &field, py::arg("name"), "Values of a field.")
      .def("fields", &fields, "Names of the fields that the mesh has.")
      .def(
          "patch_names", [](const HeldMesh& held) { return clean_names(held.names().patches); },
          "Names of patches.")
      .def(
          "contour_names", [](const HeldMesh& held) { return clean_names(held.names().contours); },
          "Names of contours.")
      .def("groups", &groups, "Names of groups with their patches.")
      .def(
          "notices", [](const HeldMesh& held) { return held.notices(); }, "What there is to tell.")
      .def(
          "counts",
          [](const HeldMesh& held) {
            return py::make_tuple(held.mesh().n_vertices(), held.mesh().n_edges(),
                                  held.mesh().n_faces());
          },
          "Numbers of vertices, edges and faces.")
      .def("report", &report_text, "The report as JSON text, or None.")
      .def("write", &write, py::arg("path"), py::arg("uv"), py::arg("normals"),
           "Write the mesh to a file.");
  module.def("read_mesh", &read_held_mesh, py::arg("path"), "Read a mesh.");
}

}  // namespace surfmesh::python
