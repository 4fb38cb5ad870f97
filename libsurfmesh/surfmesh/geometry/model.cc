// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/geometry/model.hh"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Ends of contours that are the same vertex may differ by rounding of the evaluation only.
constexpr double kLoopGap = 1e-6;

bool is_index(int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; }

const ContourUse& use_of(const Model& model, std::size_t patch, const LoopEntry& entry) {
  const std::string& patch_name = model.patches[patch].name;
  if (!is_index(entry.contour, model.contours.size())) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("patch {}: a loop names contour {} of {}", patch_name, entry.contour,
                            model.contours.size()));
  }
  const Contour& contour = model.contours[static_cast<std::size_t>(entry.contour)];
  if (!is_index(entry.use, contour.uses.size()) ||
      contour.uses[static_cast<std::size_t>(entry.use)].patch != static_cast<int>(patch)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("patch {}: a loop names use {} of contour {}, which is not this patch's",
                    patch_name, entry.use, contour.name));
  }
  return contour.uses[static_cast<std::size_t>(entry.use)];
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

Vec3 end_point(const Patch& patch, const ContourUse& use, bool at_end) {
  const double t = at_end == use.is_forward ? 1.0 : 0.0;
  return patch.surface->evaluate(use.curve->evaluate(t), Order::Position).point;
}

void check_loop(const Model& model, std::size_t patch_index, const Loop& loop) {
  const Patch& patch = model.patches[patch_index];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const LoopEntry& next = loop[(i + 1) % loop.size()];
    const Vec3 end = end_point(patch, use_of(model, patch_index, loop[i]), true);
    const Vec3 start = end_point(patch, use_of(model, patch_index, next), false);
    const double gap = (end - start).norm();
    if (!(gap <= kLoopGap * model.diagonal)) {
      throw Error(
          ErrorCode::Geometry,
          fmt::format("patch {}: the loop does not close, the gap between contours {} and {} is {}",
                      patch.name, model.contours[static_cast<std::size_t>(loop[i].contour)].name,
                      model.contours[static_cast<std::size_t>(next.contour)].name, gap));
    }
  }
}

void check_contour(const Model& model, const Contour& contour) {
  const auto refuse = [&](std::string_view reason) {
    throw Error(ErrorCode::InvalidInput, fmt::format("contour {}: {}", contour.name, reason));
  };
  if (!is_index(contour.start, model.vertices.size()) ||
      !is_index(contour.end, model.vertices.size())) {
    refuse("its end vertices do not exist");
  }
  if (contour.is_degenerate && contour.start != contour.end) {
    refuse("it is degenerate, but has two vertices");
  }
  if (contour.uses.empty()) refuse("no patch uses it");
  for (const ContourUse& use : contour.uses) check_use(model, contour, use);
}

void check_patch(const Model& model, std::size_t index) {
  const Patch& patch = model.patches[index];
  const auto refuse = [&](std::string_view reason) {
    throw Error(ErrorCode::InvalidInput, fmt::format("patch {}{}", patch.name, reason));
  };
  if (!patch.surface) refuse(" has no surface");
  if (patch.loops.empty()) refuse(" has no loop");
  for (const Loop& loop : patch.loops) {
    if (loop.empty()) refuse(": a loop is empty");
    for (const LoopEntry& entry : loop) use_of(model, index, entry);
  }
}

}  // namespace

void check_structure(const Model& model) {
  if (model.patches.empty()) throw Error(ErrorCode::InvalidInput, "the model has no patches");
  for (const Contour& contour : model.contours) check_contour(model, contour);
  for (std::size_t p = 0; p < model.patches.size(); ++p) check_patch(model, p);
}

void check(const Model& model) {
  check_structure(model);
  if (!(model.diagonal > 0 && std::isfinite(model.diagonal))) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("the model's diagonal is {}: it has no extent", model.diagonal));
  }
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    for (const Loop& loop : model.patches[p].loops) check_loop(model, p, loop);
  }
}

}  // namespace surfmesh
