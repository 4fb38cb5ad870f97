// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/cage_text.hh"

#include <algorithm>
#include <utility>

namespace surfmesh {
namespace {

/// Up to this many corners, comparing all pairs is faster than sorting.
constexpr std::size_t kFewCorners = 12;

std::size_t count_different(const std::vector<int>& corners) {
  std::vector<int> sorted = corners;
  std::sort(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
}

bool are_all_different(const std::vector<int>& corners) {
  if (corners.size() > kFewCorners) return count_different(corners) == corners.size();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (corners[i] == corners[j]) return false;
    }
  }
  return true;
}

/// Drop all but one of equal vertices in a row, also across the end.
void drop_equal_neighbours(std::vector<int>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
}

/// True if the border of a face runs along each of its edges there and back: 0 1 0 2. No two equal
/// vertices may follow each other.
bool has_no_inside(const std::vector<int>& corners) {
  // What is left without the tips: a b a is a.
  std::vector<int> open;
  for (const int corner : corners) {
    if (open.size() > 1 && open[open.size() - 2] == corner) {
      open.pop_back();
    } else {
      open.push_back(corner);
    }
  }
  // A tip across the end has its two sides at the ends of the list.
  std::size_t first = 0, end = open.size();
  while (end - first > 2) {
    if (open[end - 2] == open[first]) {
      end -= 2;
    } else if (open[end - 1] == open[first + 1]) {
      ++first;
      --end;
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

CornerFault mend_corners(std::vector<int>& corners) {
  if (corners.size() >= 3 && are_all_different(corners)) return CornerFault::None;
  if (count_different(corners) < 3) return CornerFault::TooFew;
  drop_equal_neighbours(corners);
  if (are_all_different(corners)) return CornerFault::TwiceInARow;
  return has_no_inside(corners) ? CornerFault::TooFew : CornerFault::Twice;
}

const char* text_of(CornerFault fault) {
  switch (fault) {
    case CornerFault::TwiceInARow:
      return "a face has a vertex twice in a row, taken once";
    case CornerFault::TooFew:
      return "a face without three different vertices, or without an inside, is left out";
    case CornerFault::Twice:
      return "a face has a vertex twice, not in a row";
    case CornerFault::None:
      break;
  }
  return "";
}

void CageText::begin() {
  if (!scanner.next_line()) scanner.fail_whole("the file is empty");
}

bool CageText::add_face(const std::vector<int>& corners) {
  cage.faces.push_back(corners);
  const CornerFault fault = mend_corners(cage.faces.back());
  if (fault == CornerFault::None) return true;
  if (fault == CornerFault::Twice) scanner.fail(text_of(fault));
  if (fault == CornerFault::TooFew) {
    cage.faces.pop_back();
    left_out_.push_back(static_cast<int>(cage.faces.size() + left_out_.size()));
    warnings.add(scanner.line(), text_of(fault));
    return false;
  }
  if (purpose_ == ReadFor::Cage) {
    cage.faces.back() = corners;
  } else {
    warnings.add(scanner.line(), text_of(fault));
  }
  return true;
}

Vec3 CageText::divided(const Vec3& point, double weight) {
  if (weight == 1) return point;
  if (weight == 0) scanner.fail("the weight of a vertex is 0");
  warnings.add(scanner.line(), "coordinates are divided by the weight after them");
  const Vec3 result = point / weight;
  if (!result.allFinite()) scanner.fail("the weight of a vertex is too small");
  return result;
}

void CageText::check_not_empty() const {
  if (cage.points.empty()) scanner.fail_whole("the file has no vertices");
  if (cage.faces.empty()) scanner.fail_whole("the file has no faces");
}

Cage CageText::finish() {
  cage.notices = warnings.notices();
  return std::move(cage);
}

MeshArraysFile arrays_of(Cage cage) {
  MeshArraysFile file;
  file.mesh.points = std::move(cage.points);
  file.mesh.faces.reserve(cage.faces.size(), 3 * cage.faces.size());
  for (const std::vector<int>& face : cage.faces) file.mesh.faces.add(face);
  file.notices = std::move(cage.notices);
  return file;
}

}  // namespace surfmesh
