// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model/match_pieces.hh"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace surfmesh {
namespace {

bool are_near(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const Vec3& p, const Vec3& q) { return (p - q).norm() <= tolerance; });
}

/// Parameters on `on` of the samples of a line, or nothing if one of them is not on it.
std::optional<std::vector<double>> feet(const SampledLine& of, const SampledLine& on,
                                        double tolerance) {
  const std::vector<double> parameters = sample_parameters(kLineSamples);
  std::vector<double> result;
  for (const Vec3& point : of.points) {
    const double t = on.line.project(point, parameters[on.nearest(point)]);
    if (!((on.line.at(t) - point).norm() <= tolerance)) return std::nullopt;
    result.push_back(t);
  }
  return result;
}

/// True if more parameters fall than rise: on a closed curve, which has no ends to compare.
bool is_falling(const std::vector<double>& parameters) {
  int balance = 0;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    balance += parameters[i] < parameters[i - 1] ? 1 : -1;
  }
  return balance > 0;
}

/// How one curve runs along another.
struct Comparison {
  bool is_reversed = false;
  bool is_same_speed = true;
};

/// Tells how `b` runs along `a`, or nothing if they do not coincide. Between different end vertices
/// the direction is known; of closed curves it is found.
class Comparer {
 public:
  explicit Comparer(double tolerance) : tolerance_(tolerance) {}

  std::optional<Comparison> closed(const SampledLine& a, const SampledLine& b) const {
    if (is_apart(a, b)) return std::nullopt;
    for (const bool is_reversed : {false, true}) {
      if (is_same_speed(a, b, is_reversed)) return Comparison{is_reversed, true};
    }
    const auto parameters = feet(b, a, tolerance_);
    if (!parameters || !feet(a, b, tolerance_)) return std::nullopt;
    return Comparison{is_falling(*parameters), false};
  }

  std::optional<Comparison> open(const SampledLine& a, const SampledLine& b,
                                 bool is_reversed) const {
    if (is_apart(a, b)) return std::nullopt;
    if (is_same_speed(a, b, is_reversed)) return Comparison{is_reversed, true};
    if (!feet(b, a, tolerance_) || !feet(a, b, tolerance_)) return std::nullopt;
    return Comparison{is_reversed, false};
  }

 private:
  /// Cheap, and enough for most pairs that differ.
  bool is_apart(const SampledLine& a, const SampledLine& b) const {
    const Vec3& middle = b.points[b.points.size() / 2];
    return !a.box().contains(middle);
  }

  bool is_same_speed(const SampledLine& a, const SampledLine& b, bool is_reversed) const {
    if (!is_reversed) return are_near(a.points, b.points, tolerance_);
    return are_near(a.points, sample(b.line.reversed()).points, tolerance_);
  }

  double tolerance_;
};

class Matcher {
 public:
  Matcher(const std::vector<SidePiece>& pieces, const JoinLengths& lengths)
      : pieces_(&pieces), near_(lengths.near), comparer_(lengths.join) {}

  void add(int piece) {
    SampledLine line = sample(at(piece).line);
    std::vector<std::size_t>& rivals = by_ends_[std::minmax(at(piece).start, at(piece).end)];
    for (const std::size_t i : rivals) {
      if (meets_own_corner(curves_[i], piece, line)) continue;
      if (const auto comparison = compare(curves_[i], piece, line)) {
        curves_[i].pieces.push_back({piece, comparison->is_reversed, comparison->is_same_speed});
        return;
      }
    }
    rivals.push_back(curves_.size());
    curves_.push_back({{{piece, false, true}}, std::move(line)});
  }

  void add_alone(int piece) { curves_.push_back({{{piece, false, true}}, sample(at(piece).line)}); }

  std::vector<MatchedCurve> take() { return std::move(curves_); }

 private:
  const SidePiece& at(int piece) const { return (*pieces_)[static_cast<std::size_t>(piece)]; }

  /// True if a piece is so short that it may be near to one of its own patch in a corner of that.
  bool meets_own_corner(const MatchedCurve& curve, int piece, const SampledLine& line) const {
    return std::any_of(curve.pieces.begin(), curve.pieces.end(), [&](const MatchedPiece& other) {
      const bool are_whole = at(piece).is_whole && at(other.piece).is_whole;
      return at(other.piece).line.patch == line.line.patch && !are_whole && line.length() <= near_;
    });
  }

  std::optional<Comparison> compare(const MatchedCurve& curve, int piece,
                                    const SampledLine& line) const {
    const SidePiece& first = at(curve.pieces.front().piece);
    if (first.start == first.end) return comparer_.closed(curve.first, line);
    return comparer_.open(curve.first, line, first.start != at(piece).start);
  }

  const std::vector<SidePiece>* pieces_;
  double near_;
  Comparer comparer_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> by_ends_;
  std::vector<MatchedCurve> curves_;
};

}  // namespace

std::vector<MatchedCurve> match_pieces(const std::vector<PatchSide>& sides,
                                       const std::vector<SidePiece>& pieces,
                                       const JoinLengths& lengths) {
  Matcher matcher(pieces, lengths);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool is_degenerate = sides[static_cast<std::size_t>(pieces[i].side)].is_degenerate;
    is_degenerate ? matcher.add_alone(static_cast<int>(i)) : matcher.add(static_cast<int>(i));
  }
  return matcher.take();
}

}  // namespace surfmesh
