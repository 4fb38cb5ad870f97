// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "pictures/camera.hh"
#include "pictures/colours.hh"
#include "surfmesh/core/mesh.hh"

namespace surfmesh {

/// A point as it is seen.
struct ScenePoint {
  double x = 0;      ///< pixels, to the right
  double y = 0;      ///< pixels, downwards
  double depth = 0;  ///< greater is nearer; planes in space are planes in (x, y, depth)
};

/// A colour of eight bits a part, 0xRRGGBB: equal ones are drawn together.
using PackedRgb = std::uint32_t;

PackedRgb packed(const Rgb& colour);
Rgb unpacked(PackedRgb colour);

/// Three points, and the colour in which they are seen.
struct SceneTriangle {
  std::array<int, 3> points = {};
  PackedRgb colour = 0;
};

/// A side of faces.
struct SceneEdge {
  int from = 0;
  int to = 0;
  bool is_contour = false;
  float room = 0;  ///< pixels: least height of the wider one of its faces, as it is seen
};

/// What a picture shows, before it is known what hides what.
struct Scene {
  std::vector<ScenePoint> points;
  std::vector<SceneTriangle> triangles;
  std::vector<SceneEdge> edges;
};

/// Colours of the faces, or of their corners, by the index of the face or vertex.
struct MeshPaint {
  std::vector<Rgb> colours;
  bool is_of_vertices = false;  ///< each face is divided between its corners
};

/// Which edges are drawn as contours, by their index.
///
/// Reads    surf:contour (edge), surf:patch (face), both optional
/// Returns  borders; contours of the mesh, or edges between patches where it knows none; where it
///          has no patches, edges at which faces meet at more than 40°
std::vector<char> contour_edges(const PolyMesh& mesh);

/// A mesh in space, seen by a camera.
struct SpaceView {
  Camera camera = {};
  Eigen::AlignedBox3d part;  ///< the faces within it fill the frame
  std::vector<char> shown;   ///< by face: those that fill the frame, in place of `part`; or empty
  double zoom = 1;           ///< larger than what fills the frame by so much
  Vec3 look_at = Vec3::Constant(kUnset);  ///< in the middle of the frame; unset for what fills it
};

/// Project a mesh. Faces are shaded by a light from the upper left, both sides alike. Faces of more
/// than four corners are divided by triangulate_polygon.
///
/// Throws   InvalidOption in perspective, where the point to look at is not in front of the eye
Scene scene_in_space(const PolyMesh& mesh, const MeshPaint& paint, const SpaceView& view,
                     const PictureFrame& frame);

/// A patch in its plane of parameters.
struct PlaneScene {
  Scene scene;
  Eigen::AlignedBox2d box;                ///< of the parameters
  std::function<PicturePoint(Uv)> place;  ///< of parameters in the picture
};

/// The faces of a patch over their parameters. Both axes have one scale, unless that would leave
/// one of them shorter than a fifth of the other; then both fill the frame.
///
/// Reads    surf:uv (halfedge), surf:patch (face; without it, all faces are taken)
/// Throws   MissingProperty; InvalidInput if no face lies on the patch
PlaneScene scene_in_plane(const PolyMesh& mesh, int patch, const MeshPaint& paint,
                          const PictureFrame& frame);

}  // namespace surfmesh
