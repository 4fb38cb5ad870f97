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
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/face_corners.hh"
#include "surfmesh/quality/moments.hh"
#include "surfmesh/quality/patch_runs.hh"
#include "surfmesh/quality/quality_histogram.hh"
#include "surfmesh/quality/result_corners.hh"

namespace surfmesh {
namespace {

struct Quad {
  int face = -1;  ///< none for a face that is no quad
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

/// By face.
std::vector<Quad> measure_all(const PolyMesh& mesh) {
  const detail::ResultCorners values(mesh);
  std::vector<Quad> quads(mesh.n_faces());
  share_ranges(quads.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (!is_quad(mesh, fh)) continue;
      quads[f].face = fh.idx();
      measure(values, quad_sides(mesh, mesh.halfedge_handle(fh)), quads[f]);
    }
  });
  return quads;
}

/// The areas of patches in (u,v).
std::unordered_map<int, double> patch_areas(const PolyMesh& mesh, const std::vector<Quad>& quads) {
  const detail::PatchOf patch_of(mesh);
  const auto runs = sum_of_ranges(quads.size(), [&](std::size_t first, std::size_t end) {
    detail::PatchRuns<double> own;
    for (std::size_t f = first; f < end; ++f) {
      if (quads[f].face >= 0) own.next(patch_of(f)) += quads[f].area_uv;
    }
    return own;
  });
  std::unordered_map<int, double> areas;
  for (const auto& [patch, area] : runs) areas[patch] += area;
  return areas;
}

/// The scaled Jacobians in the metric, against the orientation of the patch, by face; unset where
/// it is no quad.
std::vector<double> jacobians_of(const PolyMesh& mesh, const std::vector<Quad>& quads) {
  const std::unordered_map<int, double> areas = patch_areas(mesh, quads);
  const detail::PatchOf patch_of(mesh);
  std::vector<double> jacobians(quads.size(), kUnset);
  share_ranges(quads.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      if (quads[f].face < 0) continue;
      jacobians[f] = areas.at(patch_of(f)) < 0 ? -quads[f].greatest : quads[f].least;
    }
  });
  return jacobians;
}

/// The least of values at faces, and the first face that has it.
struct WorstQuad {
  double value = std::numeric_limits<double>::infinity();
  int face = -1;

  void take(const WorstQuad& other) {
    if (other.value < value) *this = other;
  }
};

struct QuadSums {
  std::size_t count = 0;
  detail::Moments in_metric, in_space;
  WorstQuad worst, worst_in_space;
  std::size_t inverted = 0;
  std::size_t flat = 0;
  std::size_t folded = 0;
  detail::PatchRuns<detail::Least> of_patches;
  std::vector<HistogramBin> histogram = detail::empty_quality_histogram();

  void add(const Quad& quad, int patch, double jacobian) {
    ++count;
    in_metric.add(jacobian);
    in_space.add(quad.in_space);
    worst.take({jacobian, quad.face});
    worst_in_space.take({quad.in_space, quad.face});
    if (jacobian < 0) ++inverted;
    if (jacobian < kFlatQuad) ++flat;
    if (quad.in_space < 0) ++folded;
    double& own = of_patches.next(patch).value;
    own = std::min(own, jacobian);
    detail::count_quality(jacobian, histogram);
  }

  QuadSums& operator+=(const QuadSums& other) {
    count += other.count;
    in_metric += other.in_metric;
    in_space += other.in_space;
    worst.take(other.worst);
    worst_in_space.take(other.worst_in_space);
    inverted += other.inverted;
    flat += other.flat;
    folded += other.folded;
    of_patches += other.of_patches;
    detail::add_counts(other.histogram, histogram);
    return *this;
  }
};

QuadSums sum_quads(const PolyMesh& mesh) {
  const std::vector<Quad> quads = measure_all(mesh);
  const std::vector<double> jacobians = jacobians_of(mesh, quads);
  const detail::PatchOf patch_of(mesh);
  return sum_of_ranges(quads.size(), [&](std::size_t first, std::size_t end) {
    QuadSums own;
    for (std::size_t f = first; f < end; ++f) {
      if (quads[f].face >= 0) own.add(quads[f], patch_of(f), jacobians[f]);
    }
    return own;
  });
}

/// Vertices within quads alone.
struct InnerVertices {
  std::size_t count = 0;
  std::size_t irregular = 0;

  void add(const PolyMesh& mesh, VertexHandle vh) {
    if (mesh.is_isolated(vh) || mesh.is_boundary(vh)) return;
    std::size_t faces = 0;
    for (const FaceHandle fh : mesh.vf_range(vh)) {
      if (!is_quad(mesh, fh)) return;
      ++faces;
    }
    ++count;
    if (faces != 4) ++irregular;
  }

  InnerVertices& operator+=(const InnerVertices& other) {
    count += other.count;
    irregular += other.irregular;
    return *this;
  }
};

double irregular_share(const PolyMesh& mesh) {
  const auto inner = sum_of_ranges(mesh.n_vertices(), [&](std::size_t first, std::size_t end) {
    InnerVertices own;
    for (std::size_t v = first; v < end; ++v) own.add(mesh, VertexHandle(static_cast<int>(v)));
    return own;
  });
  if (inner.count == 0) return 0;
  return static_cast<double>(inner.irregular) / static_cast<double>(inner.count);
}

}  // namespace

std::vector<double> quad_jacobians(const PolyMesh& mesh) {
  return jacobians_of(mesh, measure_all(mesh));
}

double quad_space_jacobian(const PolyMesh& mesh, FaceHandle quad) {
  return least(sines_in_space(mesh, quad_sides(mesh, mesh.halfedge_handle(quad))));
}

QuadStatistics measure_quads(const PolyMesh& mesh) {
  const QuadSums sums = sum_quads(mesh);
  QuadStatistics result;
  result.count = sums.count;
  if (sums.count == 0) return result;
  result.fraction = static_cast<double>(sums.count) / static_cast<double>(mesh.n_faces());
  if (find(mesh, keys::face_patch).is_valid()) {
    result.min_of_patches = detail::least_of_patches(sums.of_patches);
  }
  result.histogram = sums.histogram;
  result.inverted = sums.inverted;
  result.flat = sums.flat;
  result.folded = sums.folded;
  result.min_jacobian = sums.worst.value;
  result.worst_face = sums.worst.face;
  result.min_space_jacobian = sums.worst_in_space.value;
  result.worst_face_in_space = sums.worst_in_space.face;
  result.mean_jacobian = sums.in_metric.mean();
  result.mean_space_jacobian = sums.in_space.mean();
  result.irregular_share = irregular_share(mesh);
  return result;
}

}  // namespace surfmesh
