// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pictures/mesh_paint.hh"
#include "pictures/svg.hh"
#include "pictures/visible_lines.hh"

namespace surfmesh {

enum class PictureFormat { Svg, Png };

/// Sides of pictures, pixels, and their product.
inline constexpr std::size_t kLeastPictureSide = 16, kGreatestPictureSide = 16384;
inline constexpr std::size_t kGreatestPictureArea = std::size_t{1} << 25U;

/// What a picture of a mesh shows.
struct PictureOptions {
  std::size_t width = 900;  ///< pixels
  std::size_t height = 600;
  std::optional<MeshField> colour = {};  ///< in one colour without
  LineOptions lines = {};
  SpaceView view = {};
  std::optional<int> plane = {};  ///< the patch whose parameters are shown, in place of the view
  bool has_ellipses = false;      ///< of the metric, over that plane
  bool has_key = true;            ///< what the colours mean
  bool is_transparent = false;    ///< else white
};

/// Draw a mesh. The bytes do not depend on the number of threads.
///
/// Cost     about 1 µs of processor time a triangle and 0.2 s for 900 × 600 pixels; twice that for
///          SVG where all triangles are seen
/// Throws   InvalidOption for sizes out of their range, or too small for the plane of a patch; what
///          paint_mesh, scene_in_space and scene_in_plane throw
/// Returns  the file
std::string draw_mesh(const PolyMesh& mesh, const MeshNames& names, const PictureOptions& options,
                      PictureFormat format);

/// The pixels that a scene takes in a vector picture: from back to front, then its lines.
void draw_scene(Svg& svg, const Scene& scene, const PictureFrame& frame, const LineOptions& lines);

}  // namespace surfmesh
