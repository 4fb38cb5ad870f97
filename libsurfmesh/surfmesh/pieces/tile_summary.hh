// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "surfmesh/model/model.hh"
#include "surfmesh/patch/mesh_patch.hh"
#include "surfmesh/quality/moments.hh"
#include "surfmesh/quality/patch_measures.hh"
#include "surfmesh/quality/quad_statistics.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {

/// The moments, the bounds and a histogram of some values.
struct SummedValues {
  detail::Moments moments;
  double min = 0, max = 0;
  std::int64_t marked = 0;                   ///< those that their statistics count apart
  std::array<std::int64_t, 16> histogram{};  ///< of as many bins as their statistics have

  std::size_t count() const { return moments.count(); }

  /// Of the marked ones among all.
  double share() const;

  SummedValues& operator+=(const SummedValues& other);
};

/// The middle of a face.
struct FacePlace {
  double x = 0, y = 0, z = 0;
};

/// What is kept of the quality of a tile when its mesh has become plain arrays. Ranks exchange it
/// as it is in memory.
///
/// Error    edges at the border count in each tile that has them; vertices there have no share in
///          irregular_share
struct TileSummary {
  std::int64_t tile = 0;
  std::int64_t patch = 0;
  std::int64_t own_vertices = 0;  ///< see TilePart; known when the tile is taken apart
  std::int64_t triangles = 0, quads = 0;
  double area = 0;
  SummedValues edges;            ///< metric lengths; marked: in the unit range
  SummedValues lengths;          ///< in space
  SummedValues qualities;        ///< of triangles; marked: below 0.3
  SummedValues jacobians;        ///< of quads in the metric; marked: flat
  SummedValues space_jacobians;  ///< of quads in space; marked: folded
  std::int64_t inverted = 0;     ///< quads
  double irregular_share = 0;    ///< of the tile's inner vertices, see QuadStatistics
  FacePlace worst, worst_quad, worst_quad_in_space;
  std::int64_t has_triangle_place = 0;
  FacePlace triangle_at;    ///< the first triangle, which is told among quads
  std::int64_t turned = 0;  ///< triangles against the surface, see TurnedTriangles
  std::int64_t has_turned_place = 0, is_turned_by_surface = 0;
  double turned_u = 0, turned_v = 0;
  FacePlace turned_at;
  std::int64_t is_given_up = 0;
  RefineCounts refine;
};

/// Measure the mesh of a tile of a model, with the faces around its poles.
///
/// Writes   surf:uv and surf:metric (halfedge), surf:patch (face) of the tile's mesh
/// Cost     about 0.2 µs a triangle; at poles that of a copy of the mesh besides
TileSummary summary_of(std::size_t tile, PatchResult& result, const Model& model);

/// The statistics of all tiles together, with the worst faces' middles beside them.
struct SummaryOfTiles {
  std::size_t triangles = 0, quads = 0;
  EdgeStatistics edges;
  QualityStatistics quality;
  QuadStatistics quad_statistics;
  SummedValues lengths;
  RefineCounts refine;
  /// The tiles of the worst faces; -1 for none.
  std::ptrdiff_t worst = -1, worst_quad = -1, worst_quad_in_space = -1;
};

/// Sum up tiles in their order: the same on every rank, whatever was made where. Their irregular
/// shares count by their quads.
SummaryOfTiles sum_of(std::span<const TileSummary> tiles, std::size_t patch_count);

}  // namespace surfmesh
