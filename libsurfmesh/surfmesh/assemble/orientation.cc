// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/orientation.hh"

#include <queue>

namespace surfmesh {
namespace {

constexpr char kUnknown = 2;

/// True if the patches of both uses are oriented alike as they are: each has the contour on its
/// other side.
bool is_alike(const Contour& contour) {
  return contour.uses[0].is_forward != contour.uses[1].is_forward;
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
  // Nearest first: what cannot be oriented is cut where the two ways around it meet, not along the
  // path of a search that goes on and on in one direction.
  std::queue<int> reached;
  for (std::size_t first = 0; first < model.patches.size(); ++first) {
    if (result.is_turned[first] != kUnknown) continue;
    result.is_turned[first] = 0;
    reached.push(static_cast<int>(first));
    while (!reached.empty()) {
      const int patch = reached.front();
      reached.pop();
      const char here = result.is_turned[static_cast<std::size_t>(patch)];
      for (const int c : contours_of[static_cast<std::size_t>(patch)]) {
        const Contour& contour = model.contour(c);
        const int other = contour.uses[contour.uses[0].patch == patch ? 1 : 0].patch;
        char& there = result.is_turned[static_cast<std::size_t>(other)];
        if (there != kUnknown) continue;
        there = is_alike(contour) ? here : static_cast<char>(1 - here);
        reached.push(other);
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
