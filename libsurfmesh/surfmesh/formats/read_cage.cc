// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/read_cage.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/parse_cage.hh"
#include "surfmesh/io/input_file.hh"

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

}  // namespace

CornerFault mend_corners(std::vector<int>& corners) {
  if (corners.size() >= 3 && are_all_different(corners)) return CornerFault::None;
  if (count_different(corners) < 3) return CornerFault::TooFew;
  drop_equal_neighbours(corners);
  return are_all_different(corners) ? CornerFault::TwiceInARow : CornerFault::Twice;
}

const char* text_of(CornerFault fault) {
  switch (fault) {
    case CornerFault::TwiceInARow:
      return "a face has a vertex twice in a row, taken once";
    case CornerFault::TooFew:
      return "a face has fewer than three different vertices";
    case CornerFault::Twice:
      return "a face has a vertex twice, not in a row";
    case CornerFault::None:
      break;
  }
  return "";
}

void add_face(Cage& cage, const std::vector<int>& corners, ReadFor purpose,
              const TextScanner& scanner, WarningList& warnings) {
  cage.faces.push_back(corners);
  const CornerFault fault = mend_corners(cage.faces.back());
  if (fault == CornerFault::TooFew || fault == CornerFault::Twice) scanner.fail(text_of(fault));
  if (fault == CornerFault::None) return;
  if (purpose == ReadFor::Cage) {
    cage.faces.back() = corners;
  } else {
    warnings.add(scanner.line(), text_of(fault));
  }
}

void check_not_empty(const Cage& cage, const TextScanner& scanner) {
  if (cage.points.empty()) scanner.fail_whole("the file has no vertices");
  if (cage.faces.empty()) scanner.fail_whole("the file has no faces");
}

Cage read_cage(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".obj") return parse_obj(read_file(path), path.string());
  if (ending == ".off") return parse_off(read_file(path), path.string());
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: the ending of a cage is .obj or .off", path.string()));
}

}  // namespace surfmesh
