// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

/// Ends of contours that are the same vertex may differ by rounding of the evaluation only.
constexpr double kLoopGap = 1e-6;

/// Beyond these diagonals the squares of areas and of their inverses, that is the fourth powers of
/// lengths down to a millionth of it, are no numbers of full precision.
constexpr double kLeastDiagonal = 1e-70;
constexpr double kGreatestDiagonal = 1e70;

/// Beyond so many diagonals from the origin, coordinates are rounded to 1e-5 of the diagonal: a
/// hundredth of the smallest elements, unless smaller ones are asked for.
constexpr double kMostDistance = 1e11;

bool is_index(int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; }

const ContourUse& use_of(const Model& model, std::size_t patch, const LoopEntry& entry) {
  const std::string& patch_name = model.patches[patch].name;
  if (!is_index(entry.contour, model.contours.size())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("patch {}: a loop names contour {} of {}", patch_name, entry.contour,
                            model.contours.size()));
  }
  const Contour& contour = model.contour(entry);
  if (!is_index(entry.use, contour.uses.size()) ||
      model.use(entry).patch != static_cast<int>(patch)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("patch {}: a loop names use {} of contour {}, which is not this patch's",
                    patch_name, entry.use, contour.name));
  }
  return model.use(entry);
}

void check_use(const Model& model, const Contour& contour, const ContourUse& use) {
  if (!is_index(use.patch, model.patches.size())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("contour {}: a use names patch {} of {}", contour.name, use.patch,
                            model.patches.size()));
  }
  if (!use.curve) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("contour {}: a use has no curve", contour.name));
  }
}

Vec3 end_point(const Model& model, const ContourUse& use, bool at_end) {
  return model.point(use, at_end == use.is_forward ? 1.0 : 0.0);
}

void check_loop(const Model& model, std::size_t patch_index, const PatchLoop& loop) {
  const Patch& patch = model.patches[patch_index];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const LoopEntry& next = loop[(i + 1) % loop.size()];
    const Vec3 end = end_point(model, use_of(model, patch_index, loop[i]), true);
    const Vec3 start = end_point(model, use_of(model, patch_index, next), false);
    const double gap = (end - start).norm();
    const double allowed = allowed_gap(model, model.contour(loop[i]), model.contour(next));
    if (!(gap <= allowed)) {
      throw Error(
          ErrorCode::Geometry,
          fmt::format("patch {}: the loop does not close, the gap between contours {} and {} is {}",
                      patch.name, model.contour(loop[i].contour).name, model.contour(next).name,
                      gap));
    }
  }
}

void check_extent(double diagonal) {
  if (diagonal >= kLeastDiagonal && diagonal <= kGreatestDiagonal) return;
  const char* reason = diagonal > kGreatestDiagonal ? "it is too large"
                       : diagonal > 0               ? "it is too small"
                                                    : "it has no extent";
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the model's diagonal is {}: {}", diagonal, reason));
}

void check_distance(const Model& model) {
  const double distance = model.box.center().cwiseAbs().maxCoeff();
  if (!(distance > kMostDistance * model.diagonal)) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the model lies too far from the origin: coordinates of {:.3g} have too "
                          "few digits for a shape whose diagonal is {:.3g}; move it to the origin",
                          distance, model.diagonal));
}

[[noreturn]] void fail_name(const char* what, std::string_view name,
                            const std::vector<std::string_view>& known) {
  const auto meant = nearest_word(name, known);
  throw Error(ErrorCode::InvalidInput,
              fmt::format("the model has no {} {}{}", what, name,
                          meant ? fmt::format(", did you mean {}?", *meant) : ""));
}

}  // namespace

std::string label(const Patch& patch) {
  if (patch.origin.empty()) return fmt::format("patch {}", patch.name);
  return fmt::format("{}: patch {}", patch.origin, patch.name);
}

int find_contour(const Model& model, std::string_view name) {
  const auto found = std::find_if(model.contours.begin(), model.contours.end(),
                                  [name](const Contour& contour) { return contour.name == name; });
  return found == model.contours.end() ? -1 : static_cast<int>(found - model.contours.begin());
}

int find_patch(const Model& model, std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    if (model.patches[p].name == name) return static_cast<int>(p);
    names.push_back(model.patches[p].name);
  }
  fail_name("patch", name, names);
}

std::vector<int> find_group(const Model& model, std::string_view name) {
  std::set<int> patches;
  std::vector<std::string_view> names;
  bool is_found = false;
  for (const Group& group : model.groups) {
    names.push_back(group.name);
    if (group.name != name) continue;
    is_found = true;
    patches.insert(group.patches.begin(), group.patches.end());
  }
  if (!is_found) fail_name("group", name, names);
  return {patches.begin(), patches.end()};
}

MeshNames mesh_names(const Model& model) {
  MeshNames names;
  for (const Patch& patch : model.patches) names.patches.push_back(patch.name);
  for (const Contour& contour : model.contours) names.contours.push_back(contour.name);
  for (const Group& group : model.groups) {
    const auto same = std::find_if(names.groups.begin(), names.groups.end(),
                                   [&](const Group& other) { return other.name == group.name; });
    Group& whole = same == names.groups.end() ? names.groups.emplace_back() : *same;
    whole.name = group.name;
    whole.is_material |= group.is_material;
    whole.patches.insert(whole.patches.end(), group.patches.begin(), group.patches.end());
  }
  put_in_order(names.groups);
  return names;
}

double greatest_tolerance(const Model& model) {
  double greatest = 0;
  for (const ModelVertex& vertex : model.vertices) greatest = std::max(greatest, vertex.tolerance);
  for (const Contour& contour : model.contours) greatest = std::max(greatest, contour.tolerance);
  return greatest;
}

double allowed_gap(const Model& model, const Contour& before, const Contour& after) {
  double tolerance = before.tolerance + after.tolerance;
  for (const int vertex : {before.start, before.end}) {
    if (vertex != after.start && vertex != after.end) continue;
    tolerance += 2 * model.vertices[static_cast<std::size_t>(vertex)].tolerance;
  }
  return std::max(kLoopGap * model.diagonal, tolerance);
}

void check_indices(const Model& model) {
  for (const Contour& contour : model.contours) {
    if (!is_index(contour.start, model.vertices.size()) ||
        !is_index(contour.end, model.vertices.size())) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("contour {}: its end vertices do not exist", contour.name));
    }
    if (contour.is_degenerate && contour.start != contour.end) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("contour {} is degenerate, but has two vertices", contour.name));
    }
    if (contour.uses.empty()) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("contour {}: no patch uses it", contour.name));
    }
    for (const ContourUse& use : contour.uses) check_use(model, contour, use);
  }
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const Patch& patch = model.patches[p];
    if (!patch.surface) {
      throw Error(ErrorCode::InvalidInput, fmt::format("patch {} has no surface", patch.name));
    }
    if (patch.loops.empty()) {
      throw Error(ErrorCode::InvalidInput, fmt::format("patch {} has no loop", patch.name));
    }
    for (const PatchLoop& loop : patch.loops) {
      if (loop.empty()) {
        throw Error(ErrorCode::InvalidInput, fmt::format("patch {}: a loop is empty", patch.name));
      }
      for (const LoopEntry& entry : loop) use_of(model, p, entry);
    }
  }
}

void check(const Model& model) {
  if (model.patches.empty()) throw Error(ErrorCode::InvalidInput, "the model has no patches");
  check_extent(model.diagonal);
  check_distance(model);
  check_indices(model);
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    for (const PatchLoop& loop : model.patches[p].loops) check_loop(model, p, loop);
  }
}

}  // namespace surfmesh
