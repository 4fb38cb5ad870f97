// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/cage.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Faces around a vertex, and vertices of a face, that OpenSubdiv can count (16 bits); an edge of
/// a vertex belongs to at least one of its faces, which has two of them.
constexpr int kMaxFaceSize = 65535;
constexpr int kMaxFacesOfVertex = 65535 / 2;

[[noreturn]] void fail(const std::string& text) { throw Error(ErrorCode::InvalidInput, text); }

void check_range(const Cage& cage, std::size_t index) {
  const std::vector<int>& face = cage.faces[index];
  if (face.size() < 3) fail(fmt::format("face {} has fewer than three vertices", index));
  if (face.size() > static_cast<std::size_t>(kMaxFaceSize)) {
    fail(fmt::format("face {} has more than {} vertices", index, kMaxFaceSize));
  }
  for (int v : face) {
    if (v < 0 || static_cast<std::size_t>(v) >= cage.points.size()) {
      fail(fmt::format("face {} names vertex {}, but there are only {} points", index, v,
                       cage.points.size()));
    }
  }
}

}  // namespace

std::vector<int> without_repeats(const std::vector<int>& face) {
  std::vector<int> result;
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (face[i] != face[(i + 1) % face.size()]) result.push_back(face[i]);
  }
  return result;
}

bool is_simple(const std::vector<int>& face) {
  std::vector<int> sorted = without_repeats(face);
  std::sort(sorted.begin(), sorted.end());
  return sorted.size() >= 3 && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

std::vector<int> used_vertices(const Cage& cage) {
  std::vector<char> is_used(cage.points.size(), 0);
  for (const std::vector<int>& face : cage.faces) {
    for (const int v : face) {
      if (v >= 0 && static_cast<std::size_t>(v) < is_used.size()) {
        is_used[static_cast<std::size_t>(v)] = 1;
      }
    }
  }
  std::vector<int> vertices;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v]) vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

Eigen::AlignedBox3d bounding_box(const Cage& cage) {
  Eigen::AlignedBox3d box;
  for (const int v : used_vertices(cage)) box.extend(cage.points[static_cast<std::size_t>(v)]);
  return box;
}

double diagonal(const Cage& cage) {
  const Eigen::AlignedBox3d box = bounding_box(cage);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Scheme resolve_scheme(const Cage& cage, Scheme scheme) {
  if (scheme != Scheme::Auto) return scheme;
  const bool is_triangles = std::all_of(cage.faces.begin(), cage.faces.end(),
                                        [](const auto& face) { return face.size() == 3; });
  return is_triangles && !cage.is_smooth_triangles ? Scheme::Loop : Scheme::CatmullClark;
}

void check_ranges(const Cage& cage) {
  if (cage.faces.empty()) fail("the cage has no faces");
  for (std::size_t i = 0; i < cage.points.size(); ++i) {
    if (!cage.points[i].allFinite()) fail(fmt::format("point {} is not finite", i));
  }
  for (std::size_t f = 0; f < cage.faces.size(); ++f) check_range(cage, f);
}

void check(const Cage& cage) {
  check_ranges(cage);
  std::vector<int> face_counts(cage.points.size(), 0);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    if (!is_simple(cage.faces[f])) fail(fmt::format("face {} comes back to a vertex", f));
    for (int v : cage.faces[f]) {
      if (++face_counts[static_cast<std::size_t>(v)] > kMaxFacesOfVertex) {
        fail(fmt::format("vertex {} has more than {} faces", v, kMaxFacesOfVertex));
      }
    }
  }
}

}  // namespace surfmesh
