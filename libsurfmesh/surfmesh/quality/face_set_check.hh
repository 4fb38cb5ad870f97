// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {

/// One kind of fault of a mesh, and where it is.
struct MeshFault {
  std::string kind;  ///< a stable key: "non_manifold_edge"
  std::size_t count = 0;
  std::vector<std::string> places;  ///< the first ten, in plain English

  static constexpr std::size_t kMostPlaces = 10;

  /// Count one more. `location()` makes the text that says where it is, and is called only for the
  /// first ones.
  template <class Location>
  void add(Location location) {
    if (count++ < kMostPlaces) places.push_back(location());
  }

  friend bool operator==(const MeshFault&, const MeshFault&) = default;
};

/// What can be said about a mesh without its surface.
struct FaceSetCheck {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t quads = 0;
  std::size_t polygons = 0;  ///< faces of more than four corners
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;  ///< connected sets of boundary edges
  std::size_t components = 0;      ///< connected by edges
  long euler = 0;                  ///< used vertices − edges + faces
  bool is_closed = false;          ///< no boundary edge
  bool is_manifold = false;        ///< no edge of three faces, one fan of faces around each vertex
  bool is_oriented = false;        ///< neighbours agree about their outside
  /// The open edges with their locations; not faults in themselves.
  MeshFault open_edges{"open_edge", 0, {}};
  std::vector<MeshFault> faults;  ///< those that occur

  /// True if the faces enclose a volume.
  bool has_volume() const { return is_closed && is_oriented; }

  friend bool operator==(const FaceSetCheck&, const FaceSetCheck&) = default;
};

/// Count the elements of a mesh and find what is wrong with it.
///
/// Kinds of faults: non_manifold_edge (of three faces or more), turned_neighbour (two faces
/// traverse their edge in the same direction), non_manifold_vertex (faces that meet in this vertex
/// only), degenerate_face (no area, to rounding), duplicate_face (the same vertices),
/// duplicate_vertex (the same coordinates), unused_vertex. If the faces have patches, locations
/// name the patch, or give its number if it has no name.
/// Cost     O(n log n), about 1 µs a triangle
FaceSetCheck check_face_set(const MeshArrays& set);

/// Angles and shapes in space.
struct ShapeStatistics {
  double min_angle = 0;  ///< of the corners of all faces, radians
  double max_angle = 0;
  std::size_t min_angle_face = 0;
  std::size_t max_angle_face = 0;
  std::vector<HistogramBin> angles;  ///< 18 bins of 10 degrees, in degrees
  double min_edge = 0;               ///< lengths of the sides of faces, in model units
  double max_edge = 0;
  double mean_edge = 0;
  /// Quality 4√3 A / (l1²+l2²+l3²) of the triangles: 1 for an equilateral one, 0 for no area.
  QualityStatistics quality;

  friend bool operator==(const ShapeStatistics&, const ShapeStatistics&) = default;
};

/// Measure the faces of a mesh in space, whatever sizes were wanted.
/// Cost     O(corners)
ShapeStatistics measure_shape(const MeshArrays& set);

}  // namespace surfmesh
