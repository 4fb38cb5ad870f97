// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pieces/tile_summary.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "surfmesh/core/properties.hh"
#include "surfmesh/pieces/mesh_with_fans.hh"
#include "surfmesh/quality/measure_lengths.hh"
#include "surfmesh/quality/quality_histogram.hh"

namespace surfmesh {
namespace {

static_assert(std::is_trivially_copyable_v<TileSummary>);

void count_bins(const std::vector<HistogramBin>& bins, SummedValues& sums) {
  for (std::size_t i = 0; i < bins.size(); ++i) {
    sums.histogram[i] = static_cast<std::int64_t>(bins[i].count);
  }
}

/// How many are marked, of a share that was one count divided by the other.
std::int64_t marked_of(double share, std::size_t count) {
  return std::llround(share * static_cast<double>(count));
}

SummedValues summed(const EdgeStatistics& edges) {
  SummedValues sums{detail::Moments::of(edges.count, edges.mean, edges.stddev),
                    edges.min,
                    edges.max,
                    marked_of(edges.unit_fraction, edges.count),
                    {}};
  count_bins(edges.histogram, sums);
  return sums;
}

/// Of the qualities of faces no more is told than the least and the mean.
SummedValues summed_qualities(std::size_t count, double mean, double min, std::int64_t marked) {
  return {detail::Moments::of(count, mean, 0), min, 0, marked, {}};
}

SummedValues summed(const QualityStatistics& quality) {
  SummedValues sums = summed_qualities(quality.count, quality.mean, quality.min,
                                       marked_of(quality.below_0_3, quality.count));
  count_bins(quality.histogram, sums);
  return sums;
}

SummedValues jacobians_of(const QuadStatistics& quads) {
  SummedValues sums = summed_qualities(quads.count, quads.mean_jacobian, quads.min_jacobian,
                                       static_cast<std::int64_t>(quads.flat));
  count_bins(quads.histogram, sums);
  return sums;
}

SummedValues space_jacobians_of(const QuadStatistics& quads) {
  return summed_qualities(quads.count, quads.mean_space_jacobian, quads.min_space_jacobian,
                          static_cast<std::int64_t>(quads.folded));
}

SummedValues summed(const detail::SpaceLengths& lengths) {
  return {lengths.moments, lengths.min, lengths.max, 0, {}};
}

FacePlace place_of(const PolyMesh& mesh, int face) {
  if (face < 0) return {};
  const auto middle = mesh.calc_face_centroid(FaceHandle(face));
  return {middle[0], middle[1], middle[2]};
}

/// Give the corners of a tile what those of a result have.
void set_corners(PolyMesh& mesh, int patch) {
  const auto uv_of = require(mesh, keys::vertex_uv);
  const auto metric_of = require(mesh, keys::vertex_metric);
  const auto corner_uv = attach(mesh, keys::corner_uv);
  const auto corner_metric = attach(mesh, keys::corner_metric);
  attach(mesh, keys::face_patch, patch);
  for (const HalfedgeHandle heh : mesh.halfedges()) {
    const VertexHandle tip = mesh.to_vertex_handle(heh);
    mesh.property(corner_uv, heh) = mesh.property(uv_of, tip);
    mesh.property(corner_metric, heh) = mesh.property(metric_of, tip);
  }
}

void count_faces(const PolyMesh& mesh, TileSummary& summary) {
  for (const PatchMeasure& measure : measure_patches(mesh, {})) {
    summary.triangles += static_cast<std::int64_t>(measure.triangles);
    summary.quads += static_cast<std::int64_t>(measure.quads);
    summary.area += measure.area;
  }
}

/// Where the first triangle is.
void locate_triangle(const PolyMesh& mesh, TileSummary& summary) {
  const auto faces = mesh.faces();
  const auto first = std::find_if(faces.begin(), faces.end(),
                                  [&](FaceHandle fh) { return mesh.valence(fh) == 3; });
  if (first == faces.end()) return;
  summary.has_triangle_place = 1;
  summary.triangle_at = place_of(mesh, (*first).idx());
}

void measure_quads_of(const PolyMesh& mesh, TileSummary& summary) {
  const QuadStatistics quads = measure_quads(mesh);
  summary.jacobians = jacobians_of(quads);
  summary.space_jacobians = space_jacobians_of(quads);
  summary.inverted = static_cast<std::int64_t>(quads.inverted);
  summary.irregular_share = quads.irregular_share;
  summary.worst_quad = place_of(mesh, quads.worst_face);
  summary.worst_quad_in_space = place_of(mesh, quads.worst_face_in_space);
}

void measure_mesh(const PolyMesh& mesh, TileSummary& summary) {
  count_faces(mesh, summary);
  summary.edges = summed(measure_edges(mesh));
  summary.lengths = summed(detail::measure_lengths(mesh));
  const QualityStatistics quality = measure_quality(mesh);
  summary.qualities = summed(quality);
  summary.worst = place_of(mesh, quality.worst_face);
  if (summary.triangles > 0) locate_triangle(mesh, summary);
  if (summary.quads > 0) measure_quads_of(mesh, summary);
}

void take_turned(const TurnedTriangles& turned, TileSummary& summary) {
  summary.turned = static_cast<std::int64_t>(turned.count);
  if (!turned.place) return;
  summary.has_turned_place = 1;
  summary.is_turned_by_surface = turned.place->is_of_surface ? 1 : 0;
  summary.turned_u = turned.place->uv.u;
  summary.turned_v = turned.place->uv.v;
  const Vec3& at = turned.place->point;
  summary.turned_at = {at.x(), at.y(), at.z()};
}

void fill_bins(const SummedValues& sums, std::vector<HistogramBin>& bins) {
  for (std::size_t i = 0; i < bins.size(); ++i) {
    bins[i].count = static_cast<std::size_t>(sums.histogram[i]);
  }
}

void fill(const SummedValues& sums, EdgeStatistics& edges) {
  edges.count = sums.count();
  edges.mean = sums.moments.mean();
  edges.stddev = sums.moments.stddev();
  edges.min = sums.min;
  edges.max = sums.max;
  edges.unit_fraction = sums.share();
  edges.histogram = detail::empty_length_histogram();
  fill_bins(sums, edges.histogram);
  edges.histogram.back().to = std::max(edges.histogram.back().to, edges.max);
}

void fill(const SummedValues& sums, QualityStatistics& quality) {
  quality.count = sums.count();
  quality.min = sums.min;
  quality.mean = sums.moments.mean();
  quality.below_0_3 = sums.share();
  if (sums.count() == 0) return;
  quality.histogram = detail::empty_quality_histogram();
  fill_bins(sums, quality.histogram);
}

void fill(const SummedValues& jacobians, const SummedValues& in_space, QuadStatistics& quads) {
  quads.count = jacobians.count();
  quads.min_jacobian = jacobians.min;
  quads.mean_jacobian = jacobians.moments.mean();
  quads.flat = static_cast<std::size_t>(jacobians.marked);
  quads.min_space_jacobian = in_space.min;
  quads.mean_space_jacobian = in_space.moments.mean();
  quads.folded = static_cast<std::size_t>(in_space.marked);
  if (jacobians.count() == 0) return;
  quads.histogram = detail::empty_quality_histogram();
  fill_bins(jacobians, quads.histogram);
}

/// The tile of the least value, the first one.
class WorstTile {
 public:
  void take(std::size_t tile, const SummedValues& sums) {
    if (sums.count() == 0 || !(sums.min < least_)) return;
    least_ = sums.min;
    tile_ = static_cast<std::ptrdiff_t>(tile);
  }
  std::ptrdiff_t tile() const { return tile_; }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  std::ptrdiff_t tile_ = -1;
};

void take_least(std::size_t patch, const SummedValues& sums, std::vector<double>& of_patches) {
  if (sums.count() > 0) of_patches[patch] = std::min(of_patches[patch], sums.min);
}

}  // namespace

double SummedValues::share() const {
  return count() == 0 ? 0 : static_cast<double>(marked) / static_cast<double>(count());
}

SummedValues& SummedValues::operator+=(const SummedValues& other) {
  if (other.count() == 0) return *this;
  if (count() == 0) return *this = other;
  moments += other.moments;
  min = std::min(min, other.min);
  max = std::max(max, other.max);
  marked += other.marked;
  for (std::size_t i = 0; i < histogram.size(); ++i) histogram[i] += other.histogram[i];
  return *this;
}

TileSummary summary_of(std::size_t tile, PatchResult& result, const Model& model) {
  set_corners(*result.mesh.mesh, result.mesh.boundary.patch);
  std::unique_ptr<PolyMesh> with_fans;
  if (!result.mesh.boundary.fans.empty()) with_fans = detail::mesh_with_fans(result.mesh, model);
  TileSummary summary;
  summary.tile = static_cast<std::int64_t>(tile);
  summary.patch = result.mesh.boundary.patch;
  measure_mesh(with_fans ? *with_fans : *result.mesh.mesh, summary);
  take_turned(result.turned, summary);
  summary.is_given_up = result.is_given_up ? 1 : 0;
  summary.refine = result.refine;
  return summary;
}

SummaryOfTiles sum_of(std::span<const TileSummary> tiles, std::size_t patch_count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SummaryOfTiles all;
  SummedValues edges, qualities, jacobians, in_space;
  WorstTile worst, worst_quad, worst_in_space;
  double irregular = 0;
  all.quality.min_of_patches.assign(patch_count, infinity);
  all.quad_statistics.min_of_patches.assign(patch_count, infinity);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const TileSummary& tile = tiles[t];
    const auto patch = static_cast<std::size_t>(tile.patch);
    all.triangles += static_cast<std::size_t>(tile.triangles);
    all.quads += static_cast<std::size_t>(tile.quads);
    all.lengths += tile.lengths;
    all.refine += tile.refine;
    all.quad_statistics.inverted += static_cast<std::size_t>(tile.inverted);
    edges += tile.edges;
    qualities += tile.qualities;
    jacobians += tile.jacobians;
    in_space += tile.space_jacobians;
    irregular += tile.irregular_share * static_cast<double>(tile.quads);
    worst.take(t, tile.qualities);
    worst_quad.take(t, tile.jacobians);
    worst_in_space.take(t, tile.space_jacobians);
    take_least(patch, tile.qualities, all.quality.min_of_patches);
    take_least(patch, tile.jacobians, all.quad_statistics.min_of_patches);
  }
  all.worst = worst.tile();
  all.worst_quad = worst_quad.tile();
  all.worst_quad_in_space = worst_in_space.tile();
  fill(edges, all.edges);
  fill(qualities, all.quality);
  fill(jacobians, in_space, all.quad_statistics);
  if (all.quads > 0) {
    const auto quads = static_cast<double>(all.quads);
    all.quad_statistics.fraction = quads / (quads + static_cast<double>(all.triangles));
    all.quad_statistics.irregular_share = irregular / quads;
  }
  return all;
}

}  // namespace surfmesh
