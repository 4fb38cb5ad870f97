// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "surfmesh/across/face_parameters.hh"
#include "surfmesh/across/region_mesh.hh"
#include "surfmesh/across/vertex_chart.hh"
#include "surfmesh/core/face_editor.hh"
#include "surfmesh/core/run_context.hh"

namespace surfmesh {

/// A region of a result that has been worked on.
struct RegionWork {
  RegionMesh region;  ///< its lists are those of the elements before
  std::unique_ptr<FaceEditor> editor;
  std::vector<VertexChart> charts;   ///< by vertex
  std::vector<SurfacePlace> places;  ///< by vertex, before
  std::vector<char> is_singular;     ///< by vertex, before: 1 at singular points of the surface
  std::vector<FaceInPatch> faces;    ///< by face, now
  QueryCounts queries;               ///< of the metric fields

  /// True for a vertex that has moved, or is new.
  bool is_moved(VertexHandle vh) const {
    return index(vh) >= places.size() || !(places[index(vh)] == charts[index(vh)].place);
  }

  /// The vertex of the result that a vertex was; -1 for a new one.
  int origin(VertexHandle vh) const {
    return index(vh) < region.vertices.size() ? region.vertices[index(vh)] : -1;
  }
};

/// What all regions have in common.
struct RegionInput {
  const PolyMesh& result;
  const Model& model;
  const std::vector<const MetricField*>& fields;
  const SurfaceWalk& walk;
  const std::vector<char>& is_turned;                              ///< by patch
  const std::vector<std::vector<SingularPoint>>& singular_points;  ///< by patch
  /// By patch: those with the same number are connected across contours that are dissolved.
  const std::vector<std::size_t>& sheets;
  /// By vertex of the result where it lies on the surface, as far as that is known better than from
  /// its corners, whose (u,v) may go on beyond their patch; others have no patch. May be empty.
  std::vector<SurfacePlace> places;
};

/// Take a piece out of a result, as charts see it, and improve it.
///
/// Faces across which the surface turns sharply, and those without a chart at a corner, are left
/// out: elements that reach around an edge of the surface cannot be measured in space. So are, in
/// another attempt, faces around those that are flat, turned over or concave in (u,v) afterwards.
/// If faces are no better in the mean, or more are turned over, the region has none.
/// Cost     3 µs a triangle, 25 µs a quad
/// Throws   Cancelled
RegionWork improve_region(const RegionInput& input, const FacePiece& piece,
                          const std::vector<char>& is_held, const RunContext& context);

}  // namespace surfmesh
