// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "pictures/svg.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// A part of a picture, pixels.
struct PictureFrame {
  PicturePoint corner;  ///< upper left
  double width = 0;
  double height = 0;
};

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

/// The edges of a mesh as a few long lines that run through each of them once: a file of them is
/// less than half as long as one of edges.
std::vector<std::vector<PicturePoint>> edge_lines(
    const PolyMesh& mesh, const std::function<PicturePoint(VertexHandle)>& at);

/// From where a surface is looked at, in parallel rays: degrees.
struct Camera {
  double azimuth = -60;  ///< from the x axis counter-clockwise, of where the camera stands
  double elevation = 35;
};

/// What part of a mesh in space is drawn, and how.
struct SurfaceView {
  Camera camera = {};
  Eigen::AlignedBox3d part;  ///< the faces within it fill the frame; others are drawn around them
  double line_width = 0.3;   ///< of edges, pixels
};

/// Draw the faces of a mesh with their edges, shaded by a light from the upper left. Faces behind
/// others are drawn first. Left out are faces beyond the frame, and those whose back is seen, so
/// the surface has to be the graph of a function, seen from above.
void draw_surface(Svg& svg, const PolyMesh& mesh, const SurfaceView& view,
                  const PictureFrame& frame);

}  // namespace surfmesh
