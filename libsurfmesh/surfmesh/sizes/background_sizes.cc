// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/sizes/background_sizes.hh"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/beside_pole.hh"
#include "surfmesh/geometry/first_form.hh"
#include "surfmesh/metric/size_tensor.hh"
#include "surfmesh/sizes/field_size.hh"
#include "surfmesh/sizes/simplex_tree.hh"
#include "surfmesh/sizes/table_sizes.hh"

namespace surfmesh {
namespace {

using detail::LinearBound;
using detail::NearSimplex;
using detail::Simplex;
using detail::SimplexTree;
using Matrix = Eigen::Matrix3d;
using EigenSolver = Eigen::SelfAdjointEigenSolver<Matrix>;

/// Of a metric in space, squared lengths of steps of these are asked for at most: as those of
/// tables.
constexpr double kGreatestEntry = 1e100, kLeastEntry = 1e-100;

/// Twice the area of a triangle, or six times the volume of a tetrahedron, as a share of what its
/// longest side allows, below which it has none: there, weights would be rounding.
constexpr double kFlat = 1e-12;

[[noreturn]] void fail(const std::string& reason) { throw Error(ErrorCode::InvalidInput, reason); }

Matrix matrix_of(const SpaceMetric& m) {
  Matrix matrix;
  matrix << m[0], m[3], m[5], m[3], m[1], m[4], m[5], m[4], m[2];
  return matrix;
}

SpaceMetric entries_of(const Matrix& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)};
}

/// A function of the eigenvalues of a symmetric matrix.
template <class Function>
Matrix applied(const EigenSolver& solver, Function function) {
  return solver.eigenvectors() * solver.eigenvalues().unaryExpr(function).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// Entries in (u,v) as a matrix in space, with the mean of the lengths across the plane.
SpaceMetric in_plane(const SpaceMetric& m) {
  return {m[0], m[1], std::sqrt(m[0] * m[1] - m[3] * m[3]), m[3], 0, 0};
}

bool is_definite_in_plane(const SpaceMetric& m) {
  return m[0] > 0 && m[1] > 0 && m[0] * m[1] - m[3] * m[3] > 0;
}

SpaceMetric log_metric(const SpaceMetric& metric, BackgroundIn in, std::size_t vertex) {
  const auto refuse = [&] {
    fail(fmt::format("the metric at vertex {}, from 0, is not positive definite", vertex));
  };
  if (in == BackgroundIn::Uv && !is_definite_in_plane(metric)) refuse();
  const SpaceMetric m = in == BackgroundIn::Uv ? in_plane(metric) : metric;
  const bool is_finite =
      std::all_of(m.begin(), m.end(), [](double x) { return std::abs(x) <= kGreatestEntry; });
  if (!is_finite) refuse();
  const EigenSolver solver(matrix_of(m));
  if (!(solver.eigenvalues()[0] > kLeastEntry)) refuse();
  return entries_of(applied(solver, [](double x) { return std::log(x); }));
}

Simplex simplex_of(const std::array<int, 3>& t) { return {t[0], t[1], t[2], -1}; }

double longest_side(const std::vector<Vec3>& points, const Simplex& simplex) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i && simplex[i] >= 0; ++j) {
      const Vec3& a = points[static_cast<std::size_t>(simplex[i])];
      const Vec3& b = points[static_cast<std::size_t>(simplex[j])];
      longest = std::max(longest, (b - a).squaredNorm());
    }
  }
  return std::sqrt(longest);
}

bool is_flat(const std::vector<Vec3>& points, const Simplex& simplex) {
  const auto side = [&](std::size_t k) -> Vec3 {
    return points[static_cast<std::size_t>(simplex[k])] -
           points[static_cast<std::size_t>(simplex[0])];
  };
  const Vec3 normal = side(1).cross(side(2));
  const double longest = longest_side(points, simplex);
  if (simplex[3] < 0) return !(normal.norm() > kFlat * longest * longest);
  return !(std::abs(normal.dot(side(3))) > kFlat * longest * longest * longest);
}

/// Bounds from below of lengths, or of the logarithms of those of metrics.
struct Bounds {
  std::vector<LinearBound> of_simplices;
  std::vector<double> by_node;  ///< of the tree
};

}  // namespace

struct BackgroundSizes::Impl {
  BackgroundIn in = BackgroundIn::Space;
  std::vector<double> sizes;            ///< by point
  std::vector<SpaceMetric> logarithms;  ///< of the metrics, by point
  std::optional<SimplexTree> tree;
  std::vector<double> reaches;  ///< by simplex
  double greatest_reach = 0;
  Bounds bounds;  ///< of the lengths; of a metric in (u,v) they are those of a patch

  bool has_metrics() const { return !logarithms.empty(); }

  bool is_beyond(const NearSimplex& near) const {
    const double reach = reaches[near.simplex];
    return !(near.squared_distance <= reach * reach);
  }

  SpaceMetric log_at(const NearSimplex& near) const {
    const Simplex& simplex = tree->simplices()[near.simplex];
    SpaceMetric sum = {};
    for (std::size_t k = 0; k < 4 && simplex[k] >= 0; ++k) {
      const SpaceMetric& log = logarithms[static_cast<std::size_t>(simplex[k])];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += near.weights[k] * log[i];
    }
    return sum;
  }

  /// Call `visit` with the index of each vertex of a simplex.
  template <class Visitor>
  void for_each_vertex(std::size_t simplex, Visitor visit) const {
    for (const int vertex : tree->simplices()[simplex]) {
      if (vertex >= 0) visit(static_cast<std::size_t>(vertex));
    }
  }

  /// Bounds of what `value_at` gives for a simplex and a vertex of it.
  template <class ValueAt>
  Bounds bounds_of(ValueAt value_at) const {
    Bounds result;
    for (std::size_t s = 0; s < tree->simplices().size(); ++s) {
      std::array<double, 4> values{};
      std::size_t k = 0;
      for_each_vertex(s, [&](std::size_t v) { values[k++] = value_at(s, v); });
      result.of_simplices.push_back(
          detail::linear_bound(tree->points(), tree->simplices()[s], values));
    }
    result.by_node = tree->least_by_node(result.of_simplices);
    return result;
  }

  /// The least of the lengths by simplex that may hold in a box: those of the simplices that are
  /// nearest to its points. These are no farther from one of them than the middle of the box is
  /// from its nearest and from the point itself.
  double least_in(const Eigen::AlignedBox3d& box, const Bounds& all) const {
    const double farthest =
        std::sqrt(tree->nearest(box.center()).squared_distance) + 0.5 * box.diagonal().norm();
    const Vec3 margin = Vec3::Constant(std::min(farthest, greatest_reach));
    const Eigen::AlignedBox3d wide(box.min() - margin, box.max() + margin);
    const double least = tree->least_in(wide, all.by_node, all.of_simplices);
    return std::min(has_metrics() ? std::exp(least) : least, kNoWish);
  }

  void take_values(BackgroundMesh& mesh, std::span<const char> is_used);
  void take_simplices(BackgroundMesh& mesh);
  void bound_lengths();
  double log_least(std::size_t point) const;
};

namespace {

std::vector<Simplex> checked_simplices(const BackgroundMesh& mesh, BackgroundIn in) {
  if (in == BackgroundIn::Uv && !mesh.tetrahedra.empty()) {
    fail("a background mesh in (u,v) cannot have tetrahedra");
  }
  std::vector<Simplex> all(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  if (all.empty()) std::ranges::transform(mesh.triangles, std::back_inserter(all), simplex_of);
  if (all.empty()) fail("the background mesh has no triangles, quads or tetrahedra");
  const std::size_t corners = mesh.tetrahedra.empty() ? 3 : 4;
  for (std::size_t s = 0; s < all.size(); ++s) {
    for (std::size_t k = 0; k < corners; ++k) {
      const bool is_there =
          all[s][k] >= 0 && static_cast<std::size_t>(all[s][k]) < mesh.points.size();
      if (!is_there) fail(fmt::format("element {}, from 0, has the vertex {}", s, all[s][k]));
    }
  }
  return all;
}

}  // namespace

/// Take sizes or metrics, which those of the points must have that are used.
void BackgroundSizes::Impl::take_values(BackgroundMesh& mesh, std::span<const char> is_used) {
  const std::size_t count = mesh.points.size();
  if (mesh.sizes.empty() == mesh.metrics.empty()) {
    fail("a background mesh needs either sizes or metrics at its vertices");
  }
  if (std::max(mesh.sizes.size(), mesh.metrics.size()) != count) {
    fail(fmt::format("{} values at {} vertices", std::max(mesh.sizes.size(), mesh.metrics.size()),
                     count));
  }
  sizes = std::move(mesh.sizes);
  logarithms.resize(mesh.metrics.size());
  for (std::size_t v = 0; v < count; ++v) {
    if (is_used[v] == 0) continue;
    if (!mesh.points[v].allFinite()) fail(fmt::format("vertex {}, from 0, is not finite", v));
    if (!mesh.metrics.empty()) {
      logarithms[v] = log_metric(mesh.metrics[v], in, v);
    } else if (!(sizes[v] > 0 && sizes[v] < kNoWish)) {
      fail(
          fmt::format("the size {} at vertex {}, from 0, is not positive and finite", sizes[v], v));
    }
  }
}

void BackgroundSizes::Impl::take_simplices(BackgroundMesh& mesh) {
  if (mesh.reach && !(*mesh.reach > 0)) fail("the reach of a background mesh must be above 0");
  std::vector<Simplex> simplices = checked_simplices(mesh, in);
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const Simplex& simplex : simplices) {
    for (const int vertex : simplex) {
      if (vertex >= 0) is_used[static_cast<std::size_t>(vertex)] = 1;
    }
  }
  take_values(mesh, is_used);
  if (in == BackgroundIn::Uv) {
    for (Vec3& point : mesh.points) point.z() = 0;
  }
  std::erase_if(simplices, [&](const Simplex& s) { return is_flat(mesh.points, s); });
  if (simplices.empty()) fail("no element of the background mesh has an area or a volume");
  for (const Simplex& simplex : simplices) {
    reaches.push_back(mesh.reach.value_or(longest_side(mesh.points, simplex)));
  }
  greatest_reach = *std::max_element(reaches.begin(), reaches.end());
  tree.emplace(std::move(mesh.points), std::move(simplices));
}

/// The logarithm of the least length that the metric at a point asks for, over all directions: a
/// concave function of the logarithm of the metric, so it is not below its linear interpolation.
/// In the plane of a triangle it would not be concave.
double BackgroundSizes::Impl::log_least(std::size_t point) const {
  const EigenSolver solver(matrix_of(logarithms[point]));
  return -0.5 * solver.eigenvalues()[2];
}

void BackgroundSizes::Impl::bound_lengths() {
  if (!has_metrics()) {
    bounds = bounds_of([this](std::size_t, std::size_t v) { return sizes[v]; });
  } else if (in == BackgroundIn::Space) {
    bounds = bounds_of([this](std::size_t, std::size_t v) { return log_least(v); });
  }
}

BackgroundSizes::BackgroundSizes(BackgroundMesh mesh, BackgroundIn in) {
  auto impl = std::make_shared<Impl>();
  impl->in = in;
  impl->take_simplices(mesh);
  impl->bound_lengths();
  impl_ = std::move(impl);
}

BackgroundSizes::~BackgroundSizes() = default;

bool BackgroundSizes::has_metrics() const { return impl_->has_metrics(); }
BackgroundIn BackgroundSizes::in() const { return impl_->in; }

double BackgroundSizes::size(const Vec3& point) const {
  const NearSimplex near = impl_->tree->nearest(point);
  if (impl_->is_beyond(near)) return kNoWish;
  double size = 0;
  const Simplex& simplex = impl_->tree->simplices()[near.simplex];
  for (std::size_t k = 0; k < 4 && simplex[k] >= 0; ++k) {
    size += near.weights[k] * impl_->sizes[static_cast<std::size_t>(simplex[k])];
  }
  return size;
}

SpaceMetric BackgroundSizes::metric(const Vec3& point) const {
  const NearSimplex near = impl_->tree->nearest(point);
  constexpr double nothing = 1 / (kNoWish * kNoWish);
  if (impl_->is_beyond(near)) return {nothing, nothing, nothing, 0, 0, 0};
  EigenSolver solver;
  solver.computeDirect(matrix_of(impl_->log_at(near)));
  return entries_of(applied(solver, [](double x) { return std::exp(x); }));
}

namespace {

/// JᵀMJ, with the derivatives beside a pole where there is no tangent plane: as these are taken
/// where such a metric becomes a size.
Metric pulled_back(const SpaceMetric& metric, const Surface& surface, Uv uv) {
  Jet jet = surface.evaluate(uv, Order::First);
  if (!is_regular(first_form_factor(jet.du, jet.dv))) {
    jet = surface.evaluate(beside_pole(surface, uv), Order::First);
  }
  const Matrix m = matrix_of(metric);
  const Vec3 mu = m * jet.du, mv = m * jet.dv;
  return {jet.du.dot(mu), jet.du.dot(mv), jet.dv.dot(mv)};
}

Eigen::AlignedBox3d box_of(const UvBox& box) {
  return {Vec3(box.u.lower, box.v.lower, 0), Vec3(box.u.upper, box.v.upper, 0)};
}

/// The least length in space that a metric in (u,v), given by its logarithm, asks for at a point.
double least_length_at(const Vec3& point, const SpaceMetric& logarithm, const Surface& surface) {
  const Domain domain = surface.domain();
  const Uv uv = domain.fold(domain.clamp({point.x(), point.y()}));
  const Jet jet = surface.evaluate(uv, Order::First);
  const EigenSolver solver(matrix_of(logarithm));
  const SpaceMetric m = entries_of(applied(solver, [](double x) { return std::exp(x); }));
  const FirstFormFactor form = first_form_factor(jet.du, jet.dv);
  return size_range(size_from_metric_at(surface, uv, form, {m[0], m[3], m[1]})).least;
}

/// Bounds of the entries of a metric that asks for one length everywhere: there, no metric that
/// asks for lengths above it asks for less.
MetricBounds metric_of_length(double length, const FirstFormBounds& form) {
  const Interval scale = Interval::of(1 / (length * length));
  return {scale * form.e, scale * form.f, scale * form.g};
}

}  // namespace

FieldSource background_field(std::shared_ptr<const BackgroundSizes> background, int patch,
                             std::shared_ptr<const Surface> surface) {
  const std::shared_ptr<const BackgroundSizes::Impl> impl = background->impl_;
  const bool is_in_space = impl->in == BackgroundIn::Space;
  const auto place = [is_in_space](Uv uv, const Vec3& point) {
    return is_in_space ? point : Vec3(uv.u, uv.v, 0);
  };
  const auto box_at = [is_in_space](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    return is_in_space ? positions : box_of(box);
  };
  FieldSource source;
  source.patch = patch;
  source.uses_position = is_in_space;
  if (!impl->has_metrics()) {
    source.size = [=](Uv uv, const Vec3& p) { return background->size(place(uv, p)); };
    source.size_bounds = [=](const UvBox& box, const Eigen::AlignedBox3d& positions) {
      return Interval{impl->least_in(box_at(box, positions), impl->bounds), kNoWish};
    };
    return source;
  }
  std::shared_ptr<const Bounds> bounds(impl, &impl->bounds);
  if (!is_in_space) {
    std::vector<double> known(impl->tree->points().size(), kUnset);
    const auto log_least = [&](std::size_t, std::size_t v) {
      if (std::isnan(known[v])) {
        known[v] =
            std::log(least_length_at(impl->tree->points()[v], impl->logarithms[v], *surface));
      }
      return known[v];
    };
    bounds = std::make_shared<const Bounds>(impl->bounds_of(log_least));
  }
  source.metric = [=](Uv uv, const Vec3& p) {
    const SpaceMetric m = background->metric(place(uv, p));
    return is_in_space ? pulled_back(m, *surface, uv) : Metric{m[0], m[3], m[1]};
  };
  source.metric_bounds = [=](const UvBox& box, const Eigen::AlignedBox3d& positions) {
    const double length = impl->least_in(box_at(box, positions), *bounds);
    return metric_of_length(length, first_form_in(*surface, box));
  };
  return source;
}

}  // namespace surfmesh
