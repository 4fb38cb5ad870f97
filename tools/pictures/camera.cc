// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/camera.hh"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surfmesh {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// A direction in axes of which the third is upwards.
Vec3 turned(const Vec3& p, Axis up) {
  switch (up) {
    case Axis::X:
      return {p.z(), p.x(), p.y()};
    case Axis::Y:
      return {p.y(), p.z(), p.x()};
    case Axis::Z:
      break;
  }
  return p;
}

}  // namespace

PlaneView::PlaneView(const Eigen::AlignedBox2d& box, const PictureFrame& frame)
    : centre_(box.center()),
      middle_{frame.corner.x + 0.5 * frame.width, frame.corner.y + 0.5 * frame.height},
      scale_(std::min(frame.width / box.sizes().x(), frame.height / box.sizes().y())) {
  if (!std::isfinite(scale_)) scale_ = 1;  // of a point
}

PicturePoint PlaneView::operator()(double x, double y) const {
  return {middle_.x + scale_ * (x - centre_.x()), middle_.y - scale_ * (y - centre_.y())};
}

CameraAxes::CameraAxes(const Camera& camera) {
  const double a = radians(camera.azimuth), e = radians(camera.elevation);
  towards = turned({std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)}, camera.up);
  right = turned({-std::sin(a), std::cos(a), 0}, camera.up);
  up = towards.cross(right);
}

}  // namespace surfmesh
