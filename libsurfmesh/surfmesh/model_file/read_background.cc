// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_background.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

/// How much two entries of a tensor may differ that should be equal, as a share of the greatest:
/// files in single precision have so much.
constexpr double kSymmetry = 1e-5;

[[noreturn]] void fail(const std::string& reason) { throw Error(ErrorCode::InvalidInput, reason); }

const GridValues& find_values(const GridFile& grid, const std::string& name) {
  std::vector<std::string_view> names;
  for (const GridValues& values : grid.at_points) {
    if (values.name == name) return values;
    names.push_back(values.name);
  }
  if (names.empty()) fail("it has no values at its vertices");
  const std::string there = fmt::format("it has {}", fmt::join(names, ", "));
  if (!name.empty()) {
    const auto meant = nearest_word(name, names);
    fail(fmt::format("it has no values {} at its points, {}{}", name,
                     meant ? fmt::format("did you mean {}? ", *meant) : "", there));
  }
  if (names.size() > 1) fail(fmt::format("it has several values, name one of them: {}", there));
  return grid.at_points.front();
}

/// Rows of 3 × 3 or 2 × 2 entries, which must be symmetric.
void check_symmetric(std::span<const double> rows, std::size_t size, std::size_t vertex) {
  double greatest = 0;
  for (const double x : rows) greatest = std::max(greatest, std::abs(x));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(rows[i * size + j] - rows[j * size + i]) > kSymmetry * greatest) {
        fail(fmt::format("the tensor at vertex {}, from 0, is not symmetric", vertex));
      }
    }
  }
}

SpaceMetric plane_metric(double xx, double xy, double yy) {
  // No number where it is not positive definite, which is told where it is used.
  return {xx, yy, std::sqrt(xx * yy - xy * xy), xy, 0, 0};
}

SpaceMetric metric_of(std::span<const double> m, std::size_t vertex) {
  switch (m.size()) {
    case 3:
      return plane_metric(m[0], m[1], m[2]);
    case 4:
      check_symmetric(m, 2, vertex);
      return plane_metric(m[0], m[1], m[3]);
    case 6:
      return {m[0], m[1], m[2], m[3], m[4], m[5]};
    default:
      check_symmetric(m, 3, vertex);
      return {m[0], m[4], m[8], m[1], m[5], m[2]};
  }
}

void check_components(const GridValues& values, BackgroundIn in) {
  const int count = values.components;
  const bool is_in_uv = in == BackgroundIn::Uv;
  if (count == 1 || count == 6 || count == 9) return;
  if (count == 3 && (is_in_uv || values.is_plane_tensor)) return;
  if (count == 4 && is_in_uv) return;
  fail(fmt::format("its values {} have {} numbers each; a size has 1, a metric {}", values.name,
                   count, is_in_uv ? "3, 4, 6 or 9" : "6 or 9"));
}

/// Triangles of a face with any number of corners; the diagonal of a quad is the shorter one.
void divide(std::span<const int> face, const std::vector<Vec3>& points,
            std::vector<std::array<int, 3>>& triangles) {
  const auto distance = [&](int a, int b) {
    return (points[static_cast<std::size_t>(a)] - points[static_cast<std::size_t>(b)]).norm();
  };
  const bool is_turned =
      face.size() == 4 && distance(face[1], face[3]) < distance(face[0], face[2]);
  const auto corner = [&](std::size_t k) { return face[(k + (is_turned ? 1 : 0)) % face.size()]; };
  for (std::size_t k = 2; k < face.size(); ++k) {
    triangles.push_back({corner(0), corner(k - 1), corner(k)});
  }
}

}  // namespace

BackgroundMesh background_mesh(const GridFile& grid, const std::string& name, BackgroundIn in) {
  BackgroundMesh mesh;
  mesh.points = grid.points;
  mesh.tetrahedra = grid.tetrahedra;
  for (std::size_t f = 0; f < grid.faces.size(); ++f) {
    divide(grid.faces[f], grid.points, mesh.triangles);
  }
  const GridValues& values = find_values(grid, name);
  check_components(values, in);
  if (values.components == 1) {
    mesh.sizes = values.numbers;
    return mesh;
  }
  const auto components = static_cast<std::size_t>(values.components);
  mesh.metrics.reserve(grid.points.size());
  for (std::size_t v = 0; v < values.numbers.size() / components; ++v) {
    mesh.metrics.push_back(
        metric_of(std::span(values.numbers).subspan(v * components, components), v));
  }
  return mesh;
}

BackgroundMesh read_background(const std::filesystem::path& path, const std::string& values,
                               BackgroundIn in) {
  const GridFile grid = read_grid(path);
  BackgroundMesh mesh;
  at_location(path.string(), [&] { mesh = background_mesh(grid, values, in); });
  return mesh;
}

}  // namespace surfmesh
