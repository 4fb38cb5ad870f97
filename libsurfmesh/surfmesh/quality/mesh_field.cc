// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/mesh_field.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/quad_statistics.hh"
#include "surfmesh/quality/result_corners.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {
namespace {

constexpr std::array kFields = {
    FieldDescription{MeshField::Patch, "patch", "patch", FieldOf::Faces, true},
    FieldDescription{MeshField::Group, "group", "first group of the patch", FieldOf::Faces, true},
    FieldDescription{MeshField::Quality, "quality", "quality in the metric, 1 is best"},
    FieldDescription{MeshField::Shape, "shape", "quality in space, 1 is best"},
    FieldDescription{MeshField::Size, "size", "size asked for, model units"},
    FieldDescription{MeshField::Stretch, "stretch", "ratio of the two sizes asked for"},
    FieldDescription{MeshField::Length, "length",
                     "metric length of the side farthest from 1, 1 is wanted"},
    FieldDescription{MeshField::Valence, "valence", "edges at the vertex", FieldOf::Vertices},
    FieldDescription{MeshField::Sag, "sag", "distance from the surface, model units"},
};

/// Values of faces, by their index.
std::vector<double> of_faces(const PolyMesh& mesh, const std::function<double(FaceHandle)>& value) {
  std::vector<double> values(mesh.n_faces());
  share_ranges(values.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) values[f] = value(FaceHandle(static_cast<int>(f)));
  });
  return values;
}

std::vector<double> patches(const PolyMesh& mesh) {
  const auto patch_of = require(mesh, keys::face_patch);
  return of_faces(mesh, [&](FaceHandle fh) -> double { return mesh.property(patch_of, fh); });
}

std::vector<double> groups(const PolyMesh& mesh, const MeshNames& names) {
  std::unordered_map<int, double> of_patches;  // their numbers may be any
  for (std::size_t g = 0; g < names.groups.size(); ++g) {
    for (const int patch : names.groups[g].patches) {
      of_patches.emplace(patch, static_cast<double>(g));
    }
  }
  const auto patch_of = require(mesh, keys::face_patch);
  return of_faces(mesh, [&](FaceHandle fh) -> double {
    const auto found = of_patches.find(mesh.property(patch_of, fh));
    return found != of_patches.end() ? found->second : kUnset;
  });
}

std::vector<double> qualities(const PolyMesh& mesh) {
  std::vector<double> values = triangle_qualities(mesh);
  const std::vector<double> jacobians = quad_jacobians(mesh);
  share_ranges(values.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      if (std::isnan(values[f])) values[f] = jacobians[f];
    }
  });
  return values;
}

/// The first four corners of a face, and how many there are.
struct FaceCorners {
  std::array<HalfedgeHandle, 4> first;
  std::size_t count = 0;
};

FaceCorners first_corners_of(const PolyMesh& mesh, FaceHandle fh) {
  FaceCorners corners;
  for_each_corner(mesh, fh, [&](HalfedgeHandle corner) {
    if (corners.count < corners.first.size()) corners.first[corners.count] = corner;
    ++corners.count;
  });
  return corners;
}

double shape(const PolyMesh& mesh, FaceHandle fh) {
  const FaceCorners corners = first_corners_of(mesh, fh);
  if (corners.count == 4) return quad_space_jacobian(mesh, fh);
  if (corners.count != 3) return kUnset;
  const auto [first, second, third, none] = corners.first;
  const auto [a, b, c] = detail::points_of(mesh, {first, second, third});
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? 2 * std::numbers::sqrt3 * (b - a).cross(c - a).norm() / squares : 0;
}

/// Two steps over a face, in space and in (u,v), with the metric in the middle.
struct FaceSteps {
  std::array<Vec3, 2> in_space = {};
  std::array<Uv, 2> in_uv = {};
  Metric metric = {};
};

Metric mean_metric(const detail::ResultCorners& values, FaceHandle fh) {
  Metric sum{0, 0, 0};
  double count = 0;
  for_each_corner(values.mesh, fh, [&](HalfedgeHandle corner) {
    const Metric& m = values.metric(corner);
    sum = {sum.m11 + m.m11, sum.m12 + m.m12, sum.m22 + m.m22};
    ++count;
  });
  return {sum.m11 / count, sum.m12 / count, sum.m22 / count};
}

/// Two sides of a face, or the diagonals of a quad.
FaceSteps steps_of(const detail::ResultCorners& values, FaceHandle fh) {
  const FaceCorners corners = first_corners_of(values.mesh, fh);
  const bool is_quad = corners.count == 4;
  FaceSteps steps{.metric = mean_metric(values, fh)};
  for (const std::size_t i : {0u, 1u}) {
    const HalfedgeHandle from = corners.first[i];
    const HalfedgeHandle to = corners.first[is_quad ? i + 2 : (i + 1) % 3];
    steps.in_space[i] = detail::point_of(values.mesh, to) - detail::point_of(values.mesh, from);
    steps.in_uv[i] = values.uv(to) - values.uv(from);
  }
  return steps;
}

/// The geometric mean of the two sizes that a metric asks for in a face, and their ratio.
struct FaceSizes {
  double size = kUnset;
  double stretch = kUnset;
};

/// The squares of the sizes are the eigenvalues λ of G e = λ M e, with both forms of a step e
/// taken in the basis of the two steps.
FaceSizes sizes_of(const FaceSteps& steps) {
  const auto& [space, uv, m] = steps;
  const double g11 = space[0].squaredNorm(), g12 = space[0].dot(space[1]),
               g22 = space[1].squaredNorm();
  const double m11 = squared_length(m, uv[0]), m12 = inner_product(m, uv[0], uv[1]),
               m22 = squared_length(m, uv[1]);
  const double metric_area = m11 * m22 - m12 * m12, area = g11 * g22 - g12 * g12;
  if (!(metric_area > 0) || !(area > 0)) return {};
  const double product = std::sqrt(metric_area) * std::sqrt(area);
  const double mean = std::max(1.0, (g11 * m22 + g22 * m11 - 2 * g12 * m12) / (2 * product));
  return {std::sqrt(std::sqrt(area / metric_area)), mean + std::sqrt(mean * mean - 1)};
}

std::vector<double> sizes(const PolyMesh& mesh, double FaceSizes::*value) {
  const detail::ResultCorners values(mesh);
  return of_faces(mesh, [&](FaceHandle fh) { return sizes_of(steps_of(values, fh)).*value; });
}

std::vector<double> lengths(const PolyMesh& mesh) {
  const std::vector<double> of_edges = metric_lengths(mesh);
  return of_faces(mesh, [&](FaceHandle fh) {
    double farthest = 1;
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      const double length = of_edges[index(mesh.edge_handle(heh))];
      if (std::abs(std::log(length)) > std::abs(std::log(farthest))) farthest = length;
    }
    return farthest;
  });
}

std::vector<double> valences(const PolyMesh& mesh) {
  std::vector<double> values(mesh.n_vertices());
  share_ranges(values.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      values[v] = mesh.valence(VertexHandle(static_cast<int>(v)));
    }
  });
  return values;
}

}  // namespace

std::span<const FieldDescription> mesh_fields() { return kFields; }

const FieldDescription& describe(MeshField field) {
  return kFields[static_cast<std::size_t>(field)];
}

const FieldDescription& find_mesh_field(std::string_view name) {
  std::string names;
  for (const FieldDescription& field : kFields) {
    if (field.name == name) return field;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", field.name);
  }
  throw Error(ErrorCode::InvalidInput,
              fmt::format("a mesh has no field \"{}\": there are {}", name, names));
}

bool has_field(const PolyMesh& mesh, const MeshNames& names, MeshField field) {
  const bool has_patches = find(mesh, keys::face_patch).is_valid();
  switch (field) {
    case MeshField::Patch:
      return has_patches;
    case MeshField::Group:
      return has_patches && !names.groups.empty();
    case MeshField::Quality:
    case MeshField::Size:
    case MeshField::Stretch:
    case MeshField::Length:
      return has_parameters(mesh) && has_metric(mesh);
    case MeshField::Shape:
    case MeshField::Valence:
      return true;
    case MeshField::Sag:
      return find(mesh, keys::face_sag).is_valid();
  }
  return false;
}

std::vector<double> measure_field(const PolyMesh& mesh, const MeshNames& names, MeshField field) {
  switch (field) {
    case MeshField::Patch:
      return patches(mesh);
    case MeshField::Group:
      return groups(mesh, names);
    case MeshField::Quality:
      return qualities(mesh);
    case MeshField::Shape:
      return of_faces(mesh, [&](FaceHandle fh) { return shape(mesh, fh); });
    case MeshField::Size:
      return sizes(mesh, &FaceSizes::size);
    case MeshField::Stretch:
      return sizes(mesh, &FaceSizes::stretch);
    case MeshField::Length:
      return lengths(mesh);
    case MeshField::Valence:
      return valences(mesh);
    case MeshField::Sag:
      return mesh.property(require(mesh, keys::face_sag)).data_vector();
  }
  return {};
}

}  // namespace surfmesh
