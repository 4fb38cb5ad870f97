// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/named_contours.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/project_curve.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/patch_sides.hh"

namespace surfmesh {

PatchNumbers patch_numbers(const std::vector<PatchInput>& patches) {
  PatchNumbers numbers;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    numbers.emplace(patches[p].name, static_cast<int>(p));
  }
  return numbers;
}

std::shared_ptr<const SpaceCurve> curve_in_space(const ContourInput& contour,
                                                 const std::vector<PatchInput>& patches,
                                                 const PatchNumbers& patch_numbers) {
  if (contour.xyz) return contour.xyz;
  const auto on = std::find_if(contour.on.begin(), contour.on.end(),
                               [](const ContourInput::On& entry) { return entry.curve; });
  const auto owner = static_cast<std::size_t>(patch_numbers.at(on->patch));
  return std::make_shared<CurveOnSurface>(patches[owner].surface, on->curve);
}

NamedContours::NamedContours(Model& model, const std::vector<PatchInput>& patches,
                             const PatchNumbers& patch_numbers, const ContourLengths& lengths)
    : model_(model),
      patches_(patches),
      patch_numbers_(patch_numbers),
      lengths_(lengths),
      points_(lengths.join),
      origins_(model.contours.size()) {
  for (const ModelVertex& vertex : model.vertices) points_.add(vertex.position);
}

int NamedContours::contour_of(const ContourInput& input) {
  const auto [entry, is_new] =
      indices_.try_emplace(&input, static_cast<int>(model_.contours.size()));
  if (!is_new) return entry->second;
  const std::shared_ptr<const SpaceCurve> xyz = curve_in_space(input, patches_, patch_numbers_);
  Contour result;
  result.name = input.name;
  result.is_named = true;
  result.breaks = input.breaks;
  result.start = vertex_at(xyz->evaluate(0));
  result.end = vertex_at(xyz->evaluate(1));
  const Vec3 first = xyz->evaluate(0);
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  result.is_degenerate = std::all_of(parameters.begin(), parameters.end(), [&](double t) {
    return (xyz->evaluate(t) - first).norm() <= lengths_.join;
  });
  model_.contours.push_back(std::move(result));
  origins_.push_back({xyz, input.range});
  return entry->second;
}

/// The vertex at a point, the first one if there are several; a new one if there is none.
int NamedContours::vertex_at(const Vec3& point) {
  const std::vector<std::size_t> near = points_.near(point);
  if (!near.empty()) return static_cast<int>(*std::min_element(near.begin(), near.end()));
  points_.add(point);
  model_.vertices.push_back({point});
  return static_cast<int>(model_.vertices.size()) - 1;
}

void NamedContours::lie_along(const LoopEntry& entry) {
  std::shared_ptr<const SpaceCurve>& xyz = origin(entry.contour).xyz;
  if (xyz) return;
  const ContourUse& use = model_.use(entry);
  xyz = std::make_shared<CurveOnSurface>(model_.patch(use).surface, use.curve);
}

int NamedContours::add_use(int contour, int patch, std::shared_ptr<const Curve> curve,
                           const std::string& location) {
  if (!curve) curve = project(contour, patch, location);
  ContourUse added{patch, std::move(curve), true, true};
  check_same_point(contour, added, location);
  added.is_same_speed = is_same_speed(contour, added);
  std::vector<ContourUse>& uses = model_.contour(contour).uses;
  uses.push_back(std::move(added));
  return static_cast<int>(uses.size()) - 1;
}

std::shared_ptr<const Curve> NamedContours::project(int contour, int patch,
                                                    const std::string& location) const {
  try {
    return project_curve(model_.patch(patch).surface, origin(contour).xyz, lengths_.reach,
                         origin(contour).range);
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}: {}", location, error.what()));
  }
}

/// True if equal t of a use and of the first one are equal points.
bool NamedContours::is_same_speed(int contour, const ContourUse& use) const {
  const std::vector<ContourUse>& uses = model_.contour(contour).uses;
  if (uses.empty()) return true;
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  return std::all_of(parameters.begin(), parameters.end(), [&](double t) {
    return (model_.point(uses.front(), t) - model_.point(use, t)).norm() < lengths_.reach;
  });
}

/// Fail if a use is elsewhere than the contour in space and than its first use.
void NamedContours::check_same_point(int contour, const ContourUse& use,
                                     const std::string& location) const {
  const std::vector<ContourUse>& uses = model_.contour(contour).uses;
  double greatest = 0, where = 0;
  for (const double t : sample_parameters(kLineSamples)) {
    const Vec3 here = model_.point(use, t);
    double gap = (origin(contour).xyz->evaluate(t) - here).norm();
    if (!uses.empty()) {
      const ContourUse& first = uses.front();
      // Ends have to meet at the same t, so that the direction is the same.
      const double foot =
          t == 0 || t == 1 ? t : project_to_curve(model_.surface(first), *first.curve, here, t);
      gap = std::min(gap, (model_.point(first, foot) - here).norm());
    }
    if (gap > greatest) std::tie(greatest, where) = std::pair(gap, t);
  }
  if (greatest < lengths_.reach) return;
  throw Error(ErrorCode::Geometry,
              fmt::format("{}: at t = {:.6g} it is {:.3g} away from where it is elsewhere, which "
                          "must be below {:.3g}",
                          location, range(contour).at(where), greatest, lengths_.reach));
}

}  // namespace surfmesh
