// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/front_parity.hh"

#include <algorithm>

namespace surfmesh {

/// One front halfedge for each run of sides of the quad that are fronts without a break.
std::vector<HalfedgeHandle> FrontParity::runs(FaceHandle quad) const {
  std::vector<HalfedgeHandle> sides, starts;
  for (const HalfedgeHandle heh : mesh_.mesh().fh_range(quad)) {
    const HalfedgeHandle opposite = mesh_.mesh().opposite_halfedge_handle(heh);
    if (mesh_.is_front(opposite)) sides.push_back(opposite);
  }
  for (const HalfedgeHandle side : sides) {
    const HalfedgeHandle before = mesh_.previous_front(side);
    if (std::find(sides.begin(), sides.end(), before) == sides.end()) starts.push_back(side);
  }
  return starts;
}

/// One front edge on. Two runs that meet are parts of one loop, which cuts nothing off.
FrontParity::Step FrontParity::step_along(Walker& walker) const {
  walker.is_odd = !walker.is_odd;
  walker.at = mesh_.next_front(walker.at);
  if (walker.at == walker.start) return Step::HasClosed;
  const bool has_met = std::any_of(walkers_.begin(), walkers_.end(),
                                   [&](const Walker& other) { return walker.at == other.start; });
  return has_met ? Step::HasMet : Step::GoesOn;
}

/// Look at one more triangle of the region.
FrontParity::Step FrontParity::step_through(Walker& walker, int number) {
  if (walker.next == walker.faces.size()) {
    walker.is_odd = walker.faces.size() % 2 != 0;
    return Step::HasClosed;
  }
  for (const HalfedgeHandle heh : mesh_.mesh().fh_range(walker.faces[walker.next++])) {
    const FaceHandle beyond = mesh_.mesh().face_handle(mesh_.mesh().opposite_halfedge_handle(heh));
    if (!mesh_.is_triangle(beyond)) continue;
    int& seen = seen_[index(beyond)];
    if (seen == number) continue;
    if (seen > walks_) return Step::HasMet;
    seen = number;
    walker.faces.push_back(beyond);
  }
  return Step::GoesOn;
}

bool FrontParity::is_even_around(FaceHandle quad) {
  walkers_.clear();
  for (const HalfedgeHandle start : runs(quad)) {
    walkers_.push_back({start, start, false, {mesh_.mesh().face_handle(start)}, 0});
  }
  if (walkers_.size() < 2) return true;
  seen_.resize(mesh_.mesh().n_faces(), 0);
  const int count = static_cast<int>(walkers_.size());
  if (has_odd_loops_) {
    for (int w = 0; w < count; ++w) {
      seen_[index(walkers_[static_cast<std::size_t>(w)].faces.front())] = walks_ + 1 + w;
    }
  }
  // All in turns, so that it takes no longer than the smaller parts ask for. What is left when all
  // but one have come to an end is even if they are.
  std::vector<char> has_ended(walkers_.size(), 0);
  bool is_even = true;
  for (int walking = count; walking > 1 && is_even;) {
    for (std::size_t w = 0; w < walkers_.size() && walking > 1; ++w) {
      if (has_ended[w]) continue;
      Walker& walker = walkers_[w];
      const Step step = has_odd_loops_ ? step_through(walker, walks_ + 1 + static_cast<int>(w))
                                       : step_along(walker);
      if (step == Step::GoesOn) continue;
      has_ended[w] = 1;
      --walking;
      if (step == Step::HasClosed && walker.is_odd) is_even = false;
    }
  }
  walks_ += count;
  return is_even;
}

}  // namespace surfmesh
