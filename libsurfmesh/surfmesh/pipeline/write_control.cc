// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/write_control.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/formats/vtu_file.hh"
#include "surfmesh/formats/write_mesh.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/sizes/placed_size.hh"

namespace surfmesh {
namespace {

/// H in space: its eigenvectors are tangent, along the normal it is 0.
Eigen::Matrix3d space_tensor(const Surface& surface, Uv uv, const SizeTensor& h) {
  const TangentFrame frame =
      tangent_frame(surface.evaluate(surface.domain().fold(uv), Order::First));
  const Vec3 &first = frame.first, &second = frame.second;
  const Eigen::Matrix3d mixed = first * second.transpose() + second * first.transpose();
  return h.h11 * first * first.transpose() + h.h12 * mixed + h.h22 * second * second.transpose();
}

/// The meshes of all patches side by side.
MeshArrays join(const std::vector<ControlPicture>& pictures) {
  MeshArrays joined;
  std::vector<int> corners;
  for (const ControlPicture& picture : pictures) {
    const PolyMesh& mesh = *picture.mesh;
    const int first = static_cast<int>(joined.points.size());
    const int patch = static_cast<int>(joined.names.patches.size());
    joined.names.patches.push_back(picture.patch);
    for (const VertexHandle vh : mesh.vertices()) joined.points.push_back(to_eigen(mesh.point(vh)));
    for (const FaceHandle fh : mesh.faces()) {
      corners.clear();
      for (const VertexHandle vh : mesh.fv_range(fh)) corners.push_back(first + vh.idx());
      joined.faces.add(corners);
      joined.patches.push_back(patch);
    }
  }
  return joined;
}

/// The values of all vertices, as many each as `values_of` gives.
template <class ValuesOf>
VtkValues at_points(const char* name, int components, const std::vector<ControlPicture>& pictures,
                    ValuesOf values_of) {
  std::vector<double> numbers;
  for (const ControlPicture& picture : pictures) {
    for (const VertexHandle vh : picture.mesh->vertices()) {
      for (const double x : values_of(picture, vh)) numbers.push_back(x);
    }
  }
  return {name, components, std::move(numbers)};
}

std::array<double, 2> uv_of(const ControlPicture& picture, VertexHandle vh) {
  const Uv uv = picture.mesh->property(require(*picture.mesh, keys::vertex_uv), vh);
  return {uv.u, uv.v};
}

std::array<double, 2> sizes_of(const ControlPicture& picture, VertexHandle vh) {
  const PrincipalSizes sizes =
      principal_sizes(picture.mesh->property(require(*picture.mesh, keys::vertex_size), vh));
  return {sizes.l_s, sizes.l_t};
}

std::array<double, 9> tensor_of(const ControlPicture& picture, VertexHandle vh) {
  const PolyMesh& mesh = *picture.mesh;
  const Eigen::Matrix3d h =
      space_tensor(*picture.surface, mesh.property(require(mesh, keys::vertex_uv), vh),
                   mesh.property(require(mesh, keys::vertex_size), vh));
  std::array<double, 9> values{};
  Eigen::Map<Eigen::Matrix3d>(values.data()) = h;  // symmetric: the order does not matter
  return values;
}

std::array<double, 2> radii_of(const ControlPicture& picture, VertexHandle vh) {
  const auto radius = find(*picture.mesh, keys::vertex_radius);
  const auto outer = find(*picture.mesh, keys::vertex_outer_radius);
  if (!radius.is_valid() || !outer.is_valid()) return {0.0, 0.0};
  return {picture.mesh->property(radius, vh), picture.mesh->property(outer, vh)};
}

std::vector<int> classes_of(const std::vector<ControlPicture>& pictures) {
  std::vector<int> classes;
  for (const ControlPicture& picture : pictures) {
    const PolyMesh& mesh = *picture.mesh;
    const auto class_of = find(mesh, keys::face_class);
    for (const FaceHandle fh : mesh.faces()) {
      classes.push_back(class_of.is_valid() ? mesh.property(class_of, fh) : -1);
    }
  }
  return classes;
}

VtkGrid grid_of(const std::vector<ControlPicture>& pictures) {
  MeshArrays joined = join(pictures);
  VtkGrid grid;
  grid.points = std::move(joined.points);
  grid.cells = std::move(joined.faces);
  grid.at_points = {at_points("uv", 2, pictures, uv_of), at_points("sizes", 2, pictures, sizes_of),
                    at_points("size", 9, pictures, tensor_of),
                    at_points("radii", 2, pictures, radii_of)};
  grid.tensors = "size";
  grid.at_cells = {{"patch", 1, std::move(joined.patches)}, {"class", 1, classes_of(pictures)}};
  return grid;
}

}  // namespace

void check_control_ending(const std::filesystem::path& path) {
  if (lower_case_ending(path) == ".vtu" || lower_case_ending(path) == ".obj") return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: control meshes are written as .vtu or .obj", path.string()));
}

void write_control(const std::vector<ControlPicture>& pictures, OutputFile& file) {
  check_control_ending(file.path());
  if (lower_case_ending(file.path()) == ".vtu")
    return write_vtu(grid_of(pictures), VtuNumbers::Text, file);
  const MeshFile mesh = mesh_from({join(pictures), {}, {}}, file.path().string());
  write_mesh(mesh.mesh, file, mesh.names);
}

void write_control(const std::vector<ControlPicture>& pictures, const std::filesystem::path& path) {
  check_control_ending(path);
  OutputFile file(path);
  write_control(pictures, file);
  file.commit();
}

}  // namespace surfmesh
