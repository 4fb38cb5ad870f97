// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/depth_buffer.hh"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// Rows of samples that one thread draws at a time.
constexpr std::size_t kSampleRows = 64;

/// Steps of the lattice of corners to a sample. On pictures of 2^16 samples, the products that
/// tell on which side of a line a sample lies are exact, so that triangles with one side leave no
/// gap.
constexpr double kLattice = 256;

/// What lies so much behind, in pixels, is not hidden: the line between two faces is in both.
constexpr double kSameDepth = 0.25;

}  // namespace

DepthPlane::DepthPlane(const std::array<ScenePoint, 3>& corners) : origin_(corners[0]) {
  const auto& [a, b, c] = corners;
  const auto [least, greatest] = std::minmax({a.depth, b.depth, c.depth});
  least_ = least;
  greatest_ = greatest;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (!(area > 0) && !(area < 0)) return;
  const double db = b.depth - a.depth, dc = c.depth - a.depth;
  slope_x_ = (db * (c.y - a.y) - dc * (b.y - a.y)) / area;
  slope_y_ = (dc * (b.x - a.x) - db * (c.x - a.x)) / area;
}

double DepthPlane::at(double x, double y) const {
  const double depth = origin_.depth + slope_x_ * (x - origin_.x) + slope_y_ * (y - origin_.y);
  return std::clamp(depth, least_, greatest_);
}

ScenePoint DepthBuffer::on_lattice(const ScenePoint& point) const {
  const auto moved = [this](double pixels) {
    return std::round(kLattice * samples_ * pixels) / kLattice;
  };
  return {moved(point.x), moved(point.y), point.depth};
}

std::array<ScenePoint, 3> DepthBuffer::corners(const SceneTriangle& triangle) const {
  std::array<ScenePoint, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = on_lattice(scene_.points[static_cast<std::size_t>(triangle.points[i])]);
  }
  return result;
}

/// The triangles that touch each band of rows, in the order of their indices.
class DepthBuffer::Rows {
 public:
  Rows(const DepthBuffer& buffer, std::size_t bands) : ends_(bands + 1, 0) {
    const auto& triangles = buffer.scene_.triangles;
    std::vector<std::pair<std::size_t, std::size_t>> ranges(triangles.size());
    share_ranges(triangles.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t t = first; t < end; ++t)
        ranges[t] = range(buffer.corners(triangles[t]), bands);
    });
    for (const auto& [first, end] : ranges) {
      for (std::size_t band = first; band < end; ++band) ++ends_[band + 1];
    }
    for (std::size_t band = 1; band <= bands; ++band) ends_[band] += ends_[band - 1];
    members_.resize(ends_.back());
    std::vector<std::size_t> next(ends_.begin(), ends_.end() - 1);
    for (std::size_t t = 0; t < ranges.size(); ++t) {
      for (std::size_t band = ranges[t].first; band < ranges[t].second; ++band) {
        members_[next[band]++] = static_cast<int>(t);
      }
    }
  }

  std::span<const int> of(std::size_t band) const {
    return std::span(members_).subspan(ends_[band], ends_[band + 1] - ends_[band]);
  }

 private:
  static std::pair<std::size_t, std::size_t> range(const std::array<ScenePoint, 3>& corners,
                                                   std::size_t bands) {
    const auto& [a, b, c] = corners;
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    const auto band_of = [bands](double y) {
      return static_cast<std::size_t>(
          std::clamp(std::floor(y / kSampleRows), 0.0, static_cast<double>(bands)));
    };
    if (!(high >= 0) || !std::isfinite(low)) return {0, 0};
    return {band_of(low), std::min(bands, band_of(high) + 1)};
  }

  std::vector<std::size_t> ends_;
  std::vector<int> members_;
};

DepthBuffer::DepthBuffer(const Scene& scene, std::size_t width, std::size_t height, int samples)
    : scene_(scene),
      samples_(samples),
      columns_(width * static_cast<std::size_t>(samples)),
      rows_(height * static_cast<std::size_t>(samples)),
      front_(columns_ * rows_, -1) {
  const std::size_t bands = (rows_ + kSampleRows - 1) / kSampleRows;
  const Rows triangles(*this, bands);
  share_indices(bands, [&](std::size_t band) {
    const std::size_t first = band * kSampleRows, end = std::min(rows_, first + kSampleRows);
    std::vector<double> depths(columns_ * (end - first), -std::numeric_limits<double>::infinity());
    for (const int t : triangles.of(band)) {
      const std::array<ScenePoint, 3> corners =
          this->corners(scene_.triangles[static_cast<std::size_t>(t)]);
      const DepthPlane plane(corners);
      for_samples_in(corners, columns_, first, end, [&](std::size_t column, std::size_t row) {
        const double depth = plane.at(double(column) + 0.5, double(row) + 0.5);
        double& nearest = depths[(row - first) * columns_ + column];
        if (!(depth > nearest)) return;
        nearest = depth;
        front_[row * columns_ + column] = t;
      });
    }
  });
}

bool DepthBuffer::is_visible(const ScenePoint& point) const {
  const double x = samples_ * point.x, y = samples_ * point.y;
  if (!(x >= 0 && x <= double(columns_) && y >= 0 && y <= double(rows_))) return false;
  const std::array<double, 2> offsets = {-0.5, 0.5};
  for (const double dy : offsets) {
    for (const double dx : offsets) {
      const auto column = static_cast<std::size_t>(std::clamp(x + dx, 0.0, double(columns_ - 1)));
      const auto row = static_cast<std::size_t>(std::clamp(y + dy, 0.0, double(rows_ - 1)));
      const int t = front(column, row);
      if (t < 0) return true;
      const DepthPlane plane(corners(scene_.triangles[static_cast<std::size_t>(t)]));
      if (point.depth >= plane.at(x, y) - kSameDepth) return true;
    }
  }
  return false;
}

}  // namespace surfmesh
