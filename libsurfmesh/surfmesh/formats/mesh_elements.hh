// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "surfmesh/core/mesh.hh"
#include "surfmesh/core/mesh_names.hh"
#include "surfmesh/core/values.hh"
#include "surfmesh/io/short_real.hh"

namespace surfmesh {

/// A range of a list.
struct IndexRange {
  std::size_t first = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - first; }
};

/// The elements of one patch, as ranges of those of a mesh.
struct PatchElements {
  int patch = -1;  ///< -1: those of no patch
  IndexRange triangles = {};
  IndexRange quads = {};

  std::size_t size() const { return triangles.size() + quads.size(); }

  /// Where they are if all elements are numbered patch by patch, triangles first.
  std::size_t first() const { return triangles.first + quads.first; }
};

/// An edge on a contour.
struct ContourSegment {
  int contour = -1;
  int from = -1;
  int to = -1;
  bool is_smooth = true;  ///< no two faces meet there at more than 30°

  friend auto operator<=>(const ContourSegment&, const ContourSegment&) = default;
};

/// The segments of one contour, as a range of those of a mesh.
struct ContourElements {
  int contour = -1;
  IndexRange segments = {};
};

/// A mesh as programs for finite elements take it: points, elements of three and of four corners,
/// those of each patch together, and the segments of contours. Copies of vertices are one point.
struct MeshElements {
  std::vector<Vec3> points;                   ///< all finite
  std::vector<std::array<int, 3>> triangles;  ///< patch by patch, in the order of the mesh
  std::vector<std::array<int, 4>> quads;      ///< likewise
  std::vector<PatchElements> patches;    ///< those with elements, ascending, those of no patch last
  std::vector<ContourSegment> segments;  ///< contour by contour, each once
  std::vector<ContourElements> contours;  ///< those with segments, ascending

  std::size_t element_count() const { return triangles.size() + quads.size(); }
};

/// Make the elements of a mesh. Faces of more than four corners are split, as split_face does.
///
/// Reads    surf:patch (face), surf:contour (edge), surf:original (vertex), all optional
/// Throws   Geometry for a position that is not finite; InvalidInput for patches or contours above
///          10 million, which `ending` files do not hold
/// Cost     30 ns a triangle
MeshElements mesh_elements(const PolyMesh& mesh, std::string_view ending);

/// Throws   InvalidInput for the number of a patch or contour above 10 million, which `ending`
/// files
///          do not hold; `what` is "a face is of patch"
void check_number(int number, std::string_view what, std::string_view ending);

/// Whether a point is where contours end, branch or meet others, by its index.
std::vector<char> contour_ends(const MeshElements& elements);

/// The nodes of a contour, ascending.
std::vector<int> nodes_of(const MeshElements& elements, const ContourElements& contour);

/// Add to what is lost what a format with sets for patches, groups and the vertices of named
/// contours does not hold of those, and of names without elements.
void add_lost_sets(const PolyMesh& mesh, const MeshNames& names, std::vector<std::string>& lost);

/// Add to what is lost the digits of positions that have more characters than `width`, where they
/// matter beside the largest coordinate.
void add_lost_digits(const PolyMesh& mesh, std::size_t width, RealStyle style,
                     std::vector<std::string>& lost);

}  // namespace surfmesh
