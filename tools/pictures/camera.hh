// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "pictures/canvas.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Maps a rectangle of a plane to a frame: as large as it fits, in the middle, y upwards.
class PlaneView {
 public:
  PlaneView(const Eigen::AlignedBox2d& box, const PictureFrame& frame);

  PicturePoint operator()(double x, double y) const;
  double scale() const { return scale_; }  ///< pixels per unit

 private:
  Eigen::Vector2d centre_;
  PicturePoint middle_;
  double scale_;
};

enum class Axis { X, Y, Z };

/// How rays come to the eye.
enum class Lens { Parallel, Perspective };

/// From where a surface is looked at.
struct Camera {
  double azimuth = -60;   ///< degrees counter-clockwise around `up`, of where the camera stands
  double elevation = 35;  ///< degrees
  Axis up = Axis::Z;
  Lens lens = Lens::Parallel;
};

/// The axes of a camera: to the right, upwards, and towards the camera.
struct CameraAxes {
  Vec3 right, up, towards;

  explicit CameraAxes(const Camera& camera);
};

}  // namespace surfmesh
