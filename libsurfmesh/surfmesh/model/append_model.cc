// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/append_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "surfmesh/core/counted.hh"
#include "surfmesh/model/open_contours.hh"

namespace surfmesh {
namespace {

void warn_of_open_sides(const Model& model, const Model& added, Notices& notices) {
  const double near = kNearShare * model.box.merged(added.box).diagonal().norm();
  const std::vector<ContourPair> pairs = contours_along(
      open_contours(model), open_contours(added, static_cast<int>(model.patches.size())), near);
  if (pairs.empty()) return;
  notices.push_back(
      warning(NoticeKind::UnjoinedSides,
              fmt::format("{} run along each other without being joined, as they belong to "
                          "different cages or CAD files, or to a "
                          "cage and formulas: {} and {}{}",
                          counted(pairs.size(), "pair of contours", "pairs of contours"),
                          pairs[0].a, pairs[0].b, pairs.size() > 1 ? ", ..." : "")));
  notices.back().contour = find_contour(model, pairs[0].a);
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
    for (PatchLoop& loop : patch.loops) {
      for (LoopEntry& entry : loop) entry.contour += contours;
    }
  }
  for (Group& group : added.groups) {
    for (int& patch : group.patches) patch += patches;
  }
  for (MadeWith& option : added.made_with) option.part.insert(0, prefix);
  for (SurfaceFit& fit : added.fits) fit.part.insert(0, prefix);
  for (Notice& notice : added.notices) {
    if (!prefix.empty()) locate(prefix.substr(0, prefix.rfind(':')), notice);
    if (notice.patch >= 0) notice.patch += patches;
    if (notice.contour >= 0) notice.contour += contours;
  }
}

template <class T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace

void append(Model& model, Model added, const std::string& prefix) {
  shift(added, model, prefix);
  Notices notices;
  warn_of_open_sides(model, added, notices);
  move_to_end(added.vertices, model.vertices);
  move_to_end(added.contours, model.contours);
  move_to_end(added.patches, model.patches);
  move_to_end(added.groups, model.groups);
  move_to_end(added.notices, model.notices);
  move_to_end(notices, model.notices);
  move_to_end(added.made_with, model.made_with);
  move_to_end(added.fits, model.fits);
  model.box.extend(added.box);
  model.diagonal = model.box.diagonal().norm();
  model.joining = std::max(model.joining, added.joining);
}

}  // namespace surfmesh
