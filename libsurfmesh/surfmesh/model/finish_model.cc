// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/finish_model.hh"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/geometry/parts.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/contour_smoothness.hh"
#include "surfmesh/model/merge_small.hh"
#include "surfmesh/model/pin_ends.hh"
#include "surfmesh/model/touching_loops.hh"

namespace surfmesh {
namespace {

/// Intervals of each cell of a surface, and of a patch along each side at most.
constexpr int kCellIntervals = 8;
constexpr int kMostIntervals = 100;

/// Intervals of each part of a contour.
constexpr int kPartIntervals = 8;

/// Uses whose points of equal t are nearer than this share of the diagonal, or than this share of
/// the contour's tolerance, run at the same speed.
constexpr double kSameSpeedGap = 1e-7;
constexpr double kShareOfTolerance = 0.1;

/// Share of the diagonal below which a length is none: a tenth of the gaps that loops may have.
constexpr double kLeastLength = 1e-7;

/// Contours without extent are smaller than this share of the diagonal.
constexpr double kPointExtent = 1e-9;

void set_box(Model& model) {
  if (model.box.isEmpty()) {
    for (const Patch& patch : model.patches) model.box.extend(sampled_box(*patch.surface));
  }
  model.diagonal = model.box.diagonal().norm();
}

/// Points of a contour on the patch of a use, at the ends of its divided parts.
std::vector<Vec3> points_on(const Model& model, const Contour& contour, const ContourUse& use) {
  std::vector<Vec3> points;
  for (const double t : divided_parts(contour.breaks, kPartIntervals)) {
    points.push_back(model.point(use, t));
  }
  return points;
}

double greatest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, (a[i] - b[i]).norm());
  return greatest;
}

void set_positions(Model& model) {
  for (const Contour& contour : model.contours) {
    if (contour.uses.empty()) continue;
    for (const bool is_at_end : {false, true}) {
      auto& vertex =
          model.vertices.at(static_cast<std::size_t>(is_at_end ? contour.end : contour.start));
      if (std::isnan(vertex.position.x())) {
        vertex.position = model.point(contour.uses.front(), is_at_end ? 1 : 0);
      }
    }
  }
}

void compare_uses(Model& model, Contour& contour) {
  if (contour.uses.empty()) return;
  const std::vector<Vec3> points = points_on(model, contour, contour.uses.front());
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) box.extend(point);
  const bool is_point = box.diagonal().norm() <= kPointExtent * model.diagonal;
  contour.is_degenerate |= contour.start == contour.end && is_point;
  const double allowed =
      std::max(kSameSpeedGap * model.diagonal, kShareOfTolerance * contour.tolerance);
  for (std::size_t i = 1; i < contour.uses.size(); ++i) {
    ContourUse& use = contour.uses[i];
    use.is_same_speed = greatest_distance(points, points_on(model, contour, use)) <= allowed;
  }
}

}  // namespace

Eigen::AlignedBox3d sampled_box(const Surface& surface) {
  const CellCount cells = surface.cells();
  const int columns = std::min(kCellIntervals * cells.u, kMostIntervals);
  const int rows = std::min(kCellIntervals * cells.v, kMostIntervals);
  const bool is_triangle = surface.domain().shape == Domain::Shape::Triangle;
  Eigen::AlignedBox3d box;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double s = static_cast<double>(i) / columns, t = static_cast<double>(j) / rows;
      if (is_triangle && s + t > 1) continue;
      const Uv uv = surface.from_cells({s * cells.u, t * cells.v});
      box.extend(surface.evaluate(uv, Order::Position).point);
    }
  }
  return box;
}

double gap_of(const Model& model, const Contour& contour) {
  if (contour.uses.empty()) return 0;
  const ContourUse& first = contour.uses.front();
  const std::vector<double> parameters = divided_parts(contour.breaks, kPartIntervals);
  double gap = 0;
  for (const ContourUse& use : contour.uses) {
    for (const double t : parameters) {
      const bool is_end = t == 0 || t == 1;
      const Vec3 wanted =
          is_end ? model.position(t == 0 ? contour.start : contour.end) : model.point(first, t);
      const double there = is_end || use.is_same_speed
                               ? t
                               : project_to_curve(model.surface(use), *use.curve, wanted, t);
      gap = std::max(gap, (model.point(use, there) - wanted).norm());
    }
  }
  return gap;
}

void finish(Model& model) try {
  check_indices(model);
  set_box(model);
  set_positions(model);
  merge_short_contours(model, kLeastLength * model.diagonal);
  merge_slivers(model, kLeastLength * model.diagonal);
  pin_ends(model);
  separate_touching_loops(model);
  for (Contour& contour : model.contours) compare_uses(model, contour);
  set_smoothness(model);
} catch (const std::bad_alloc&) {
  fail_without_memory("while making a model");
}

}  // namespace surfmesh
