// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/append_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "surfmesh/geometry/project_to_curve.hh"

namespace surfmesh {
namespace {

/// Share of the diagonal within which contours were perhaps meant to be joined.
constexpr double kNearShare = 1e-4;

/// Places at which a contour is compared with another.
constexpr std::array<double, 5> kPlaces = {0, 0.21, 0.5, 0.83, 1};

/// A contour that one patch uses once: a true boundary.
struct OpenContour {
  const Contour* contour = nullptr;
  const Surface* surface = nullptr;
  std::vector<Vec3> points;
  Eigen::AlignedBox3d box;  ///< of the points, with a margin
};

/// `first_patch` is the index of the model's first patch in the contour uses.
std::vector<OpenContour> open_contours(const Model& model, int first_patch) {
  std::vector<OpenContour> result;
  for (const Contour& contour : model.contours) {
    if (contour.uses.size() != 1 || contour.is_degenerate) continue;
    const ContourUse& use = contour.uses[0];
    OpenContour& open = result.emplace_back();
    open.contour = &contour;
    open.surface = model.patches[static_cast<std::size_t>(use.patch - first_patch)].surface.get();
    for (const double t : kPlaces) {
      open.points.push_back(open.surface->evaluate(use.curve->evaluate(t), Order::Position).point);
      open.box.extend(open.points.back());
    }
    const Vec3 margin = Vec3::Constant(open.box.diagonal().norm() / 2);
    open.box.extend(Vec3(open.box.min() - margin));
    open.box.extend(Vec3(open.box.max() + margin));
  }
  return result;
}

/// True if all places of a contour are near another.
bool is_along(const OpenContour& a, const OpenContour& b, double near) {
  return std::all_of(a.points.begin(), a.points.end(), [&](const Vec3& point) {
    const Curve& curve = *b.contour->uses[0].curve;
    const double t = project_to_curve(*b.surface, curve, point, 0.5);
    return (b.surface->evaluate(curve.evaluate(t), Order::Position).point - point).norm() <= near;
  });
}

void warn_of_open_sides(const Model& model, const Model& added,
                        std::vector<std::string>& warnings) {
  const double near = kNearShare * (model.box.merged(added.box)).diagonal().norm();
  const std::vector<OpenContour> others =
      open_contours(added, static_cast<int>(model.patches.size()));
  std::size_t count = 0;
  std::string example;
  for (const OpenContour& a : open_contours(model, 0)) {
    for (const OpenContour& b : others) {
      if (!a.box.intersects(b.box) || (!is_along(a, b, near) && !is_along(b, a, near))) continue;
      if (count++ == 0) example = fmt::format("{} and {}", a.contour->name, b.contour->name);
    }
  }
  if (count == 0) return;
  warnings.push_back(fmt::format(
      "{} pairs of contours run along each other but are not joined, as they belong to different "
      "cages, or to a cage and formulas: {}{}",
      count, example, count > 1 ? ", ..." : ""));
}

void shift(Model& added, const Model& model, const std::string& prefix) {
  const int vertices = static_cast<int>(model.vertices.size());
  const int contours = static_cast<int>(model.contours.size());
  const int patches = static_cast<int>(model.patches.size());
  for (Contour& contour : added.contours) {
    contour.name = prefix + contour.name;
    contour.start += vertices;
    contour.end += vertices;
    for (ContourUse& use : contour.uses) use.patch += patches;
  }
  for (Patch& patch : added.patches) {
    patch.name = prefix + patch.name;
    for (Loop& loop : patch.loops) {
      for (LoopEntry& entry : loop) entry.contour += contours;
    }
  }
  for (Group& group : added.groups) {
    for (int& patch : group.patches) patch += patches;
  }
  for (std::string& warning : added.warnings) {
    if (!prefix.empty()) warning = prefix + " " + warning;
  }
}

template <class T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

void append(Model& model, Model added, const std::string& prefix) {
  shift(added, model, prefix);
  std::vector<std::string> warnings;
  warn_of_open_sides(model, added, warnings);
  move_to_end(added.vertices, model.vertices);
  move_to_end(added.contours, model.contours);
  move_to_end(added.patches, model.patches);
  move_to_end(added.groups, model.groups);
  move_to_end(added.warnings, model.warnings);
  move_to_end(warnings, model.warnings);
  model.box.extend(added.box);
  model.diagonal = model.box.diagonal().norm();
}

}  // namespace surfmesh
