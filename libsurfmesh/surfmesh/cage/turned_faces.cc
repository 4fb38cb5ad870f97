// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/turned_faces.hh"

#include <cstddef>
#include <span>

#include "surfmesh/cage/cage_sides.hh"

namespace surfmesh {
namespace {

/// Walks from face to face and notes which ones are turned against the first of each walk.
class OrientationWalk {
 public:
  explicit OrientationWalk(const std::vector<std::vector<int>>& faces)
      : links_(faces.size()), state_(faces.size(), kUnknown) {
    const std::vector<CageSide> sides = sorted_sides(faces);
    for_each_edge(sides, [this](std::span<const CageSide> edge) {
      if (edge.size() != 2 || edge[0].face == edge[1].face) return;
      const char differs = edge[0].is_rising == edge[1].is_rising ? 1 : 0;
      links_[static_cast<std::size_t>(edge[0].face)].push_back({edge[1].face, differs});
      links_[static_cast<std::size_t>(edge[1].face)].push_back({edge[0].face, differs});
    });
  }

  std::vector<char> run() {
    for (std::size_t f = 0; f < state_.size(); ++f) {
      if (state_[f] == kUnknown) walk_from(static_cast<int>(f));
    }
    return std::move(state_);
  }

 private:
  static constexpr char kUnknown = 2;

  struct Link {
    int face = -1;
    char differs = 0;  ///< 1 if the two faces pass their edge in the same direction
  };

  char& state(int face) { return state_[static_cast<std::size_t>(face)]; }

  void walk_from(int first) {
    std::vector<int> reached = {first};
    state(first) = 0;
    bool is_two_sided = true;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const int face = reached[i];
      turned += static_cast<std::size_t>(state(face));
      for (const Link& link : links_[static_cast<std::size_t>(face)]) {
        const char wanted = static_cast<char>(state(face) ^ link.differs);
        if (state(link.face) == kUnknown) {
          state(link.face) = wanted;
          reached.push_back(link.face);
        }
        is_two_sided = is_two_sided && state(link.face) == wanted;
      }
    }
    const bool is_most = 2 * turned > reached.size();
    for (const int face : reached) {
      state(face) = is_two_sided ? static_cast<char>(state(face) ^ char{is_most}) : char{0};
    }
  }

  std::vector<std::vector<Link>> links_;
  std::vector<char> state_;  ///< by face: 1 if it is turned
};

}  // namespace

std::vector<char> turned_faces(const std::vector<std::vector<int>>& faces) {
  return OrientationWalk(faces).run();
}

}  // namespace surfmesh
