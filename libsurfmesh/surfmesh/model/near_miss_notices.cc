// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/near_miss_notices.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "surfmesh/model/near_misses.hh"

namespace surfmesh {
namespace {

/// More of them are only counted.
constexpr std::size_t kMostNotices = 20;

/// The first joining that is tried, in gaps, how much it grows from one trial to the next, and the
/// trials: up to some twenty gaps, as sides may be apart and shifted along each other by more.
constexpr double kFirstTrial = 1.3, kTrialGrowth = 2;
constexpr int kTrials = 5;

using SideNames = std::set<std::string>;

bool intersect(const SideNames& a, const SideNames& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& name) { return b.contains(name); });
}

const MatchedCurve& curve_at(const MatchedSides& matched, int index) {
  return matched.curves[static_cast<std::size_t>(index)];
}

SideNames sides_along(const MatchedSides& matched, int curve) {
  SideNames result;
  for (const MatchedPiece& piece : curve_at(matched, curve).pieces) {
    result.insert(matched.side_of(piece).name);
  }
  return result;
}

/// The pieces of sides with a vertex at an end of a curve.
template <class Visit>
void visit_around(const MatchedSides& matched, int curve, const Visit& visit) {
  const SidePiece& own = matched.front_of(curve_at(matched, curve));
  for (const SidePiece& piece : matched.split.pieces) {
    for (const int vertex : {piece.start, piece.end}) {
      if (vertex == own.start || vertex == own.end) visit(piece);
    }
  }
}

/// The sides that a near miss is about.
struct MissedSides {
  SideNames a;
  SideNames b;
  bool is_pair = true;  ///< that runs along each other; else those of `b` end on those of `a`

  /// True if a near miss is about sides of both.
  bool meet(const MissedSides& other) const {
    return (intersect(a, other.a) || intersect(a, other.b)) &&
           (intersect(b, other.a) || intersect(b, other.b));
  }
};

MissedSides sides_of(const MatchedSides& matched, const NearMiss& miss) {
  MissedSides result{sides_along(matched, miss.a), {}, miss.b >= 0};
  if (result.is_pair) {
    result.b = sides_along(matched, miss.b);
    return result;
  }
  visit_around(matched, miss.a, [&](const SidePiece& piece) {
    const std::string& name = matched.sides[static_cast<std::size_t>(piece.side)].name;
    if (!result.a.contains(name)) result.b.insert(name);
  });
  return result;
}

/// The sides of the patches that have one of those of a near miss, or one that ends there.
std::vector<PatchSide> sides_around(const MatchedSides& matched, const NearMiss& miss) {
  std::set<int> patches;
  for (const int curve : {miss.a, miss.b}) {
    if (curve < 0) continue;
    visit_around(matched, curve, [&](const SidePiece& piece) { patches.insert(piece.line.patch); });
  }
  std::vector<PatchSide> result;
  for (const PatchSide& side : matched.sides) {
    if (patches.contains(side.curve.line.patch)) result.push_back(side);
  }
  return result;
}

/// True if a piece of one side is joined with one of the other.
bool is_shared(const MatchedSides& matched, const MatchedCurve& curve, const MissedSides& sides) {
  for (const MatchedPiece& p : curve.pieces) {
    for (const MatchedPiece& q : curve.pieces) {
      if (p.piece != q.piece && sides.a.contains(matched.side_of(p).name) &&
          sides.b.contains(matched.side_of(q).name)) {
        return true;
      }
    }
  }
  return false;
}

/// True if sides that run along each other, or that end near to each other on one of them, are
/// joined now, wherever they are near.
bool are_joined(const MatchedSides& matched, const MissedSides& sides, const JoinLengths& lengths) {
  for (const PatchSide& side : matched.sides) {
    if (side.is_degenerate && (sides.a.contains(side.name) || sides.b.contains(side.name))) {
      return false;
    }
  }
  const std::vector<NearMiss> misses = find_near_misses(matched, lengths);
  if (std::any_of(misses.begin(), misses.end(),
                  [&](const NearMiss& miss) { return sides.meet(sides_of(matched, miss)); })) {
    return false;
  }
  if (!sides.is_pair) return true;
  return std::any_of(matched.curves.begin(), matched.curves.end(),
                     [&](const MatchedCurve& curve) { return is_shared(matched, curve, sides); });
}

/// The least length of one digit that is no less than another one.
double rounded_up(double length) {
  const double digit = std::pow(10, std::floor(std::log10(length)));
  return std::ceil(length / digit) * digit;
}

/// The joining that joins the sides of a near miss, found by trial, or nothing.
std::optional<double> joining_for(const MatchedSides& matched, const NearMiss& miss,
                                  const JoinLengths& lengths) {
  const MissedSides sides = sides_of(matched, miss);
  const std::vector<PatchSide> around = sides_around(matched, miss);
  double joining = rounded_up(kFirstTrial * std::max(miss.gap, lengths.join));
  for (int i = 0; i < kTrials && joining <= kMostJoining * lengths.diagonal; ++i) {
    const JoinLengths tried = join_lengths(joining, lengths.diagonal);
    if (are_joined(match_sides(around, tried), sides, tried)) return joining;
    joining = rounded_up(kTrialGrowth * joining);
  }
  return std::nullopt;
}

std::string text_of(const MatchedSides& matched, const NearMiss& miss, double join) {
  const MatchedCurve& a = curve_at(matched, miss.a);
  const std::string name = matched.name_of(a);
  if (miss.b < 0) {
    return fmt::format(
        "sides end {:.3g} from each other on {}, more than {:.3g}: the contour {} is left between "
        "them",
        miss.gap, matched.side_of(a.pieces.front()).name, join, name);
  }
  const std::string start = fmt::format("contours {} and {} are not joined: ", name,
                                        matched.name_of(curve_at(matched, miss.b)));
  if (miss.gap > join) {
    return fmt::format("{}the gap between them is {:.3g}, more than {:.3g}", start, miss.gap, join);
  }
  return fmt::format("{}they are within {:.3g} of each other, but their ends are not", start, join);
}

}  // namespace

Notices near_miss_notices(const MatchedSides& matched, const JoinLengths& lengths) {
  Notices result;
  for (const NearMiss& miss : find_near_misses(matched, lengths)) {
    if (result.size() == kMostNotices) {
      ++result.back().count;
      continue;
    }
    Notice& notice = result.emplace_back(
        shortfall(NoticeKind::UnjoinedSides, text_of(matched, miss, lengths.join)));
    if (const auto joining = joining_for(matched, miss, lengths)) {
      notice.text += fmt::format("; joining = {:.1g} joins them", *joining);
    }
    notice.contour = miss.a;
    if (miss.b < 0) notice.point = curve_at(matched, miss.a).first.points.front();
  }
  return result;
}

}  // namespace surfmesh
