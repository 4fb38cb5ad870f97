// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/region_work.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "surfmesh/across/region_parameters.hh"
#include "surfmesh/across/space_geometry.hh"
#include "surfmesh/across/space_triangles.hh"
#include "surfmesh/across/triangle_measures.hh"
#include "surfmesh/core/mesh_arrays.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/quad/clean_quads.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh {
namespace {

/// Cosine of the angle between normals of a face beyond which it is left out.
constexpr double kBentFace = 0;

/// Cosine of the angle between the normals of patches at a vertex beyond which it is a tip.
constexpr double kOnePlane = 0.9;

/// Attempts at a region; the last one is taken if faces are better in the mean, whatever they are.
constexpr int kAttempts = 3;

/// Share of the reach of a singular point within which a vertex is at it.
constexpr double kAtPoint = 1e-3;

/// Sweeps of smoothing of quads, as within patches.
constexpr int kFirstSweeps = 5, kLastSweeps = 10, kPolishingSweeps = 8;

/// The corners of a region in the result that it is taken from.
class RegionCorners {
 public:
  explicit RegionCorners(const RegionInput& input)
      : input_(input),
        patch_of_(require(input.result, keys::face_patch)),
        uv_of_(require(input.result, keys::corner_uv)),
        metric_of_(require(input.result, keys::corner_metric)),
        beyond_(find(input.result, keys::corner_beyond)) {}

  /// Call `visit` with each vertex of a face of the region, and the corner of the result there.
  template <class Visit>
  void for_each(const RegionMesh& region, FaceHandle fh, Visit visit) const {
    HalfedgeHandle side = input_.result.halfedge_handle(region.faces[index(fh)]);
    for_each_corner(*region.mesh, fh, [&](HalfedgeHandle heh) {
      visit(region.mesh->from_vertex_handle(heh), input_.result.prev_halfedge_handle(side));
      side = input_.result.next_halfedge_handle(side);
    });
  }

  SurfacePlace place(HalfedgeHandle corner) const {
    return {input_.result.property(patch_of_, input_.result.face_handle(corner)),
            input_.result.property(uv_of_, corner)};
  }

  /// True if a corner has the (u,v) of a place on its patch.
  bool is_on_patch(HalfedgeHandle corner) const {
    return !beyond_.is_valid() || input_.result.property(beyond_, corner) == 0;
  }

  const Metric& metric(HalfedgeHandle corner) const {
    return input_.result.property(metric_of_, corner);
  }

  bool is_singular(const SurfacePlace& place) const {
    const auto& points = input_.singular_points[static_cast<std::size_t>(place.patch)];
    return std::any_of(points.begin(), points.end(), [&](const SingularPoint& point) {
      const Uv off = place.uv - point.at;
      return std::max(std::abs(off.u), std::abs(off.v)) < kAtPoint * point.reach;
    });
  }

 private:
  const RegionInput& input_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::corner_uv)::Handle uv_of_;
  decltype(keys::corner_metric)::Handle metric_of_;
  decltype(keys::corner_beyond)::Handle beyond_;
};

/// Stands for a chart that cannot be made: its normal agrees with no other one.
VertexChart no_chart() {
  VertexChart chart;
  chart.normal = Vec3::Constant(kUnset);
  return chart;
}

/// Makes the charts of the vertices of a region where they are.
class RegionCharts {
 public:
  RegionCharts(const RegionInput& input, ChartMaker& maker, RegionWork& work)
      : input_(input), maker_(maker), work_(work), corners_(input) {}

  void make() {
    const PolyMesh& mesh = *work_.region.mesh;
    work_.charts.assign(mesh.n_vertices(), no_chart());
    work_.is_singular.assign(mesh.n_vertices(), 0);
    is_made_.assign(mesh.n_vertices(), 0);
    compared_.resize(mesh.n_vertices());
    for (const FaceHandle fh : mesh.faces()) {
      corners_.for_each(work_.region, fh, [&](VertexHandle vh, HalfedgeHandle corner) {
        if (is_made_[index(vh)] == 0) {
          make(vh, corner);
        } else {
          compare(vh, corner);
        }
      });
    }
  }

 private:
  void make(VertexHandle vh, HalfedgeHandle corner) {
    const auto vertex = static_cast<std::size_t>(work_.region.vertices[index(vh)]);
    if (vertex < input_.places.size() && input_.places[vertex].patch >= 0) {
      // A chart has the metric that its patch asks for, wherever faces see it from.
      take(vh, maker_.make(input_.places[vertex]), input_.places[vertex]);
      return;
    }
    if (!corners_.is_on_patch(corner)) return;
    const SurfacePlace place = corners_.place(corner);
    take(vh, maker_.make(place, corners_.metric(corner)), place);
  }

  /// A vertex at which patches do not have one tangent plane is a tip, which stays: it has no
  /// chart.
  void compare(VertexHandle vh, HalfedgeHandle corner) {
    VertexChart& chart = work_.charts[index(vh)];
    const SurfacePlace place = corners_.place(corner);
    if (place == chart.place || place == compared_[index(vh)] || !corners_.is_on_patch(corner)) {
      return;
    }
    compared_[index(vh)] = place;
    const auto other = maker_.make(place, corners_.metric(corner));
    if (other && other->normal.dot(chart.normal) < kOnePlane) chart.normal = no_chart().normal;
  }

  void take(VertexHandle vh, const std::optional<VertexChart>& made, const SurfacePlace& place) {
    if (!made) return;
    is_made_[index(vh)] = 1;
    work_.charts[index(vh)] = *made;
    // On a contour, joining may have put the vertex beside its patch.
    work_.charts[index(vh)].point = to_eigen(work_.region.mesh->point(vh));
    work_.is_singular[index(vh)] = corners_.is_singular(place) ? 1 : 0;
  }

  const RegionInput& input_;
  ChartMaker& maker_;
  RegionWork& work_;
  RegionCorners corners_;
  std::vector<char> is_made_;
  std::vector<SurfacePlace> compared_;  ///< by vertex: the last place that was compared
};

/// The faces of a region but those across which the surface turns sharply.
FacePiece flat_faces(const RegionWork& work, double least_cosine) {
  const PolyMesh& mesh = *work.region.mesh;
  FacePiece flat;
  for (const FaceHandle fh : mesh.faces()) {
    bool is_flat = true;
    for_each_vertex_of(mesh, fh, [&](int a) {
      for_each_vertex_of(mesh, fh, [&](int b) {
        const double cosine = work.charts[static_cast<std::size_t>(a)].normal.dot(
            work.charts[static_cast<std::size_t>(b)].normal);
        is_flat = is_flat && cosine >= least_cosine;
      });
    });
    if (is_flat) flat.push_back(work.region.faces[index(fh)]);
  }
  return flat;
}

/// The same region without some of its faces.
RegionWork without(const RegionWork& work, RegionMesh region) {
  RegionWork rest;
  rest.region = std::move(region);
  rest.charts.resize(rest.region.mesh->n_vertices());
  rest.is_singular.resize(rest.charts.size());
  std::size_t old = 0;
  for (const FaceHandle fh : rest.region.mesh->faces()) {
    while (work.region.faces[old] != rest.region.faces[index(fh)]) ++old;
    HalfedgeHandle side = work.region.mesh->halfedge_handle(FaceHandle(static_cast<int>(old)));
    for_each_corner(*rest.region.mesh, fh, [&](HalfedgeHandle heh) {
      const std::size_t from = index(work.region.mesh->from_vertex_handle(side));
      const std::size_t to = index(rest.region.mesh->from_vertex_handle(heh));
      rest.charts[to] = work.charts[from];
      rest.is_singular[to] = work.is_singular[from];
      side = work.region.mesh->next_halfedge_handle(side);
    });
  }
  return rest;
}

/// The faces that fit best at each vertex: at the border quarter turns, as metrics see them.
std::vector<int> wanted_faces(const PolyMesh& mesh, const std::vector<VertexChart>& charts) {
  std::vector<int> wanted;
  for (const VertexHandle vh : mesh.vertices()) {
    double angle = 2 * std::numbers::pi;
    if (mesh.is_boundary(vh)) {
      angle = 0;
      const VertexChart& chart = charts[index(vh)];
      for (const HalfedgeHandle heh : mesh.voh_range(vh)) {
        if (mesh.is_boundary(heh)) continue;
        const VertexHandle next = mesh.to_vertex_handle(heh);
        const VertexHandle previous = mesh.from_vertex_handle(mesh.prev_halfedge_handle(heh));
        const Vec3 a = chart.in_chart(charts[index(next)].point - chart.point);
        const Vec3 b = chart.in_chart(charts[index(previous)].point - chart.point);
        angle +=
            std::max(0.0, std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()));
      }
    }
    wanted.push_back(std::max(1, static_cast<int>(std::lround(angle / (0.5 * std::numbers::pi)))));
  }
  return wanted;
}

void improve_quads(RegionWork& work, ChartMaker& maker, const RunContext& context) {
  PolyMesh& mesh = *work.region.mesh;
  SpaceGeometry geometry(mesh, work.charts, maker);
  smooth_quads(mesh, geometry, SmoothingAim::Shape, kFirstSweeps, context);
  clean_quads(mesh, *work.editor, geometry, wanted_faces(mesh, work.charts), context);
  smooth_quads(mesh, geometry, SmoothingAim::BetterShape, kLastSweeps, context);
  smooth_quads(mesh, geometry, SmoothingAim::WorstCorners, kPolishingSweeps, context);
}

RegionWork attempt_region(const RegionInput& input, const FacePiece& piece,
                          const std::vector<char>& is_held, ChartMaker& maker,
                          const RunContext& context) {
  RegionWork work;
  work.region = cut_region(input.result, piece, is_held);
  RegionCharts(input, maker, work).make();
  const bool is_of_quads = has_quads(*work.region.mesh);
  FacePiece flat = flat_faces(work, kBentFace);
  if (flat.size() < piece.size()) work = without(work, cut_region(input.result, flat, is_held));
  context.throw_if_cancelled();
  for (const VertexChart& chart : work.charts) work.places.push_back(chart.place);
  work.editor = std::make_unique<FaceEditor>(*work.region.mesh);
  if (is_of_quads) {
    improve_quads(work, maker, context);
  } else {
    improve_space_triangles(*work.region.mesh, *work.editor, work.charts, maker, context);
  }
  return work;
}

bool is_worse(const RegionQuality& now, const RegionQuality& before) {
  return now.inverted > before.inverted || now.mean < before.mean;
}

/// A region of no faces.
RegionWork untouched_region(const RegionInput& input) {
  RegionWork work;
  work.region = cut_region(input.result, {}, {});
  work.editor = std::make_unique<FaceEditor>(*work.region.mesh);
  return work;
}

}  // namespace

RegionWork improve_region(const RegionInput& input, const FacePiece& piece,
                          const std::vector<char>& is_held, const RunContext& context) {
  ChartMaker maker(input.model, input.fields, input.walk, input.is_turned);
  FacePiece faces = piece;
  RegionWork work;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    work = attempt_region(input, faces, is_held, maker, context);
    work.faces = faces_in_patches(input, work, maker);
    faces = without_spoilt(input, work, maker);
    if (faces.size() == work.region.faces.size()) break;
  }
  if (is_worse(quality_now(work, maker), quality_before(input, work, maker))) {
    work = untouched_region(input);
  }
  work.queries = maker.queries();
  return work;
}

}  // namespace surfmesh
