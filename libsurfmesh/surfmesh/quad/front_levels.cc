// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/front_levels.hh"

namespace surfmesh {

bool FrontLevels::Entry::operator<(const Entry& other) const {
  if (level != other.level) return level > other.level;
  if (good_sides != other.good_sides) return good_sides < other.good_sides;
  if (length != other.length) return length > other.length;
  return other.heh < heh;
}

void FrontLevels::put(const FrontEdge& edge, int level) {
  const std::size_t i = index(edge.base);
  if (i >= levels_.size()) {
    levels_.resize(i + i / 2 + 1, 0);
    stamps_.resize(i + i / 2 + 1, 0);
  }
  levels_[i] = level;
  entries_.push({level, edge.good_sides(), edge.length, edge.base, ++stamps_[i]});
}

HalfedgeHandle FrontLevels::pop() {
  while (!entries_.empty()) {
    const Entry entry = entries_.top();
    entries_.pop();
    if (entry.stamp == stamps_[index(entry.heh)]) return entry.heh;
  }
  return HalfedgeHandle();
}

}  // namespace surfmesh
