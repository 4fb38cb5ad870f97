// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/face_parameters.hh"

#include <algorithm>
#include <cmath>
#include <optional>

#include "surfmesh/metric/tensor.hh"

namespace surfmesh {
namespace {

/// A place counts as that which a straight step leads to if it is nearer than this share of it.
constexpr double kSamePlace = 0.5;

/// Sine of the angle in (u,v) below which two sides tell no metric.
constexpr double kFlatCorner = 1e-6;

bool lies_on(const FaceCornerSites& corner, int patch) {
  return std::ranges::any_of(corner.sites,
                             [patch](const InPatch& site) { return site.patch == patch; });
}

/// The patches of the corners, those on which most of them lie first, then the least number.
std::vector<int> patches_of(std::span<const FaceCornerSites> corners) {
  std::vector<int> patches;
  for (const FaceCornerSites& corner : corners) {
    for (const InPatch& site : corner.sites) patches.push_back(site.patch);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  const auto count = [&](int patch) {
    return std::ranges::count_if(
        corners, [patch](const FaceCornerSites& corner) { return lies_on(corner, patch); });
  };
  std::ranges::stable_sort(patches, [&](int a, int b) { return count(a) > count(b); });
  return patches;
}

/// Where a point lies in (u,v) as the tangent plane of a chart goes on.
Uv beside(const VertexChart& chart, const Vec3& point) {
  const Vec3 step = chart.in_chart(point - chart.point);
  return chart.place.uv + chart.in_parameters({step.x(), step.y()});
}

/// The metric in which two steps in (u,v) have the lengths, and the angle between them, of steps in
/// a chart; nothing if they are parallel.
std::optional<Metric> metric_of(Uv a, Uv b, const Vec3& in_chart_a, const Vec3& in_chart_b) {
  const double area = cross(a, b);
  const double squares = (a.u * a.u + a.v * a.v) * (b.u * b.u + b.v * b.v);
  if (!(area * area > kFlatCorner * kFlatCorner * squares)) return {};
  const double aa = in_chart_a.squaredNorm(), ab = in_chart_a.dot(in_chart_b),
               bb = in_chart_b.squaredNorm();
  const double scale = 1 / (area * area);
  return Metric{scale * (aa * b.v * b.v - 2 * ab * a.v * b.v + bb * a.v * a.v),
                scale * (-aa * b.u * b.v + ab * (a.u * b.v + a.v * b.u) - bb * a.u * a.v),
                scale * (aa * b.u * b.u - 2 * ab * a.u * b.u + bb * a.u * a.u)};
}

}  // namespace

/// The site of a corner on the patch of an anchor next to that; null if it has none.
const InPatch* FaceParameters::site_beside(const Anchor& anchor,
                                           const FaceCornerSites& corner) const {
  const int patch = anchor.chart.place.patch;
  const InPatch* nearest = nullptr;
  double least = INFINITY;
  const Uv at = beside(anchor.chart, corner.chart->point);
  for (const InPatch& site : corner.sites) {
    if (site.patch != patch) continue;
    if (!maker_.meets_itself(patch)) return &site;
    const double distance = squared_length(anchor.chart.metric, site.uv - at);
    if (distance >= least) continue;
    least = distance;
    nearest = &site;
  }
  const double way = squared_length(anchor.chart.metric, at - anchor.chart.place.uv);
  return least <= kSamePlace * kSamePlace * way ? nearest : nullptr;
}

/// The corners on the patch, the first of them one that lies only once on it, if there is one.
/// Corners that do not lie beside that are left out.
std::vector<FaceParameters::Anchor> FaceParameters::anchors_on(
    int patch, std::span<const FaceCornerSites> corners) const {
  std::vector<Anchor> anchors;
  const auto add = [&](std::size_t k, const InPatch& site) {
    const SurfacePlace place{patch, site.uv};
    if (corners[k].chart->place == place) {
      anchors.push_back({k, *corners[k].chart});
    } else if (const auto made = maker_.make(place, site.metric)) {
      anchors.push_back({k, *made});
    }
  };
  for (const long most_sites : {1L, 2L, 1000L}) {
    for (std::size_t k = 0; k < corners.size() && anchors.empty(); ++k) {
      const long count = std::ranges::count_if(
          corners[k].sites, [patch](const InPatch& site) { return site.patch == patch; });
      if (count == 0 || count > most_sites) continue;
      add(k, *std::ranges::find_if(corners[k].sites,
                                   [patch](const InPatch& site) { return site.patch == patch; }));
    }
  }
  if (anchors.empty()) return anchors;
  const std::size_t first = anchors.front().corner;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (k == first) continue;
    if (const InPatch* site = site_beside(anchors.front(), corners[k])) add(k, *site);
  }
  return anchors;
}

/// The face on a patch.
FaceParameters::Attempt FaceParameters::find_on(int patch,
                                                std::span<const FaceCornerSites> corners) const {
  Attempt attempt;
  FaceInPatch& face = attempt.face;
  face.patch = patch;
  const std::vector<Anchor> anchors = anchors_on(patch, corners);
  if (anchors.empty()) return attempt;
  attempt.is_found = true;
  std::array<bool, 4> is_on_patch{};
  for (const Anchor& anchor : anchors) {
    is_on_patch[anchor.corner] = true;
    face.uvs[anchor.corner] = anchor.chart.place.uv;
    face.metrics[anchor.corner] = anchor.chart.metric;
  }
  if (anchors.size() == corners.size()) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const bool is_of_patch = corners[k].chart->place.patch == patch;
      if (corners[k].is_singular || !is_of_patch) set_metric(corners, k, face);
    }
    return attempt;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (is_on_patch[k]) continue;
    face.is_beyond[k] = true;
    Uv sum{0, 0};
    for (const Anchor& anchor : anchors) sum = sum + beside(anchor.chart, corners[k].chart->point);
    face.uvs[k] = 1 / static_cast<double>(anchors.size()) * sum;
  }
  attempt.is_found = set_metrics(corners, face);
  return attempt;
}

/// Let a corner see the sides of the face as its vertex does.
/// Returns  false if the face is not as convex there in (u,v) as it is to the vertex
bool FaceParameters::set_metric(std::span<const FaceCornerSites> corners, std::size_t k,
                                FaceInPatch& face) const {
  const std::size_t count = corners.size();
  const std::size_t next = (k + 1) % count, previous = (k + count - 1) % count;
  const VertexChart& chart = *corners[k].chart;
  const Uv ahead = face.uvs[next] - face.uvs[k], back = face.uvs[previous] - face.uvs[k];
  const Vec3 a = chart.in_chart(corners[next].chart->point - chart.point);
  const Vec3 b = chart.in_chart(corners[previous].chart->point - chart.point);
  const auto metric = metric_of(ahead, back, a, b);
  if (metric) {
    face.metrics[k] = *metric;
  } else if (!std::isfinite(face.metrics[k].m11)) {
    face.metrics[k] = chart.metric;
  }
  const double sign = maker_.is_turned(face.patch) ? -1 : 1;
  return metric && sign * cross(ahead, back) * (a.x() * b.y() - a.y() * b.x()) > 0;
}

bool FaceParameters::set_metrics(std::span<const FaceCornerSites> corners,
                                 FaceInPatch& face) const {
  bool is_alike = true;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    is_alike = set_metric(corners, k, face) && is_alike;
  }
  return is_alike;
}

/// The face as the tangent plane of its first corner on the patch sees it.
FaceInPatch FaceParameters::flattened(int patch, std::span<const FaceCornerSites> corners,
                                      FaceInPatch face) const {
  const std::vector<Anchor> anchors = anchors_on(patch, corners);
  if (anchors.empty()) return face;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    face.uvs[k] = beside(anchors.front().chart, corners[k].chart->point);
    face.is_beyond[k] = k != anchors.front().corner;
  }
  set_metrics(corners, face);
  return face;
}

FaceInPatch FaceParameters::find(std::span<const FaceCornerSites> corners) const {
  const std::vector<int> patches = patches_of(corners);
  std::optional<FaceInPatch> first;
  for (const int patch : patches) {
    const Attempt attempt = find_on(patch, corners);
    if (attempt.is_found) return attempt.face;
    if (!first) first = attempt.face;
  }
  return flattened(patches.front(), corners, *first);
}

}  // namespace surfmesh
