// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/glue_sides.hh"

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>

#include "surfmesh/model/joined_uses.hh"

namespace surfmesh::detail {
namespace {

/// A side, filed under its two vertices whichever way it leads.
struct FiledSide {
  std::uint64_t vertices;  ///< the smaller one in the high half
  int side;

  friend bool operator<(const FiledSide& a, const FiledSide& b) {
    return std::tie(a.vertices, a.side) < std::tie(b.vertices, b.side);
  }
};

std::vector<FiledSide> file_by_vertices(const std::vector<BorderSide>& sides) {
  std::vector<FiledSide> filed;
  filed.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto [smaller, larger] = std::minmax(sides[i].from, sides[i].to);
    filed.push_back({static_cast<std::uint64_t>(smaller) << 32 | static_cast<std::uint64_t>(larger),
                     static_cast<int>(i)});
  }
  std::sort(filed.begin(), filed.end());
  return filed;
}

/// The pairs of patches that are joined at each contour of three and more uses; none at others.
std::vector<std::vector<std::array<int, 2>>> joined_patches(const Model& model,
                                                            const std::vector<int>& cut_contours) {
  std::vector<std::vector<std::array<int, 2>>> result(model.contours.size());
  const bool has_shared =
      std::any_of(model.contours.begin(), model.contours.end(),
                  [](const Contour& contour) { return contour.uses.size() > 2; });
  if (!has_shared) return result;
  auto joined = joined_uses(model);
  for (const int c : cut_contours) joined[static_cast<std::size_t>(c)].clear();
  for (std::size_t c = 0; c < joined.size(); ++c) {
    const std::vector<ContourUse>& uses = model.contours[c].uses;
    if (uses.size() < 3) continue;
    for (const UsePair& pair : joined[c]) {
      result[c].push_back({uses[static_cast<std::size_t>(pair[0])].patch,
                           uses[static_cast<std::size_t>(pair[1])].patch});
    }
  }
  return result;
}

class Gluing {
 public:
  Gluing(const std::vector<BorderSide>& sides, const Model& model,
         const std::vector<int>& cut_contours)
      : sides_(sides), joined_(joined_patches(model, cut_contours)) {
    result_.side_count = sides.size();
  }

  /// Glue what it can of the sides between the same two vertices.
  void glue(std::span<const FiledSide> filed) {
    rest_.clear();
    for (const FiledSide& side : filed) rest_.push_back(side.side);
    if (rest_.size() > 1) glue_joined();
    if (rest_.size() == 2 && at(rest_[0]).from == at(rest_[1]).to) {
      result_.edges.push_back({rest_[0], rest_[1]});
      return;
    }
    if (rest_.size() > 1) result_.cut += rest_.size();
    for (const int side : rest_) result_.edges.push_back({side, -1});
  }

  GluedSides take_result() { return std::move(result_); }

 private:
  const BorderSide& at(int side) const { return sides_[static_cast<std::size_t>(side)]; }

  /// Take out of the rest what is joined by the model.
  void glue_joined() {
    for (std::size_t i = 0; i < rest_.size();) {
      const auto first = rest_.begin() + static_cast<std::ptrdiff_t>(i);
      const auto other = std::find_if(first + 1, rest_.end(),
                                      [&](int side) { return are_joined(at(*first), at(side)); });
      if (other == rest_.end()) {
        ++i;
        continue;
      }
      result_.edges.push_back({*first, *other});
      rest_.erase(other);
      rest_.erase(first);
    }
  }

  bool are_joined(const BorderSide& a, const BorderSide& b) const {
    if (a.contour < 0 || a.contour != b.contour) return false;
    const auto& pairs = joined_[static_cast<std::size_t>(a.contour)];
    return std::any_of(pairs.begin(), pairs.end(), [&](const std::array<int, 2>& pair) {
      return (pair[0] == a.patch && pair[1] == b.patch) ||
             (pair[0] == b.patch && pair[1] == a.patch);
    });
  }

  const std::vector<BorderSide>& sides_;
  std::vector<std::vector<std::array<int, 2>>> joined_;  ///< by contour
  std::vector<int> rest_;
  GluedSides result_;
};

}  // namespace

GluedSides glue_sides(const std::vector<BorderSide>& sides, const Model& model,
                      const std::vector<int>& cut_contours) {
  const std::vector<FiledSide> filed = file_by_vertices(sides);
  Gluing gluing(sides, model, cut_contours);
  for (auto first = filed.begin(); first != filed.end();) {
    const auto last = std::find_if(first, filed.end(), [&](const FiledSide& side) {
      return side.vertices != first->vertices;
    });
    gluing.glue({first, last});
    first = last;
  }
  return gluing.take_result();
}

}  // namespace surfmesh::detail
