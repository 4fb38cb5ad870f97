// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/statistics.hh"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/moments.hh"
#include "surfmesh/quality/patch_runs.hh"
#include "surfmesh/quality/quality_histogram.hh"
#include "surfmesh/quality/result_corners.hh"

namespace surfmesh {
namespace {

using Corners = detail::ResultCorners;

/// Length of a step, 0 where rounding has made a singular metric negative; NaN stays NaN.
double length_in(const Metric& m, Uv step) {
  return std::sqrt(std::max(squared_length(m, step), 0.0));
}

double metric_length(const Corners& corners, EdgeHandle eh) {
  HalfedgeHandle tip = corners.mesh.halfedge_handle(eh, 0);
  if (corners.mesh.is_boundary(tip)) tip = corners.mesh.halfedge_handle(eh, 1);
  const HalfedgeHandle tail = corners.mesh.prev_halfedge_handle(tip);
  const Uv step = corners.uv(tip) - corners.uv(tail);
  const double length =
      edge_length(length_in(corners.metric(tail), step), length_in(corners.metric(tip), step));
  if (!std::isfinite(length)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("edge {}: (u,v) or the metric of a corner is not set", eh.idx()));
  }
  return length;
}

bool is_triangle(const PolyMesh& mesh, FaceHandle fh) {
  const HalfedgeHandle heh = mesh.halfedge_handle(fh);
  const HalfedgeHandle third = mesh.next_halfedge_handle(mesh.next_halfedge_handle(heh));
  return third != heh && mesh.next_halfedge_handle(third) == heh;
}

struct Triangle {
  double area_uv;
  double quality;  // as seen in (u,v)
};

Triangle measure_triangle(const Corners& corners, FaceHandle fh) {
  const HalfedgeHandle h0 = corners.mesh.halfedge_handle(fh);
  const HalfedgeHandle h1 = corners.mesh.next_halfedge_handle(h0);
  const HalfedgeHandle h2 = corners.mesh.next_halfedge_handle(h1);
  const Uv a = corners.uv(h0), b = corners.uv(h1), c = corners.uv(h2);
  const Metric m = mean(corners.metric(h0), corners.metric(h1), corners.metric(h2));
  const double quality = triangle_quality(a, b, c, m);
  if (!std::isfinite(quality)) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("face {}: (u,v) or the metric of a corner is not set", fh.idx()));
  }
  return {0.5 * cross(b - a, c - a), quality};
}

using PatchAreas = detail::PatchRuns<double>;

/// Sets the qualities as seen in (u,v), by face, of triangles.
/// Returns  the areas of patches in (u,v)
PatchAreas measure_triangles(const PolyMesh& mesh, std::vector<double>& qualities) {
  const Corners corners(mesh);
  const detail::PatchOf patch_of(mesh);
  return sum_of_ranges(qualities.size(), [&](std::size_t first, std::size_t end) {
    PatchAreas areas;
    for (std::size_t f = first; f < end; ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (!is_triangle(mesh, fh)) continue;
      const Triangle triangle = measure_triangle(corners, fh);
      qualities[f] = triangle.quality;
      areas.next(patch_of(f)) += triangle.area_uv;
    }
    return areas;
  });
}

/// Patches that lie the other way round.
std::unordered_set<int> turned_patches(const PatchAreas& areas) {
  std::unordered_map<int, double> sums;
  for (const auto& [patch, area] : areas) sums[patch] += area;
  std::unordered_set<int> turned;
  for (const auto& [patch, area] : sums) {
    if (area < 0) turned.insert(patch);
  }
  return turned;
}

struct LengthSums {
  detail::Moments moments;
  std::size_t unit = 0;
  double min = std::numeric_limits<double>::infinity();
  double max = 0;
  std::vector<HistogramBin> histogram = detail::empty_length_histogram();

  void add(double length) {
    moments.add(length);
    min = std::min(min, length);
    max = std::max(max, length);
    if (length >= kShortestUnit && length <= kLongestUnit) ++unit;
    ++histogram[detail::length_bin(length, histogram.size())].count;
  }

  LengthSums& operator+=(const LengthSums& other) {
    moments += other.moments;
    unit += other.unit;
    min = std::min(min, other.min);
    max = std::max(max, other.max);
    detail::add_counts(other.histogram, histogram);
    return *this;
  }
};

struct QualitySums {
  detail::Moments moments;
  std::size_t count = 0;
  std::size_t poor = 0;
  detail::Least least;
  int worst_face = -1;
  detail::PatchRuns<detail::Least> of_patches;
  std::vector<HistogramBin> histogram = detail::empty_quality_histogram();

  void add(std::size_t face, int patch, double quality) {
    moments.add(quality);
    ++count;
    detail::count_quality(quality, histogram);
    take_worst(quality, static_cast<int>(face));
    if (quality < detail::kPoorQuality) ++poor;
    double& own = of_patches.next(patch).value;
    own = std::min(own, quality);
  }

  QualitySums& operator+=(const QualitySums& other) {
    moments += other.moments;
    count += other.count;
    poor += other.poor;
    take_worst(other.least.value, other.worst_face);
    of_patches += other.of_patches;
    detail::add_counts(other.histogram, histogram);
    return *this;
  }

 private:
  void take_worst(double quality, int face) {
    if (!(quality < least.value)) return;
    least.value = quality;
    worst_face = face;
  }
};

/// A condition for all halfedges.
template <class Condition>
bool holds_for_corners(const PolyMesh& mesh, Condition holds) {
  std::atomic<bool> all = true;
  share_ranges(mesh.n_halfedges(), [&](std::size_t first, std::size_t end) {
    for (std::size_t h = first; h < end && all; ++h) {
      const HalfedgeHandle heh(static_cast<int>(h));
      if (!mesh.is_boundary(heh) && !holds(heh)) all = false;
    }
  });
  return all;
}

}  // namespace

bool has_parameters(const PolyMesh& mesh) {
  const auto uv_of = find(mesh, keys::corner_uv);
  if (!uv_of.is_valid() || !find(mesh, keys::face_patch).is_valid()) return false;
  return holds_for_corners(mesh, [&](HalfedgeHandle heh) {
    const Uv uv = mesh.property(uv_of, heh);
    return std::isfinite(uv.u) && std::isfinite(uv.v);
  });
}

bool has_metric(const PolyMesh& mesh) {
  const auto metric_of = find(mesh, keys::corner_metric);
  if (!metric_of.is_valid()) return false;
  return holds_for_corners(
      mesh, [&](HalfedgeHandle heh) { return std::isfinite(mesh.property(metric_of, heh).m11); });
}

std::vector<double> metric_lengths(const PolyMesh& mesh) {
  const Corners corners(mesh);
  std::vector<double> lengths(mesh.n_edges());
  share_ranges(lengths.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t e = first; e < end; ++e) {
      lengths[e] = metric_length(corners, EdgeHandle(static_cast<int>(e)));
    }
  });
  return lengths;
}

std::vector<double> triangle_qualities(const PolyMesh& mesh) {
  std::vector<double> qualities(mesh.n_faces(), kUnset);
  const std::unordered_set<int> turned = turned_patches(measure_triangles(mesh, qualities));
  if (turned.empty()) return qualities;
  const detail::PatchOf patch_of(mesh);
  share_ranges(qualities.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f) {
      if (turned.contains(patch_of(f))) qualities[f] = -qualities[f];
    }
  });
  return qualities;
}

EdgeStatistics measure_edges(const PolyMesh& mesh) {
  const std::vector<double> lengths = metric_lengths(mesh);
  const LengthSums sums = sum_of_ranges(lengths.size(), [&](std::size_t first, std::size_t end) {
    LengthSums own;
    for (std::size_t e = first; e < end; ++e) own.add(lengths[e]);
    return own;
  });
  EdgeStatistics result;
  result.histogram = sums.histogram;
  result.count = mesh.n_edges();
  if (result.count == 0) return result;
  result.min = sums.min;
  result.max = sums.max;
  result.mean = sums.moments.mean();
  result.stddev = sums.moments.stddev();
  result.unit_fraction = static_cast<double>(sums.unit) / static_cast<double>(result.count);
  result.histogram.back().to = std::max(result.histogram.back().to, result.max);
  return result;
}

QualityStatistics measure_quality(const PolyMesh& mesh) {
  const std::vector<double> qualities = triangle_qualities(mesh);
  const detail::PatchOf patch_of(mesh);
  const QualitySums sums = sum_of_ranges(qualities.size(), [&](std::size_t first, std::size_t end) {
    QualitySums own;
    for (std::size_t f = first; f < end; ++f) {
      if (!std::isnan(qualities[f])) own.add(f, patch_of(f), qualities[f]);
    }
    return own;
  });
  QualityStatistics result;
  result.count = sums.count;
  if (sums.count == 0) return result;
  if (find(mesh, keys::face_patch).is_valid()) {
    result.min_of_patches = detail::least_of_patches(sums.of_patches);
  }
  result.histogram = sums.histogram;
  result.min = sums.least.value;
  result.worst_face = sums.worst_face;
  result.mean = sums.moments.mean();
  result.below_0_3 = static_cast<double>(sums.poor) / static_cast<double>(result.count);
  return result;
}

}  // namespace surfmesh
