// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/open_contours.hh"

#include <algorithm>
#include <array>
#include <cstddef>

#include "surfmesh/geometry/box_tree.hh"
#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Steps along a contour in which the place nearest to another one is looked for.
constexpr int kSearchSteps = 32;

/// Places at which a contour is compared with another.
constexpr std::array<double, 5> kSamples = {0, 0.21, 0.5, 0.83, 1};

/// These places, those first that tell most: contours often meet at their ends.
constexpr std::array<std::size_t, 5> kOrder = {2, 1, 3, 0, 4};

/// A contour along another is longer than this many gaps, or it is short rather than near.
constexpr double kLengthPerGap = 4;

/// True if the places of a contour are so near to another that it runs along it.
bool is_along(const OpenContour& contour, double gap, double near) {
  double length = 0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i] - contour.points[i - 1]).norm();
  }
  return gap <= near && length >= kLengthPerGap * gap;
}

/// Greatest distance of the places of a contour from another; of contours that are farther than
/// `near`, that of the first place where this shows.
double distance(const OpenContour& a, const OpenContour& b, double near) {
  double greatest = 0;
  for (const std::size_t i : kOrder) {
    if (greatest > near) break;
    const Vec3& point = a.points[i];
    const Curve& curve = *b.contour->uses[0].curve;
    const double t = project_to_curve(*b.surface, curve, point, 0.5);
    const Vec3 foot = b.surface->evaluate(curve.evaluate(t), Order::Position).point;
    greatest = std::max(greatest, (foot - point).norm());
  }
  return greatest;
}

/// True if the surface of both lies between two contours of one patch, or would but for a slit:
/// they are two sides of a wall or a slit, not of a seam.
bool are_beside_in_patch(const OpenContour& p, const OpenContour& q, double gap) {
  const ContourUse &use_p = p.contour->uses[0], &use_q = q.contour->uses[0];
  if (use_p.patch != use_q.patch) return false;
  const Uv from = use_p.curve->evaluate(0.5);
  const auto point_at = [&](Uv uv) { return p.surface->evaluate(uv, Order::Position).point; };
  const Vec3 at = point_at(from);
  Uv to = use_q.curve->evaluate(0);
  double nearest = (point_at(to) - at).norm();
  for (int i = 1; i <= kSearchSteps; ++i) {
    const Uv uv = use_q.curve->evaluate(double(i) / kSearchSteps);
    const double distance = (point_at(uv) - at).norm();
    if (distance < nearest) nearest = distance, to = uv;
  }
  return (point_at(lerp(from, to, 0.5)) - at).norm() <= std::max(gap, nearest);
}

void add_if_along(const OpenContour& p, const OpenContour& q, double near,
                  std::vector<ContourPair>& pairs) {
  double gap = distance(p, q, near);
  bool is_pair = is_along(p, gap, near);
  if (!is_pair) {
    gap = distance(q, p, near);
    is_pair = is_along(q, gap, near);
  }
  if (!is_pair || are_beside_in_patch(p, q, gap)) return;
  pairs.push_back({p.contour->name, q.contour->name, gap});
}

std::vector<BoxTree::Box> boxes_of(const std::vector<OpenContour>& contours) {
  std::vector<BoxTree::Box> boxes;
  for (const OpenContour& open : contours) boxes.push_back(open.box);
  return boxes;
}

}  // namespace

std::vector<OpenContour> open_contours(const Model& model, int first_patch) {
  std::vector<OpenContour> result;
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 1 || contour.is_degenerate) continue;
    const ContourUse& use = contour.uses[0];
    OpenContour& open = result.emplace_back();
    open.contour = &contour;
    open.surface = model.patch(use.patch - first_patch).surface.get();
    for (const double t : kSamples) {
      open.points.push_back(open.surface->evaluate(use.curve->evaluate(t), Order::Position).point);
      open.box.extend(open.points.back());
    }
    const Vec3 margin = Vec3::Constant(open.box.diagonal().norm() / 2);
    open.box = Eigen::AlignedBox3d(open.box.min() - margin, open.box.max() + margin);
  }
  return result;
}

std::vector<ContourPair> contours_along(const std::vector<OpenContour>& a,
                                        const std::vector<OpenContour>& b, double near) {
  const BoxTree tree(boxes_of(b));
  std::vector<ContourPair> pairs;
  for (const OpenContour& p : a) {
    for (const std::size_t j : tree.meeting(p.box)) {
      if (p.contour != b[j].contour) add_if_along(p, b[j], near, pairs);
    }
  }
  return pairs;
}

std::vector<ContourPair> contours_along(const std::vector<OpenContour>& all, double near) {
  const BoxTree tree(boxes_of(all));
  std::vector<ContourPair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::size_t j : tree.meeting(all[i].box)) {
      if (j > i) add_if_along(all[i], all[j], near, pairs);
    }
  }
  return pairs;
}

}  // namespace surfmesh
