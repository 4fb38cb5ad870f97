// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/orientation.hh"

#include <cstddef>

namespace surfmesh {
namespace {

constexpr char kUnknown = 2;

/// True if the patches of both uses are oriented alike as they are: each has the contour on its
/// other side.
bool is_alike(const Contour& contour) {
  return contour.uses[0].is_forward != contour.uses[1].is_forward;
}

/// Orient what is joined to a patch like it.
/// Returns  the patches of this component
std::vector<int> spread(const Model& model, const std::vector<std::vector<int>>& contours_of,
                        int first, std::vector<char>& is_turned) {
  // Nearest first: what cannot be oriented is cut where the two ways around it meet, not along the
  // path of a search that goes on and on in one direction.
  std::vector<int> reached = {first};
  is_turned[static_cast<std::size_t>(first)] = 0;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int patch = reached[next];
    const char here = is_turned[static_cast<std::size_t>(patch)];
    for (const int c : contours_of[static_cast<std::size_t>(patch)]) {
      const Contour& contour = model.contour(c);
      const int other = contour.uses[contour.uses[0].patch == patch ? 1 : 0].patch;
      char& there = is_turned[static_cast<std::size_t>(other)];
      if (there != kUnknown) continue;
      there = is_alike(contour) ? here : static_cast<char>(1 - here);
      reached.push_back(other);
    }
  }
  return reached;
}

/// True if patches are marked as reversed, and most marks are against the orientation.
bool is_against_marks(const Model& model, const std::vector<int>& component,
                      const std::vector<char>& is_turned) {
  std::size_t marks = 0, against = 0;
  for (const int patch : component) {
    const bool is_reversed = model.patch(patch).is_reversed;
    marks += is_reversed ? 1 : 0;
    against += is_reversed != (is_turned[static_cast<std::size_t>(patch)] != 0) ? 1 : 0;
  }
  return marks > 0 && 2 * against > component.size();
}

}  // namespace

PatchOrientation orient_patches(const Model& model) {
  std::vector<std::vector<int>> contours_of(model.patches.size());
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (model.contours[c].uses.size() != 2) continue;
    for (const ContourUse& use : model.contours[c].uses) {
      contours_of[static_cast<std::size_t>(use.patch)].push_back(static_cast<int>(c));
    }
  }
  PatchOrientation result;
  result.is_turned.assign(model.patches.size(), kUnknown);
  for (std::size_t first = 0; first < model.patches.size(); ++first) {
    if (result.is_turned[first] != kUnknown) continue;
    const std::vector<int> component =
        spread(model, contours_of, static_cast<int>(first), result.is_turned);
    if (is_against_marks(model, component, result.is_turned)) {
      for (const int patch : component) {
        char& is_turned = result.is_turned[static_cast<std::size_t>(patch)];
        is_turned = static_cast<char>(1 - is_turned);
      }
    }
  }
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (contour.uses.size() != 2) continue;
    const char a = result.is_turned[static_cast<std::size_t>(contour.uses[0].patch)];
    const char b = result.is_turned[static_cast<std::size_t>(contour.uses[1].patch)];
    if ((a == b) != is_alike(contour)) result.cut_contours.push_back(static_cast<int>(c));
  }
  return result;
}

}  // namespace surfmesh
