// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/write_control.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/sizes/placed_size.hh"

namespace surfmesh {
namespace {

/// What ParaView calls a triangle.
constexpr int kVtkTriangle = 5;

/// Call `visit(picture, vertex)` for all vertices, or with faces for all triangles.
template <class Visit>
void for_each_vertex(const std::vector<ControlPicture>& pictures, Visit visit) {
  for (const ControlPicture& picture : pictures) {
    for (const VertexHandle vh : picture.mesh->vertices()) visit(picture, vh);
  }
}

/// The corners of each triangle by their numbers in the file, which begin at `first`.
template <class Visit>
void for_each_triangle(const ControlPicture& picture, std::size_t first, Visit visit) {
  for (const FaceHandle fh : picture.mesh->faces()) {
    std::array<std::size_t, 3> numbers{};
    std::size_t k = 0;
    for (const VertexHandle vh : picture.mesh->fv_range(fh)) {
      numbers[k++] = first + static_cast<std::size_t>(vh.idx());
    }
    visit(fh, numbers);
  }
}

/// H in space: its eigenvectors are tangent, along the normal it is 0.
Eigen::Matrix3d space_tensor(const ControlPicture& picture, Uv uv, const SizeTensor& h) {
  const Surface& surface = *picture.surface;
  const TangentPlace place =
      tangent_place(surface.evaluate(surface.domain().fold(uv), Order::First));
  const Vec3 &first = place.first, &second = place.second;
  const Eigen::Matrix3d mixed = first * second.transpose() + second * first.transpose();
  return h.h11 * first * first.transpose() + h.h12 * mixed + h.h22 * second * second.transpose();
}

class VtuWriter {
 public:
  VtuWriter(const std::vector<ControlPicture>& pictures, OutputFile& file)
      : pictures_(pictures), writer_(file) {}

  void write() {
    std::size_t points = 0, cells = 0;
    for (const ControlPicture& picture : pictures_) {
      points += picture.mesh->n_vertices();
      cells += picture.mesh->n_faces();
    }
    writer_.text(fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        points, cells));
    writer_.text("<Points>\n");
    write_points();
    writer_.text("</Points>\n<PointData Tensors=\"size\">\n");
    write_point_values();
    writer_.text("</PointData>\n<Cells>\n");
    write_cells();
    writer_.text("</Cells>\n<CellData>\n");
    write_cell_values();
    writer_.text("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    writer_.flush();
  }

 private:
  template <class Write>
  void array(const char* type, const char* name, int components, Write write) {
    writer_.text(fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
        name, components));
    write();
    writer_.text("</DataArray>\n");
  }

  /// One line of an array for each vertex.
  template <class Values>
  void point_array(const char* name, int components, Values values) {
    array("Float64", name, components, [&] {
      for_each_vertex(pictures_, [&](const ControlPicture& picture, VertexHandle vh) {
        for (const double x : values(picture, vh)) writer_.number(' ', x);
        writer_.text("\n");
      });
    });
  }

  void write_points() {
    point_array("points", 3, [](const ControlPicture& picture, VertexHandle vh) {
      const auto& p = picture.mesh->point(vh);
      check_finite(p, vh);
      return std::array{p[0], p[1], p[2]};
    });
  }

  void write_point_values() {
    point_array("uv", 2, [](const ControlPicture& picture, VertexHandle vh) {
      const Uv uv = picture.mesh->property(require(*picture.mesh, keys::vertex_uv), vh);
      return std::array{uv.u, uv.v};
    });
    point_array("sizes", 2, [](const ControlPicture& picture, VertexHandle vh) {
      const PrincipalSizes sizes =
          principal_sizes(picture.mesh->property(require(*picture.mesh, keys::vertex_size), vh));
      return std::array{sizes.l_s, sizes.l_t};
    });
    point_array("size", 9, [](const ControlPicture& picture, VertexHandle vh) {
      const PolyMesh& mesh = *picture.mesh;
      const Eigen::Matrix3d h =
          space_tensor(picture, mesh.property(require(mesh, keys::vertex_uv), vh),
                       mesh.property(require(mesh, keys::vertex_size), vh));
      std::array<double, 9> values{};
      Eigen::Map<Eigen::Matrix3d>(values.data()) = h;  // symmetric: the order does not matter
      return values;
    });
    point_array("radii", 2, [](const ControlPicture& picture, VertexHandle vh) {
      const auto radius = find(*picture.mesh, keys::vertex_radius);
      const auto outer = find(*picture.mesh, keys::vertex_outer_radius);
      if (!radius.is_valid() || !outer.is_valid()) return std::array{0.0, 0.0};
      return std::array{picture.mesh->property(radius, vh), picture.mesh->property(outer, vh)};
    });
  }

  void write_cells() {
    array("Int64", "connectivity", 1, [&] {
      std::size_t first = 0;
      for (const ControlPicture& picture : pictures_) {
        for_each_triangle(picture, first, [&](FaceHandle, const auto& numbers) {
          for (const std::size_t n : numbers) writer_.number(' ', n);
          writer_.text("\n");
        });
        first += picture.mesh->n_vertices();
      }
    });
    std::size_t corner = 0;
    face_array("Int64", "offsets", [&](std::size_t, FaceHandle) { return corner += 3; });
    face_array("UInt8", "types", [](std::size_t, FaceHandle) { return kVtkTriangle; });
  }

  void write_cell_values() {
    face_array("Int32", "patch", [](std::size_t patch, FaceHandle) { return patch; });
    face_array("Int32", "class", [this](std::size_t patch, FaceHandle fh) {
      const PolyMesh& mesh = *pictures_[patch].mesh;
      const auto handle = find(mesh, keys::face_class);
      return handle.is_valid() ? mesh.property(handle, fh) : -1;
    });
  }

  template <class Value>
  void face_array(const char* type, const char* name, Value value) {
    array(type, name, 1, [&] {
      for (std::size_t patch = 0; patch < pictures_.size(); ++patch) {
        for (const FaceHandle fh : pictures_[patch].mesh->faces()) {
          writer_.number(' ', value(patch, fh));
        }
        writer_.text("\n");
      }
    });
  }

  const std::vector<ControlPicture>& pictures_;
  FileWriter writer_;
};

void write_obj(const std::vector<ControlPicture>& pictures, OutputFile& file) {
  FileWriter writer(file);
  writer.text("# control meshes of surfmesh\n");
  for_each_vertex(pictures, [&](const ControlPicture& picture, VertexHandle vh) {
    const auto& p = picture.mesh->point(vh);
    check_finite(p, vh);
    writer.text("v");
    for (int i = 0; i < 3; ++i) writer.number(' ', p[i]);
    writer.text("\n");
  });
  std::size_t first = 1;
  for (const ControlPicture& picture : pictures) {
    writer.text(fmt::format("g {}\n", picture.patch));
    for_each_triangle(picture, first, [&](FaceHandle, const auto& numbers) {
      writer.text("f");
      for (const std::size_t n : numbers) writer.number(' ', n);
      writer.text("\n");
    });
    first += picture.mesh->n_vertices();
  }
  writer.flush();
}

}  // namespace

void check_control_ending(const std::filesystem::path& path) {
  if (lower_case_ending(path) == ".vtu" || lower_case_ending(path) == ".obj") return;
  throw Error(ErrorCode::Io,
              fmt::format("{}: control meshes are written as .vtu or .obj", path.string()));
}

void write_control(const std::vector<ControlPicture>& pictures, const std::filesystem::path& path) {
  check_control_ending(path);
  OutputFile file(path);
  if (lower_case_ending(path) == ".vtu") {
    VtuWriter(pictures, file).write();
  } else {
    write_obj(pictures, file);
  }
  file.commit();
}

}  // namespace surfmesh
