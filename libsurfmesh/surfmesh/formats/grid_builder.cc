// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/grid_builder.hh"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/cage_text.hh"

namespace surfmesh {
namespace {

/// A side of faces, whichever way it is passed.
std::uint64_t key_of(int a, int b) {
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  const auto high = static_cast<std::uint64_t>(std::max(a, b));
  return high << 32 | low;
}

/// Numbers that count from 1 are at most so many times as great as there are different ones.
constexpr std::int64_t kMostGaps = 2;

/// No side has this one.
constexpr std::int64_t kNoReference = std::numeric_limits<std::int64_t>::min();

}  // namespace

std::vector<std::int64_t> index_numbers(std::span<const std::int64_t> numbers, std::int64_t none,
                                        std::vector<int>& indices) {
  std::vector<std::int64_t> different(numbers.begin(), numbers.end());
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  std::erase(different, none);
  const bool counts_from_1 =
      !different.empty() && different.front() >= 1 &&
      different.back() <= kMostGaps * static_cast<std::int64_t>(different.size());
  if (counts_from_1) {
    different.resize(static_cast<std::size_t>(different.back()));
    std::iota(different.begin(), different.end(), 1);
  }
  indices.clear();
  indices.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    const auto found = std::lower_bound(different.begin(), different.end(), number);
    indices.push_back(number == none ? -1 : static_cast<int>(found - different.begin()));
  }
  return different;
}

bool GridBuilder::add_face(std::span<const int> vertices, std::int64_t reference) {
  const std::size_t number = face_count_++;
  corners_.assign(vertices.begin(), vertices.end());
  switch (mend_corners(corners_)) {
    case CornerFault::TooFew:
      grid.degenerate_faces.push_back(number);
      return false;
    case CornerFault::Twice:
      throw Error(ErrorCode::InvalidInput, fmt::format("{}: face {}, from 0: {}", name_, number,
                                                       text_of(CornerFault::Twice)));
    case CornerFault::TwiceInARow:
      ++mended_;
      break;
    case CornerFault::None:
      break;
  }
  grid.faces.add(corners_);
  references_.push_back(reference);
  return true;
}

void GridBuilder::add_side(int from, int to, std::int64_t reference) {
  if (from != to) sides_.push_back({from, to, reference});
}

std::vector<std::int64_t> GridBuilder::number_patches(std::int64_t none) {
  const bool are_none = std::all_of(references_.begin(), references_.end(),
                                    [&](std::int64_t reference) { return reference == none; });
  if (are_none) return {};
  return index_numbers(references_, none, grid.patches);
}

std::vector<std::int64_t> GridBuilder::number_contours() {
  if (sides_.empty()) return {};
  std::vector<std::int64_t> references;
  for (const Side& side : sides_) references.push_back(side.reference);
  std::vector<int> indices;
  std::vector<std::int64_t> numbers = index_numbers(references, kNoReference, indices);
  std::unordered_map<std::uint64_t, int> contour_of;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    contour_of.emplace(key_of(sides_[i].from, sides_[i].to), indices[i]);
  }
  grid.contours.assign(grid.faces.corner_count(), -1);
  for (std::size_t f = 0; f < grid.faces.size(); ++f) {
    const std::span<const int> face = grid.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto found = contour_of.find(key_of(face[k], face[(k + 1) % face.size()]));
      if (found != contour_of.end()) grid.contours[grid.faces.first_corner(f) + k] = found->second;
    }
  }
  return numbers;
}

GridFile GridBuilder::finish() {
  const auto warn = [&](std::size_t count, CornerFault fault) {
    if (count == 0) return;
    grid.notices.push_back(warning_at(name_, NoticeKind::IgnoredInput, text_of(fault)));
    grid.notices.back().count = count;
  };
  warn(grid.degenerate_faces.size(), CornerFault::TooFew);
  warn(mended_, CornerFault::TwiceInARow);
  for (const auto& [what, count] : left_out_) {
    grid.unread.push_back(fmt::format("{} {}", count, what));
  }
  return std::move(grid);
}

}  // namespace surfmesh
