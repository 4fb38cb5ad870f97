// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/mesh_format.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/formats/bdf_file.hh"
#include "surfmesh/formats/glb_file.hh"
#include "surfmesh/formats/inp_file.hh"
#include "surfmesh/formats/medit_file.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/msh_file.hh"
#include "surfmesh/formats/obj_file.hh"
#include "surfmesh/formats/off_file.hh"
#include "surfmesh/formats/om_file.hh"
#include "surfmesh/formats/ply_file.hh"
#include "surfmesh/formats/split_face.hh"
#include "surfmesh/formats/stl_file.hh"
#include "surfmesh/formats/vtk_file.hh"
#include "surfmesh/formats/vtu_file.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/model/cad_input.hh"

namespace surfmesh {
namespace {

template <class Mesh, class Key>
bool has(const Mesh& mesh, const Key& key) {
  return find(mesh, key).is_valid();
}

double rounding_of(const OpenMesh::Vec3d& point) {
  // Not in OpenMesh's vectors: GCC 12 takes a conversion to float and back for nothing there.
  const Vec3 exact = to_eigen(point);
  return (exact.cast<float>().cast<double>() - exact).norm();
}

struct Greatest {
  double value = 0;

  Greatest& operator+=(const Greatest& other) {
    if (other.value > value) value = other.value;
    return *this;
  }
};

/// The greatest value of the indices below `count`, at least 0; NaN counts as nothing.
template <class ValueOf>
double greatest_of(std::size_t count, ValueOf value_of) {
  return sum_of_ranges(count,
                       [&](std::size_t first, std::size_t end) {
                         Greatest own;
                         for (std::size_t i = first; i < end; ++i) {
                           own += {value_of(static_cast<int>(i))};
                         }
                         return own;
                       })
      .value;
}

bool has_contours(const PolyMesh& mesh) {
  const auto contour_of = find(mesh, keys::edge_contour);
  if (!contour_of.is_valid()) return false;
  const auto& contours = mesh.property(contour_of).data_vector();
  return std::any_of(contours.begin(), contours.end(), [](int contour) { return contour >= 0; });
}

/// ".obj, .off or .om" of the formats for which `is_meant` holds.
template <class IsMeant>
std::string endings_of(IsMeant is_meant) {
  std::vector<std::string_view> endings;
  for (const MeshFormat& format : mesh_formats()) {
    if (is_meant(format)) endings.push_back(format.ending);
  }
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i) {
    if (i > 0) text += i + 1 == endings.size() ? " or " : ", ";
    text += endings[i];
  }
  return text;
}

bool is_model(const std::filesystem::path& path) {
  return has_cad_ending(path) || lower_case_ending(path) == ".json";
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
  static const std::array formats = {obj_format(),    off_format(), ply_format(), stl_format(),
                                     vtu_format(),    vtk_format(), msh_format(), medit_format(),
                                     meditb_format(), glb_format(), inp_format(), bdf_format(),
                                     om_format()};
  return formats;
}

const MeshFormat* find_format(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  for (const MeshFormat& format : mesh_formats()) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

const MeshFormat& format_of(const std::filesystem::path& path) {
  if (const MeshFormat* format = find_format(path)) return *format;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: the ending of a mesh is {}", path.string(), mesh_endings()));
}

const MeshFormat& format_to_read(const std::filesystem::path& path) {
  const MeshFormat* format = find_format(path);
  if (format != nullptr && format->parse != nullptr) return *format;
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("{}: {}{}", path.string(),
                  is_model(path) ? "this is a model, no mesh: mesh it first; what is read is "
                  : lower_case_ending(path) == ".pvtu"
                      ? "this only lists the pieces of a mesh, .vtu files; what is read is "
                  : format == nullptr
                      ? "the ending of a mesh to read is "
                      : fmt::format("{} files are only written; what is read is ", format->ending),
                  readable_mesh_endings()));
}

std::string mesh_endings() {
  return endings_of([](const MeshFormat&) { return true; });
}

std::string readable_mesh_endings() {
  return endings_of([](const MeshFormat& format) { return format.parse != nullptr; });
}

std::string cage_endings() {
  return endings_of([](const MeshFormat& format) { return format.parse_cage != nullptr; });
}

std::string corner_value_endings() {
  return endings_of([](const MeshFormat& format) { return format.has_corner_values; });
}

bool has_mesh_ending(const std::filesystem::path& path) { return find_format(path) != nullptr; }

bool has_cage_ending(const std::filesystem::path& path) {
  const MeshFormat* format = find_format(path);
  return format != nullptr && format->parse_cage != nullptr;
}

void check_mesh_ending(const std::filesystem::path& path) { format_of(path); }

void check_readable_ending(const std::filesystem::path& path) { format_to_read(path); }

std::vector<std::string> lost_properties(const PolyMesh& mesh, const KeptProperties& kept) {
  std::vector<std::string> lost;
  if (!kept.normals && has(mesh, keys::corner_normal)) {
    lost.push_back("the normals of the corners");
  }
  if (!kept.uv && has(mesh, keys::corner_uv)) {
    lost.push_back("the parameters (u,v) of the corners");
  }
  if (!kept.texture && has(mesh, keys::corner_texture)) {
    lost.push_back("the texture coordinates of the corners");
  }
  if (!kept.metric && has(mesh, keys::corner_metric)) lost.push_back("the metric of the corners");
  if (!kept.contours && has_contours(mesh)) lost.push_back("the contours of the edges");
  if (!kept.sag && has(mesh, keys::face_sag)) lost.push_back("the sag of the faces");
  if (has(mesh, keys::vertex_uv)) lost.push_back("the parameters (u,v) of the vertices");
  if (has(mesh, keys::vertex_size)) lost.push_back("the sizes of the vertices");
  if (has(mesh, keys::vertex_metric)) lost.push_back("the metric of the vertices");
  return lost;
}

std::vector<std::string> lost_patches_and_properties(const PolyMesh& mesh, const MeshNames& names) {
  std::vector<std::string> lost = lost_properties(mesh);
  if (!has(mesh, keys::face_patch)) return lost;
  if (!names.groups.empty()) lost.insert(lost.begin(), "the groups of the patches");
  lost.insert(lost.begin(), "the patches of the faces");
  return lost;
}

Rounding rounding_to_single(const PolyMesh& mesh) {
  Rounding result;
  result.greatest_move = greatest_of(
      mesh.n_vertices(), [&](int vertex) { return rounding_of(mesh.point(VertexHandle(vertex))); });
  result.share = greatest_of(mesh.n_edges(), [&](int edge) {
    const HalfedgeHandle heh = mesh.halfedge_handle(EdgeHandle(edge), 0);
    const OpenMesh::Vec3d& a = mesh.point(mesh.from_vertex_handle(heh));
    const OpenMesh::Vec3d& b = mesh.point(mesh.to_vertex_handle(heh));
    const double length = (b - a).norm();
    return length > 0 ? std::max(rounding_of(a), rounding_of(b)) / length : 0;
  });
  return result;
}

void add_lost_digits(const PolyMesh& mesh, std::vector<std::string>& lost) {
  const double move = rounding_to_single(mesh).greatest_move;
  if (!(move > 0)) return;
  lost.push_back(fmt::format(
      "the digits of positions beyond single precision: vertices move by up to {:.3g}", move));
}

void add_split_faces(const PolyMesh& mesh, std::size_t corners, std::vector<std::string>& lost) {
  const std::size_t count = count_faces_above(mesh, corners);
  if (count == 0) return;
  lost.push_back(fmt::format("{} faces of more than {} corners, which are split", count,
                             corners == 3 ? "three" : "four"));
}

void check_single_precision(const PolyMesh& mesh, std::string_view ending) {
  share_ranges(mesh.n_vertices(), [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      const VertexHandle vh(static_cast<int>(v));
      const OpenMesh::Vec3d& point = mesh.point(vh);
      check_finite(point, vh);
      if (point.max_abs() <= static_cast<double>(std::numeric_limits<float>::max())) continue;
      throw Error(ErrorCode::Geometry,
                  fmt::format("the position of vertex {} is ({}, {}, {}), too large for {}", v,
                              point[0], point[1], point[2], ending));
    }
  });
}

}  // namespace surfmesh
