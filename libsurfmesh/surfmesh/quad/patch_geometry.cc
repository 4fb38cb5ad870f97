// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/patch_geometry.hh"

#include <algorithm>
#include <cmath>

#include "surfmesh/core/error.hh"
#include "surfmesh/metric/triangle.hh"

namespace surfmesh {
namespace {

/// Steps in (u,v) for the two unit steps in the chart of a vertex: the columns of L⁻ᵀ with
/// M = L Lᵀ, of which the first is along u.
struct Chart {
  double x_u;
  Uv y;

  explicit Chart(const Metric& m) {
    const double l11 = std::sqrt(m.m11), l21 = m.m12 / l11;
    const double l22 = std::sqrt(m.m22 - l21 * l21);
    x_u = 1 / l11;
    y = {-l21 / (l11 * l22), 1 / l22};
  }

  bool is_regular() const { return std::isfinite(x_u) && std::isfinite(y.u) && std::isfinite(y.v); }

  Uv step(ChartStep s) const { return {x_u * s.x + y.u * s.y, y.v * s.y}; }
};

Uv times(const Metric& m, Uv e) { return {m.m11 * e.u + m.m12 * e.v, m.m12 * e.u + m.m22 * e.v}; }

/// The derivatives by a step in (u,v), taken to the chart.
void set_first(const Chart& chart, Uv s, Uv d, CornerTerms& terms) {
  terms.s_x = chart.x_u * s.u;
  terms.s_y = chart.y.u * s.u + chart.y.v * s.v;
  terms.d_x = chart.x_u * d.u;
  terms.d_y = chart.y.u * d.u + chart.y.v * d.v;
}

/// A corner with the metric there.
struct CornerAt {
  Uv uv;
  Metric metric;
  double density;
};

/// The corner at the vertex that moves.
CornerTerms own_corner(const Chart& chart, const CornerAt& at, Uv next, Uv previous) {
  const Uv e1 = next - at.uv, e2 = previous - at.uv;
  CornerTerms terms;
  terms.at = {squared_length(at.metric, e1) + squared_length(at.metric, e2),
              at.density * cross(e1, e2)};
  const Uv across = at.density * (e1 - e2);
  set_first(chart, -2 * times(at.metric, e1 + e2), {across.v, -across.u}, terms);
  terms.s_xx = terms.s_yy = 4;
  return terms;
}

/// A corner beside the vertex that moves, with the sides to it, `moving`, and to the other one.
/// `density` has its sign turned unless the moving side comes first counter-clockwise.
CornerTerms neighbour_corner(const Chart& chart, const Metric& m, double density, Uv moving,
                             Uv other) {
  CornerTerms terms;
  terms.at = {squared_length(m, moving) + squared_length(m, other), density * cross(moving, other)};
  set_first(chart, 2 * times(m, moving), {density * other.v, -density * other.u}, terms);
  terms.s_xx = 2 * m.m11 * chart.x_u * chart.x_u;
  terms.s_xy = 2 * chart.x_u * (m.m11 * chart.y.u + m.m12 * chart.y.v);
  terms.s_yy = 2 * squared_length(m, chart.y);
  return terms;
}

}  // namespace

PatchGeometry::PatchGeometry(PolyMesh& mesh, const MetricField& field, std::size_t fixed)
    : mesh_(mesh),
      field_(field),
      uv_(require(mesh, keys::vertex_uv)),
      metric_(require(mesh, keys::vertex_metric)),
      fixed_(fixed),
      lower_{INFINITY, INFINITY},
      upper_{-INFINITY, -INFINITY} {
  for (std::size_t v = 0; v < fixed; ++v) {
    const Uv uv = mesh.property(uv_, VertexHandle(static_cast<int>(v)));
    lower_ = {std::min(lower_.u, uv.u), std::min(lower_.v, uv.v)};
    upper_ = {std::max(upper_.u, uv.u), std::max(upper_.v, uv.v)};
  }
  for (const VertexHandle vh : mesh.vertices()) {
    densities_.push_back(surfmesh::density(mesh.property(metric_, vh)));
  }
}

bool PatchGeometry::is_in_bounds(Uv uv) const {
  return uv.u >= lower_.u && uv.u <= upper_.u && uv.v >= lower_.v && uv.v <= upper_.v;
}

bool PatchGeometry::collect(VertexHandle vh, std::vector<CornerTerms>& star) const {
  star.clear();
  const CornerAt at{mesh_.property(uv_, vh), mesh_.property(metric_, vh), density(vh)};
  const Chart chart(at.metric);
  if (!chart.is_regular()) return false;
  const HalfedgeHandle start = mesh_.halfedge_handle(vh);
  HalfedgeHandle heh = start;
  do {
    const HalfedgeHandle into = mesh_.prev_halfedge_handle(heh);
    const VertexHandle next = mesh_.to_vertex_handle(heh);
    const VertexHandle previous = mesh_.from_vertex_handle(into);
    const Uv a = mesh_.property(uv_, next), c = mesh_.property(uv_, previous);
    const Uv beyond_a =
        mesh_.property(uv_, mesh_.to_vertex_handle(mesh_.next_halfedge_handle(heh)));
    const Uv beyond_c =
        mesh_.property(uv_, mesh_.from_vertex_handle(mesh_.prev_halfedge_handle(into)));
    star.push_back(own_corner(chart, at, a, c));
    star.push_back(neighbour_corner(chart, mesh_.property(metric_, next), -density(next), at.uv - a,
                                    beyond_a - a));
    star.push_back(neighbour_corner(chart, mesh_.property(metric_, previous), density(previous),
                                    at.uv - c, beyond_c - c));
    heh = mesh_.opposite_halfedge_handle(into);
  } while (heh != start);
  return true;
}

bool PatchGeometry::move(VertexHandle vh, ChartStep step) {
  const Uv uv = mesh_.property(uv_, vh) + Chart(mesh_.property(metric_, vh)).step(step);
  return is_in_bounds(uv) && put(vh, uv);
}

/// The metric at a place; nothing where the surface, or the metric, cannot be evaluated: places in
/// holes and outside of trimmed domains are not kept out of reach.
std::optional<Metric> PatchGeometry::find_metric(Uv uv) {
  try {
    const Metric metric = field_.at(uv, hint_);
    const double density = surfmesh::density(metric);
    if (density > 0 && std::isfinite(density)) return metric;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Geometry) throw;
  }
  return {};
}

/// Returns  false, and does nothing, where there is no metric
bool PatchGeometry::put(VertexHandle vh, Uv uv) {
  const std::optional<Metric> metric = find_metric(uv);
  if (!metric) return false;
  if (is_trial_) before_.push_back({vh, {mesh_.property(uv_, vh), mesh_.property(metric_, vh)}});
  set(vh, {uv, *metric});
  return true;
}

void PatchGeometry::set(VertexHandle vh, const Place& place) {
  mesh_.property(uv_, vh) = place.uv;
  mesh_.property(metric_, vh) = place.metric;
  if (index(vh) >= densities_.size()) densities_.resize(mesh_.n_vertices());
  densities_[index(vh)] = surfmesh::density(place.metric);
}

void PatchGeometry::put_between(VertexHandle vh, std::span<const VertexHandle> others) {
  Uv sum{0, 0};
  for (const VertexHandle other : others) sum = sum + mesh_.property(uv_, other);
  if (put(vh, 1 / static_cast<double>(others.size()) * sum)) return;
  // A vertex needs a metric, wherever it is.
  if (is_trial_) before_.push_back({vh, {mesh_.property(uv_, vh), mesh_.property(metric_, vh)}});
  set(vh, {mesh_.property(uv_, others.front()), mesh_.property(metric_, others.front())});
}

FaceMeasure PatchGeometry::measure(FaceHandle fh) const {
  FaceMeasure measure;
  const HalfedgeHandle start = mesh_.halfedge_handle(fh);
  HalfedgeHandle heh = start;
  do {
    const HalfedgeHandle next = mesh_.next_halfedge_handle(heh);
    const VertexHandle vh = mesh_.to_vertex_handle(heh);
    const Uv uv = mesh_.property(uv_, vh);
    const Uv e1 = mesh_.property(uv_, mesh_.to_vertex_handle(next)) - uv;
    const Uv e2 = mesh_.property(uv_, mesh_.from_vertex_handle(heh)) - uv;
    const Metric& m = mesh_.property(metric_, vh);
    const double l1 = squared_length(m, e1), l2 = squared_length(m, e2);
    const double d = density(vh) * cross(e1, e2);
    measure.energy += corner_energy({l1 + l2, d}, {});
    const double product = l1 * l2;
    measure.least_jacobian =
        std::min(measure.least_jacobian, product > 0 ? d / std::sqrt(product) : 0);
    heh = next;
  } while (heh != start);
  return measure;
}

void PatchGeometry::keep_trial() {
  is_trial_ = false;
  before_.clear();
}

void PatchGeometry::undo_trial() {
  while (!before_.empty()) {
    const auto& [vh, place] = before_.back();
    set(vh, place);
    before_.pop_back();
  }
  is_trial_ = false;
}

}  // namespace surfmesh
