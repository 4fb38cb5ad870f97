// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Subdivision scheme of a control cage. Auto: Loop if every face is a triangle (but Catmull-Clark
/// if the cage asks for smooth triangles), otherwise Catmull-Clark.
enum class Scheme { Auto, CatmullClark, Loop, Bilinear };

/// What a limit surface does at the boundary of its cage, as OpenSubdiv defines it.
enum class BoundaryRule { None, EdgeAndCorner, EdgeOnly };

/// A control cage as read: an indexed face set with the tags of its subdivision.
///
/// It may be non-manifold; the model deals with that. A sharpness of 10 or more is infinite.
struct Cage {
  /// A sharp or semi-sharp edge.
  struct Crease {
    std::array<int, 2> edge = {-1, -1};  ///< vertices
    double sharpness = 0;
  };
  /// A sharp or semi-sharp vertex.
  struct Corner {
    int vertex = -1;
    double sharpness = 0;
  };
  /// Faces with a name of the file: `g`, `o` or `usemtl`.
  struct FaceGroup {
    std::string name;
    std::vector<int> faces;
    bool is_material = false;  ///< OBJ's `usemtl`
  };
  /// Texture coordinates, by corners of faces: along seams a vertex has several.
  struct Texture {
    std::vector<Uv> points;
    /// By face, for each of its corners the number of its point, -1 for none; all of it empty for
    /// a cage without texture.
    std::vector<std::vector<int>> faces;
  };

  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;  ///< vertices from 0, at least three different ones per face
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<int> holes;         ///< faces that are left out
  std::vector<FaceGroup> groups;  ///< in the order of their first face; a face may be in several
  Texture texture;
  BoundaryRule boundary = BoundaryRule::EdgeOnly;
  bool is_chaikin = false;  ///< crease method
  bool is_smooth_triangles = false;
  Notices notices;  ///< from reading, with file and line
};

/// The vertices that faces use, in increasing order; not those that do not exist.
///
/// Cost     O(face corners)
std::vector<int> used_vertices(const Cage& cage);

/// Bounding box of the vertices that faces use: a stray point does not make a cage larger.
Eigen::AlignedBox3d bounding_box(const Cage& cage);

/// Diagonal of the bounding box, in model units; 0 if no face has a vertex.
double diagonal(const Cage& cage);

/// The scheme that Auto stands for; any other scheme is returned unchanged.
Scheme resolve_scheme(const Cage& cage, Scheme scheme);

/// The vertices of a face without those that equal the next one.
std::vector<int> without_repeats(const std::vector<int>& face);

/// True if a face has at least three different vertices and does not return to any of them. A
/// vertex may occur several times in a row (a side that is a point).
bool is_simple(const std::vector<int>& face);

/// Check that points are finite, and that faces have at least three vertices, all of which exist.
///
/// Throws   InvalidInput, naming the point or face
/// Cost     O(face corners)
void check_ranges(const Cage& cage);

/// Check that the cage can be subdivided: that its ranges are valid and all faces are simple.
///
/// Tags are not checked: for a tag that makes no sense, the model gives a warning.
/// Throws   InvalidInput, naming the point, face or vertex
/// Cost     O(face corners)
void check(const Cage& cage);

}  // namespace surfmesh
