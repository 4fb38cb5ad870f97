// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/cage.hh"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Faces around a vertex, and vertices of a face, that OpenSubdiv can count (16 bits); an edge of
/// a vertex belongs to at least one of its faces, which has two of them.
constexpr int kMaxFaceSize = 65535;
constexpr int kMaxFacesOfVertex = 65535 / 2;

[[noreturn]] void fail(const std::string& text) { throw Error(ErrorCode::InvalidInput, text); }

void check_face(const Cage& cage, std::size_t index) {
  std::vector<int> sorted = cage.faces[index];
  if (sorted.size() < 3) fail(fmt::format("face {} has fewer than three vertices", index));
  if (sorted.size() > static_cast<std::size_t>(kMaxFaceSize)) {
    fail(fmt::format("face {} has more than {} vertices", index, kMaxFaceSize));
  }
  std::sort(sorted.begin(), sorted.end());
  if (sorted.front() < 0 || static_cast<std::size_t>(sorted.back()) >= cage.points.size()) {
    fail(fmt::format("face {} names vertex {}, but there are only {} points", index,
                     sorted.front() < 0 ? sorted.front() : sorted.back(), cage.points.size()));
  }
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) fail(fmt::format("face {} has vertex {} twice", index, *twice));
}

}  // namespace

double diagonal(const Cage& cage) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : cage.points) box.extend(point);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Scheme resolve_scheme(const Cage& cage, Scheme scheme) {
  if (scheme != Scheme::Auto) return scheme;
  const bool is_triangles = std::all_of(cage.faces.begin(), cage.faces.end(),
                                        [](const auto& face) { return face.size() == 3; });
  return is_triangles && !cage.is_smooth_triangles ? Scheme::Loop : Scheme::CatmullClark;
}

void check(const Cage& cage) {
  if (cage.faces.empty()) fail("the cage has no faces");
  for (std::size_t i = 0; i < cage.points.size(); ++i) {
    if (!cage.points[i].allFinite()) fail(fmt::format("point {} is not finite", i));
  }
  std::vector<int> face_counts(cage.points.size(), 0);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    check_face(cage, f);
    for (int v : cage.faces[f]) {
      if (++face_counts[static_cast<std::size_t>(v)] > kMaxFacesOfVertex) {
        fail(fmt::format("vertex {} has more than {} faces", v, kMaxFacesOfVertex));
      }
    }
  }
}

}  // namespace surfmesh
