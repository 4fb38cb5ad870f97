// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"
#include "surfmesh/core/values.hh"

namespace surfmesh {

/// Subdivision scheme of a control cage. Auto: Loop where every face is a triangle (but
/// Catmull-Clark where the cage asks for smooth triangles), else Catmull-Clark.
enum class Scheme { Auto, CatmullClark, Loop, Bilinear };

/// What a limit surface does at the boundary of its cage, as OpenSubdiv defines it.
enum class BoundaryRule { None, EdgeAndCorner, EdgeOnly };

/// A control cage as read: an indexed face set with the tags of its subdivision.
///
/// May be non-manifold; that is for the model to deal with. Sharpness of 10 and more is infinite.
struct Cage {
  struct Crease {
    std::array<int, 2> edge = {-1, -1};  ///< vertices
    double sharpness = 0;
  };
  struct Corner {
    int vertex = -1;
    double sharpness = 0;
  };
  struct FaceGroup {
    std::string name;
    std::vector<int> faces;
  };

  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;  ///< vertices from 0, at least three different ones each
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<int> holes;         ///< faces that are left out
  std::vector<FaceGroup> groups;  ///< in the order of their first face; a face may be in several
  BoundaryRule boundary = BoundaryRule::EdgeOnly;
  bool is_chaikin = false;  ///< crease method
  bool is_smooth_triangles = false;
  Notices notices;  ///< of reading, with file and line
};

/// Diagonal of the bounding box of the cage's points, in model units.
double diagonal(const Cage& cage);

/// Tell which scheme Auto stands for; any other scheme is returned as it is.
Scheme resolve_scheme(const Cage& cage, Scheme scheme);

/// The vertices of a face without those that are the same as the next one.
std::vector<int> without_repeats(const std::vector<int>& face);

/// True if a face has at least three different vertices and does not come back to any of them;
/// a vertex may be there several times in a row (a side that is a point).
bool is_simple(const std::vector<int>& face);

/// Check that points are finite and that the vertices of faces, three at least, are points.
///
/// Throws   InvalidInput, naming the point or face
/// Cost     O(face corners)
void check_ranges(const Cage& cage);

/// Check that the cage can be subdivided: its ranges, and that all faces are simple.
///
/// Tags are not looked at: a tag that makes no sense is a warning of the model.
/// Throws   InvalidInput, naming the point, face or vertex
/// Cost     O(face corners)
void check(const Cage& cage);

}  // namespace surfmesh
