// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/face_loops.hh"

#include <algorithm>
#include <cstddef>

namespace surfmesh {
namespace {

using Side = FaceNeighbours::Side;

class LoopTracer {
 public:
  LoopTracer(const FaceNeighbours& neighbours, const std::vector<int>& numbers, int number)
      : neighbours_(neighbours), numbers_(numbers), number_(number) {}

  bool is_border(Side side) const {
    const Side other = neighbours_.across(side);
    return other.face < 0 || numbers_[static_cast<std::size_t>(other.face)] != number_;
  }

  /// The next side of the border, around the vertex at the end of one.
  Side next(Side side) const {
    side = neighbours_.after(side);
    while (!is_border(side)) side = neighbours_.after(neighbours_.across(side));
    return side;
  }

 private:
  const FaceNeighbours& neighbours_;
  const std::vector<int>& numbers_;
  int number_;
};

}  // namespace

std::vector<FaceLoop> face_loops(const FaceNeighbours& neighbours, const std::vector<int>& faces,
                                 const std::vector<int>& numbers, int number) {
  const LoopTracer tracer(neighbours, numbers, number);
  const auto corners = static_cast<std::size_t>(neighbours.corner_count());
  std::vector<FaceLoop> loops;
  std::vector<char> is_seen(faces.size() * corners, 0);
  const auto seen = [&](Side side) -> char& {
    const auto place = std::lower_bound(faces.begin(), faces.end(), side.face) - faces.begin();
    return is_seen[static_cast<std::size_t>(place) * corners + static_cast<std::size_t>(side.side)];
  };
  for (const int face : faces) {
    for (int i = 0; i < neighbours.corner_count(); ++i) {
      if (seen({face, i}) || !tracer.is_border({face, i})) continue;
      FaceLoop& loop = loops.emplace_back();
      for (Side side{face, i}; !seen(side); side = tracer.next(side)) {
        seen(side) = 1;
        loop.push_back(side);
      }
    }
  }
  return loops;
}

}  // namespace surfmesh
