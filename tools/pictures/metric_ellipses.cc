// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/metric_ellipses.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "surfmesh/core/properties.hh"

namespace surfmesh {
namespace {

constexpr int kOutlinePoints = 40;

/// Least mean radius of the middle ellipse, in pixels, and room between those that touch.
constexpr double kLeastRadius = 7, kShrink = 0.92;

/// Ellipses that are smaller, or larger, are not seen as such: pixels.
constexpr double kSmallest = 0.5;

/// An ellipse: its middle and its two half axes, not perpendicular, in pixels.
struct Ellipse {
  PicturePoint middle, one, other;

  double mean_radius() const { return std::sqrt(std::abs(one.x * other.y - one.y * other.x)); }

  PicturePoint at(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {middle.x + c * one.x + s * other.x, middle.y + c * one.y + s * other.y};
  }
};

/// All steps of metric length ½ from a point: with M = L Lᵀ they are L⁻ᵀ times a circle.
Ellipse ellipse_of(Uv uv, const Metric& m, const std::function<PicturePoint(Uv)>& place) {
  const double l11 = std::sqrt(m.m11), l21 = m.m12 / l11, l22 = std::sqrt(m.m22 - l21 * l21);
  const PicturePoint middle = place(uv);
  const auto step = [&](Uv by) -> PicturePoint {
    const PicturePoint to = place(uv + 0.5 * by);
    return {to.x - middle.x, to.y - middle.y};
  };
  return {middle, step({1 / l11, 0}), step({-l21 / (l11 * l22), 1 / l22})};
}

std::vector<Ellipse> all_ellipses(const PolyMesh& mesh, int patch,
                                  const std::function<PicturePoint(Uv)>& place) {
  const auto uv_of = require(mesh, keys::corner_uv);
  const auto metric_of = require(mesh, keys::corner_metric);
  const auto patch_of = find(mesh, keys::face_patch);
  const auto beyond = find(mesh, keys::corner_beyond);
  std::vector<char> is_done(mesh.n_vertices(), 0);
  std::vector<Ellipse> ellipses;
  for (const FaceHandle fh : mesh.faces()) {
    if (patch_of.is_valid() && mesh.property(patch_of, fh) != patch) continue;
    for (const HalfedgeHandle heh : mesh.fh_range(fh)) {
      char& done = is_done[index(mesh.to_vertex_handle(heh))];
      if (done != 0 || (beyond.is_valid() && mesh.property(beyond, heh) != 0)) continue;
      done = 1;
      const Ellipse ellipse =
          ellipse_of(mesh.property(uv_of, heh), mesh.property(metric_of, heh), place);
      if (std::isfinite(ellipse.mean_radius())) ellipses.push_back(ellipse);
    }
  }
  return ellipses;
}

double middle_radius(const std::vector<Ellipse>& ellipses) {
  std::vector<double> radii;
  for (const Ellipse& ellipse : ellipses) radii.push_back(ellipse.mean_radius());
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

/// Which pixels are taken.
class Taken {
 public:
  explicit Taken(const PictureFrame& frame)
      : frame_(frame),
        width_(static_cast<std::size_t>(frame.width) + 1),
        height_(static_cast<std::size_t>(frame.height) + 1),
        is_taken_(width_ * height_, 0) {}

  /// Take the pixels of an ellipse, if all of them are in the frame and free.
  bool take(const Ellipse& ellipse) {
    std::vector<std::size_t> own;
    const double dx = std::hypot(ellipse.one.x, ellipse.other.x),
                 dy = std::hypot(ellipse.one.y, ellipse.other.y);
    const PicturePoint middle{ellipse.middle.x - frame_.corner.x,
                              ellipse.middle.y - frame_.corner.y};
    if (!(middle.x - dx >= 0 && middle.x + dx < frame_.width && middle.y - dy >= 0 &&
          middle.y + dy < frame_.height)) {
      return false;
    }
    const double area = ellipse.one.x * ellipse.other.y - ellipse.one.y * ellipse.other.x;
    for (auto y = static_cast<std::size_t>(middle.y - dy); double(y) <= middle.y + dy; ++y) {
      for (auto x = static_cast<std::size_t>(middle.x - dx); double(x) <= middle.x + dx; ++x) {
        const double px = double(x) + 0.5 - middle.x, py = double(y) + 0.5 - middle.y;
        const double a = (px * ellipse.other.y - py * ellipse.other.x) / area,
                     b = (ellipse.one.x * py - ellipse.one.y * px) / area;
        if (a * a + b * b > 1) continue;
        if (is_taken_[y * width_ + x] != 0) return false;
        own.push_back(y * width_ + x);
      }
    }
    for (const std::size_t i : own) is_taken_[i] = 1;
    return true;
  }

 private:
  PictureFrame frame_;
  std::size_t width_;
  std::size_t height_;
  std::vector<char> is_taken_;
};

}  // namespace

MetricEllipses metric_ellipses(const PolyMesh& mesh, int patch,
                               const std::function<PicturePoint(Uv)>& place,
                               const PictureFrame& frame) {
  std::vector<Ellipse> ellipses = all_ellipses(mesh, patch, place);
  MetricEllipses result;
  if (ellipses.empty()) return result;
  result.factor = std::max(1.0, kLeastRadius / middle_radius(ellipses));
  const double scale = kShrink * result.factor;
  Taken taken(frame);
  for (Ellipse& ellipse : ellipses) {
    ellipse.one = {scale * ellipse.one.x, scale * ellipse.one.y};
    ellipse.other = {scale * ellipse.other.x, scale * ellipse.other.y};
    if (ellipse.mean_radius() < kSmallest || !taken.take(ellipse)) continue;
    PicturePoints& outline = result.outlines.emplace_back();
    for (int i = 0; i < kOutlinePoints; ++i) {
      outline.push_back(ellipse.at(2 * std::numbers::pi * i / kOutlinePoints));
    }
  }
  return result;
}

}  // namespace surfmesh
