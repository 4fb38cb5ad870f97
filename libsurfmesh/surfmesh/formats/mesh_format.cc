// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/mesh_format.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/obj_file.hh"
#include "surfmesh/formats/off_file.hh"
#include "surfmesh/formats/om_file.hh"
#include "surfmesh/formats/ply_file.hh"
#include "surfmesh/formats/stl_file.hh"
#include "surfmesh/io/input_file.hh"

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

}  // namespace

std::span<const MeshFormat> mesh_formats() {
  static const std::array formats = {obj_format(), off_format(), ply_format(), stl_format(),
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
  const bool is_for_paraview = lower_case_ending(path) == ".vtu";
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("{}: the ending of a mesh is {}{}", path.string(), mesh_endings(),
                  is_for_paraview
                      ? "; ParaView and VTK read .ply, .obj and .stl, and only control spaces are "
                        "written to .vtu"
                      : ""));
}

std::string mesh_endings() {
  return endings_of([](const MeshFormat&) { return true; });
}

std::string cage_endings() {
  return endings_of([](const MeshFormat& format) { return format.parse_cage != nullptr; });
}

std::string corner_value_endings() {
  return endings_of([](const MeshFormat& format) { return format.has_corner_values; });
}

bool has_cage_ending(const std::filesystem::path& path) {
  const MeshFormat* format = find_format(path);
  return format != nullptr && format->parse_cage != nullptr;
}

void check_mesh_ending(const std::filesystem::path& path) { format_of(path); }

std::vector<std::string> lost_properties(const PolyMesh& mesh, const OutputOptions& written) {
  std::vector<std::string> lost;
  if (!written.normals && has(mesh, keys::corner_normal)) {
    lost.push_back("the normals of the corners");
  }
  if (!written.uv && has(mesh, keys::corner_uv)) {
    lost.push_back("the parameters (u,v) of the corners");
  }
  if (has(mesh, keys::corner_metric)) lost.push_back("the metric of the corners");
  if (has_contours(mesh)) lost.push_back("the contours of the edges");
  if (has(mesh, keys::face_sag)) lost.push_back("the sag of the faces");
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
  for (const VertexHandle vh : mesh.vertices()) {
    result.greatest_move = std::max(result.greatest_move, rounding_of(mesh.point(vh)));
  }
  for (const EdgeHandle eh : mesh.edges()) {
    const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
    const OpenMesh::Vec3d& a = mesh.point(mesh.from_vertex_handle(heh));
    const OpenMesh::Vec3d& b = mesh.point(mesh.to_vertex_handle(heh));
    const double move = std::max(rounding_of(a), rounding_of(b));
    const double length = (b - a).norm();
    if (length > 0 && move > result.share * length) result.share = move / length;
  }
  return result;
}

}  // namespace surfmesh
