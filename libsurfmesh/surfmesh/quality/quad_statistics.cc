// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/quad_statistics.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/moments.hh"
#include "surfmesh/quality/quality_histogram.hh"
#include "surfmesh/quality/result_corners.hh"

namespace surfmesh {
namespace {

struct Quad {
  int face = -1;
  int patch = 0;
  double area_uv = 0;
  // The least and the greatest sine of a corner as seen in (u,v): the latter, negative, is what
  // counts in a patch that lies the other way round.
  double least = INFINITY, greatest = -INFINITY;
  double in_space = 1;
};

using QuadCorners = std::array<HalfedgeHandle, 4>;

bool is_quad(const PolyMesh& mesh, FaceHandle fh) {
  return is_at_quad(mesh, mesh.halfedge_handle(fh));
}

/// A ratio to a length that may be 0.
double sine(double area, double squared_lengths) {
  return squared_lengths > 0 ? area / std::sqrt(squared_lengths) : 0 * squared_lengths;
}

/// Sine of the angle up to which a corner counts as straight in (u,v).
constexpr double kStraight = 1e-9;

double squared_norm(Uv step) { return step.u * step.u + step.v * step.v; }

/// The sine in the metric of the corner between two steps; nothing where the corner is straight in
/// (u,v): the metric makes no difference to that, and on a ring around a pole it is no straight
/// corner of the surface.
std::optional<double> sine_in_metric(const Metric& m, Uv next, Uv previous) {
  const double area = cross(next, previous);
  const double straight = kStraight * std::sqrt(squared_norm(next) * squared_norm(previous));
  if (std::abs(area) <= straight && next.u * previous.u + next.v * previous.v < 0) return {};
  return sine(density(m) * area, squared_length(m, next) * squared_length(m, previous));
}

/// The sines of the corners in space, against the normal of the diagonals.
std::array<double, 4> sines_in_space(const PolyMesh& mesh, const QuadCorners& corners) {
  std::array<Vec3, 4> points;
  for (std::size_t k = 0; k < 4; ++k) points[k] = detail::point_of(mesh, corners[k]);
  const Vec3 normal = (points[2] - points[0]).cross(points[3] - points[1]).stableNormalized();
  std::array<double, 4> sines{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 next = points[(k + 1) % 4] - points[k], previous = points[(k + 3) % 4] - points[k];
    sines[k] = sine(next.cross(previous).dot(normal), next.squaredNorm() * previous.squaredNorm());
  }
  return sines;
}

double least(const std::array<double, 4>& sines) {
  return *std::min_element(sines.begin(), sines.end());
}

void measure(const detail::ResultCorners& values, const QuadCorners& corners, Quad& quad) {
  const std::array<double, 4> in_space = sines_in_space(values.mesh, corners);
  quad.in_space = least(in_space);
  quad.area_uv = 0.5 * cross(values.uv(corners[2]) - values.uv(corners[0]),
                             values.uv(corners[3]) - values.uv(corners[1]));
  for (std::size_t k = 0; k < 4; ++k) {
    const HalfedgeHandle at = corners[k];
    const Uv next = values.uv(corners[(k + 1) % 4]) - values.uv(at);
    const Uv previous = values.uv(corners[(k + 3) % 4]) - values.uv(at);
    const double straight = std::max(in_space[k], 0.0);  // it is not turned over in (u,v)
    const double jacobian = sine_in_metric(values.metric(at), next, previous)
                                .value_or(quad.area_uv < 0 ? -straight : straight);
    if (!std::isfinite(jacobian)) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("face {}: (u,v) or the metric of a corner is not set", quad.face));
    }
    quad.least = std::min(quad.least, jacobian);
    quad.greatest = std::max(quad.greatest, jacobian);
  }
}

std::vector<Quad> measure_all(const PolyMesh& mesh) {
  const detail::ResultCorners values(mesh);
  const auto patch = find(mesh, keys::face_patch);
  std::vector<Quad> quads;
  for (const FaceHandle fh : mesh.faces()) {
    if (!is_quad(mesh, fh)) continue;
    quads.push_back({.face = fh.idx(), .patch = patch.is_valid() ? mesh.property(patch, fh) : 0});
  }
  share_ranges(quads.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const QuadCorners corners = quad_sides(mesh, mesh.halfedge_handle(FaceHandle(quads[i].face)));
      measure(values, corners, quads[i]);
    }
  });
  return quads;
}

/// The scaled Jacobian in the metric, against the orientation of the patch.
std::vector<double> jacobians_of(const std::vector<Quad>& quads) {
  std::unordered_map<int, double> patch_area;
  for (const Quad& quad : quads) patch_area[quad.patch] += quad.area_uv;
  std::vector<double> jacobians;
  jacobians.reserve(quads.size());
  for (const Quad& quad : quads) {
    jacobians.push_back(patch_area.at(quad.patch) < 0 ? -quad.greatest : quad.least);
  }
  return jacobians;
}

std::vector<double> least_of_patches(const std::vector<Quad>& quads,
                                     const std::vector<double>& jacobians) {
  int most = -1;
  for (const Quad& quad : quads) most = std::max(most, quad.patch);
  std::vector<double> least(static_cast<std::size_t>(most + 1),
                            std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < quads.size(); ++i) {
    if (quads[i].patch < 0) continue;
    double& own = least[static_cast<std::size_t>(quads[i].patch)];
    own = std::min(own, jacobians[i]);
  }
  return least;
}

double irregular_share(const PolyMesh& mesh) {
  std::vector<int> count(mesh.n_vertices(), 0);
  std::vector<char> is_counted(mesh.n_vertices(), 1);
  for (const FaceHandle fh : mesh.faces()) {
    const bool is_counted_face = is_quad(mesh, fh);
    for (const VertexHandle vh : mesh.fv_range(fh)) {
      ++count[index(vh)];
      if (!is_counted_face) is_counted[index(vh)] = 0;
    }
  }
  std::size_t inner = 0, irregular = 0;
  for (std::size_t v = 0; v < count.size(); ++v) {
    if (!is_counted[v] || count[v] == 0 || mesh.is_boundary(VertexHandle(static_cast<int>(v)))) {
      continue;
    }
    ++inner;
    if (count[v] != 4) ++irregular;
  }
  return inner == 0 ? 0 : static_cast<double>(irregular) / static_cast<double>(inner);
}

}  // namespace

std::vector<double> quad_jacobians(const PolyMesh& mesh) {
  const std::vector<Quad> quads = measure_all(mesh);
  const std::vector<double> jacobians = jacobians_of(quads);
  std::vector<double> of_faces(mesh.n_faces(), kUnset);
  for (std::size_t i = 0; i < quads.size(); ++i) {
    of_faces[static_cast<std::size_t>(quads[i].face)] = jacobians[i];
  }
  return of_faces;
}

double quad_space_jacobian(const PolyMesh& mesh, FaceHandle quad) {
  return least(sines_in_space(mesh, quad_sides(mesh, mesh.halfedge_handle(quad))));
}

QuadStatistics measure_quads(const PolyMesh& mesh) {
  const std::vector<Quad> quads = measure_all(mesh);
  QuadStatistics result;
  result.count = quads.size();
  if (quads.empty()) return result;
  result.fraction = static_cast<double>(quads.size()) / static_cast<double>(mesh.n_faces());
  const std::vector<double> jacobians = jacobians_of(quads);
  if (find(mesh, keys::face_patch).is_valid()) {
    result.min_of_patches = least_of_patches(quads, jacobians);
  }
  detail::Moments in_metric, in_space;
  result.histogram = detail::empty_quality_histogram();
  result.min_jacobian = result.min_space_jacobian = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < quads.size(); ++i) {
    in_metric.add(jacobians[i]);
    detail::count_quality(jacobians[i], result.histogram);
    in_space.add(quads[i].in_space);
    if (jacobians[i] < 0) ++result.inverted;
    if (jacobians[i] < kFlatQuad) ++result.flat;
    if (jacobians[i] < result.min_jacobian) {
      result.min_jacobian = jacobians[i];
      result.worst_face = quads[i].face;
    }
    if (quads[i].in_space < 0) ++result.folded;
    if (quads[i].in_space < result.min_space_jacobian) {
      result.min_space_jacobian = quads[i].in_space;
      result.worst_face_in_space = quads[i].face;
    }
  }
  result.mean_jacobian = in_metric.mean();
  result.mean_space_jacobian = in_space.mean();
  result.irregular_share = irregular_share(mesh);
  return result;
}

}  // namespace surfmesh
