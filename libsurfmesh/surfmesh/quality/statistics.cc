// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quality/statistics.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/metric/triangle.hh"
#include "surfmesh/quality/moments.hh"
#include "surfmesh/quality/quality_histogram.hh"
#include "surfmesh/quality/result_corners.hh"

namespace surfmesh {
namespace {

constexpr double kPoorQuality = 0.3;

constexpr int kBinsPerOctave = 4;
constexpr int kOctaves = 2;  // each way from 1

double bin_limit(int i) { return std::exp2(static_cast<double>(i) / kBinsPerOctave - kOctaves); }

/// The bin of a length by its logarithm; those beyond the ends fall into the first and last one.
std::size_t bin_of(double length, std::size_t bins) {
  const double position = (std::log2(length) + kOctaves) * kBinsPerOctave;
  return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(bins - 1)));
}

std::vector<HistogramBin> empty_histogram() {
  std::vector<HistogramBin> bins;
  for (int i = 0; i < 2 * kOctaves * kBinsPerOctave; ++i) {
    bins.push_back({i == 0 ? 0 : bin_limit(i), bin_limit(i + 1), 0});
  }
  return bins;
}

using detail::Moments;
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

struct Triangle {
  int face;
  int patch;
  double area_uv;
  double quality;  // as seen in (u,v)
};

Triangle measure_triangle(const Corners& corners, FaceHandle fh, int patch) {
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
  return {fh.idx(), patch, 0.5 * cross(b - a, c - a), quality};
}

std::vector<Triangle> measure_triangles(const PolyMesh& mesh) {
  const Corners corners(mesh);
  const auto patch = find(mesh, keys::face_patch);
  std::vector<FaceHandle> faces;
  faces.reserve(mesh.n_faces());
  for (const FaceHandle fh : mesh.faces()) {
    if (mesh.valence(fh) == 3) faces.push_back(fh);
  }
  std::vector<Triangle> triangles(faces.size());
  share_ranges(faces.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const int own = patch.is_valid() ? mesh.property(patch, faces[i]) : 0;
      triangles[i] = measure_triangle(corners, faces[i], own);
    }
  });
  return triangles;
}

/// By patch; empty where no face has one.
std::vector<double> least_of_patches(const std::vector<Triangle>& triangles) {
  int most = -1;
  for (const Triangle& triangle : triangles) most = std::max(most, triangle.patch);
  std::vector<double> least(static_cast<std::size_t>(most + 1),
                            std::numeric_limits<double>::infinity());
  for (const Triangle& triangle : triangles) {
    if (triangle.patch < 0) continue;
    double& own = least[static_cast<std::size_t>(triangle.patch)];
    own = std::min(own, triangle.quality);
  }
  return least;
}

/// Triangles of patches that lie the other way round count as turned back.
void turn_back(std::vector<Triangle>& triangles) {
  std::unordered_map<int, double> patch_area;
  for (const Triangle& triangle : triangles) patch_area[triangle.patch] += triangle.area_uv;
  for (Triangle& triangle : triangles) {
    if (patch_area.at(triangle.patch) < 0) triangle.quality = -triangle.quality;
  }
}

}  // namespace

bool has_parameters(const PolyMesh& mesh) {
  const auto uv_of = find(mesh, keys::corner_uv);
  if (!uv_of.is_valid() || !find(mesh, keys::face_patch).is_valid()) return false;
  const auto corners = mesh.halfedges();
  return std::all_of(corners.begin(), corners.end(), [&](HalfedgeHandle heh) {
    const Uv uv = mesh.property(uv_of, heh);
    return mesh.is_boundary(heh) || (std::isfinite(uv.u) && std::isfinite(uv.v));
  });
}

bool has_metric(const PolyMesh& mesh) {
  const auto metric_of = find(mesh, keys::corner_metric);
  if (!metric_of.is_valid()) return false;
  const auto corners = mesh.halfedges();
  return std::all_of(corners.begin(), corners.end(), [&](HalfedgeHandle heh) {
    return mesh.is_boundary(heh) || std::isfinite(mesh.property(metric_of, heh).m11);
  });
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
  std::vector<Triangle> triangles = measure_triangles(mesh);
  turn_back(triangles);
  std::vector<double> of_faces(mesh.n_faces(), kUnset);
  for (const Triangle& triangle : triangles) {
    of_faces[static_cast<std::size_t>(triangle.face)] = triangle.quality;
  }
  return of_faces;
}

EdgeStatistics measure_edges(const PolyMesh& mesh) {
  const std::vector<double> lengths = metric_lengths(mesh);
  EdgeStatistics result;
  result.histogram = empty_histogram();
  result.count = mesh.n_edges();
  if (result.count == 0) return result;
  Moments moments;
  std::size_t unit = 0;
  result.min = std::numeric_limits<double>::infinity();
  for (const double length : lengths) {
    moments.add(length);
    result.min = std::min(result.min, length);
    result.max = std::max(result.max, length);
    if (length >= kShortestUnit && length <= kLongestUnit) ++unit;
    ++result.histogram[bin_of(length, result.histogram.size())].count;
  }
  result.mean = moments.mean();
  result.stddev = moments.stddev();
  result.unit_fraction = static_cast<double>(unit) / static_cast<double>(result.count);
  result.histogram.back().to = std::max(result.histogram.back().to, result.max);
  return result;
}

QualityStatistics measure_quality(const PolyMesh& mesh) {
  std::vector<Triangle> triangles = measure_triangles(mesh);
  QualityStatistics result;
  result.count = triangles.size();
  if (triangles.empty()) return result;
  turn_back(triangles);
  if (find(mesh, keys::face_patch).is_valid()) result.min_of_patches = least_of_patches(triangles);
  Moments moments;
  result.histogram = detail::empty_quality_histogram();
  std::size_t poor = 0;
  result.min = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles) {
    const double quality = triangle.quality;
    moments.add(quality);
    detail::count_quality(quality, result.histogram);
    if (quality < result.min) {
      result.min = quality;
      result.worst_face = triangle.face;
    }
    if (quality < kPoorQuality) ++poor;
  }
  result.mean = moments.mean();
  result.below_0_3 = static_cast<double>(poor) / static_cast<double>(result.count);
  return result;
}

}  // namespace surfmesh
