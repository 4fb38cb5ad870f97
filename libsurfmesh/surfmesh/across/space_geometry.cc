// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/space_geometry.hh"

#include <algorithm>
#include <array>
#include <cmath>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh {
namespace {

/// The area between two steps as a chart sees them.
double area_between(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The corner at the vertex that moves, with its sides in its chart.
CornerTerms own_corner(const Vec3& next, const Vec3& previous) {
  CornerTerms terms;
  terms.at = {next.squaredNorm() + previous.squaredNorm(), area_between(next, previous)};
  terms.s_x = -2 * (next.x() + previous.x());
  terms.s_y = -2 * (next.y() + previous.y());
  terms.d_x = next.y() - previous.y();
  terms.d_y = previous.x() - next.x();
  terms.s_xx = terms.s_yy = 4;
  return terms;
}

/// A corner beside the vertex that moves, in its own chart: the sides to it and to the other
/// neighbour, and the axes of the vertex that moves. `sign` is 1 if the moving side comes first
/// counter-clockwise.
CornerTerms neighbour_corner(const VertexChart& chart, const VertexChart& moving,
                             const Vec3& other_point, double sign) {
  const Vec3 side = chart.in_chart(moving.point - chart.point);
  const Vec3 other = chart.in_chart(other_point - chart.point);
  const Vec3 x = chart.in_chart(moving.x), y = chart.in_chart(moving.y);
  CornerTerms terms;
  terms.at = {side.squaredNorm() + other.squaredNorm(), sign * area_between(side, other)};
  terms.s_x = 2 * side.dot(x);
  terms.s_y = 2 * side.dot(y);
  terms.d_x = sign * area_between(x, other);
  terms.d_y = sign * area_between(y, other);
  terms.s_xx = 2 * x.squaredNorm();
  terms.s_xy = 2 * x.dot(y);
  terms.s_yy = 2 * y.squaredNorm();
  return terms;
}

}  // namespace

SpaceGeometry::SpaceGeometry(const PolyMesh& mesh, std::vector<VertexChart>& charts,
                             ChartMaker& maker)
    : mesh_(mesh), charts_(charts), maker_(maker), is_held_(mesh.n_vertices(), 0) {
  for (const VertexHandle vh : mesh.vertices()) is_held_[index(vh)] = mesh.is_boundary(vh) ? 1 : 0;
}

bool SpaceGeometry::collect(VertexHandle vh, std::vector<CornerTerms>& star) const {
  star.clear();
  const VertexChart& own = chart(vh);
  const HalfedgeHandle start = mesh_.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  do {
    const HalfedgeHandle into = mesh_.prev_halfedge_handle(heh);
    const VertexChart& next = chart(mesh_.to_vertex_handle(heh));
    const VertexChart& previous = chart(mesh_.from_vertex_handle(into));
    const Vec3& beyond_next = chart(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh))).point;
    const Vec3& beyond_previous =
        chart(mesh_.from_vertex_handle(mesh_.prev_halfedge_handle(into))).point;
    star.push_back(
        own_corner(own.in_chart(next.point - own.point), own.in_chart(previous.point - own.point)));
    star.push_back(neighbour_corner(next, own, beyond_next, -1));
    star.push_back(neighbour_corner(previous, own, beyond_previous, 1));
    heh = mesh_.opposite_halfedge_handle(into);
  } while (heh != start);
  return true;
}

bool SpaceGeometry::move(VertexHandle vh, ChartStep step) {
  const auto moved = maker_.move(chart(vh), step);
  if (!moved || turns_away(vh, *moved)) return false;
  set(vh, *moved);
  return true;
}

/// True if a face of a vertex would be bent, and more than before: it would reach around an edge.
bool SpaceGeometry::turns_away(VertexHandle vh, const VertexChart& moved) const {
  const VertexChart& old = chart(vh);
  for (const FaceHandle fh : mesh_.vf_range(vh)) {
    for (const VertexHandle other : mesh_.fv_range(fh)) {
      if (other == vh) continue;
      const Vec3& normal = chart(other).normal;
      const double after = moved.normal.dot(normal);
      if (after < kBentSide && after < old.normal.dot(normal)) return true;
    }
  }
  return false;
}

void SpaceGeometry::set(VertexHandle vh, const VertexChart& chart) {
  if (index(vh) >= charts_.size()) charts_.resize(mesh_.n_vertices());
  if (is_trial_) before_.emplace_back(vh, charts_[index(vh)]);
  charts_[index(vh)] = chart;
}

void SpaceGeometry::put_between(VertexHandle vh, std::span<const VertexHandle> others) {
  const VertexChart from = chart(others.front());
  Vec3 sum = Vec3::Zero();
  for (const VertexHandle other : others) sum += chart(other).point - from.point;
  const Vec3 step = from.in_chart(sum / static_cast<double>(others.size()));
  const auto moved = maker_.move(from, {step.x(), step.y()});
  // A vertex needs a chart, wherever it is.
  set(vh, moved ? *moved : from);
}

FaceMeasure SpaceGeometry::measure(FaceHandle fh) const {
  FaceMeasure measure;
  std::array<const VertexChart*, 4> corners{};
  std::size_t count = 0;
  bool is_on_one_patch = true;
  for_each_corner(mesh_, fh, [&](HalfedgeHandle heh) {
    corners[count] = &chart(mesh_.to_vertex_handle(heh));
    is_on_one_patch = is_on_one_patch && (count == 0 || corners[0]->is_beside(*corners[count]));
    ++count;
  });
  // Where the surface bends across the face, that of the face tells which way it goes around.
  Vec3 normal = Vec3::Zero();
  for (std::size_t k = 0; k < count; ++k) normal += corners[k]->normal;
  normal.normalize();
  for (std::size_t k = 0; k < count; ++k) {
    const VertexChart& at = *corners[k];
    const VertexChart& next = *corners[k + 1 == count ? 0 : k + 1];
    const VertexChart& previous = *corners[k == 0 ? count - 1 : k - 1];
    const Vec3 e1 = at.in_chart(next.point - at.point), e2 = at.in_chart(previous.point - at.point);
    const double l1 = e1.squaredNorm(), l2 = e2.squaredNorm();
    measure.energy += corner_energy({l1 + l2, area_between(e1, e2)}, {});
    const double d =
        at.density * normal.dot((next.point - at.point).cross(previous.point - at.point));
    const double product = l1 * l2;
    double jacobian = product > 0 ? d / std::sqrt(product) : 0;
    if (is_on_one_patch) {
      jacobian =
          std::min(jacobian, at.sine(next.place.uv - at.place.uv, previous.place.uv - at.place.uv));
    }
    measure.least_jacobian = std::min(measure.least_jacobian, jacobian);
  }
  return measure;
}

void SpaceGeometry::keep_trial() {
  is_trial_ = false;
  before_.clear();
}

void SpaceGeometry::undo_trial() {
  for (; !before_.empty(); before_.pop_back()) {
    charts_[index(before_.back().first)] = before_.back().second;
  }
  is_trial_ = false;
}

}  // namespace surfmesh
