// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/sharp_features.hh"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/cage/median.hh"
#include "surfmesh/core/disjoint_sets.hh"

namespace surfmesh {
namespace {

using Edge = std::array<int, 2>;

constexpr double radians(double degrees) { return degrees / detail::kDegrees; }

/// A feature turns by so many times the mean angle of the other edges of its faces. Without it
/// creases run over coarse meshes of narrow round parts. Where two creases meet in a triangle of a
/// box, the angle is twice that of the others.
constexpr double kFeatureRatio = 1.5;

/// Edges of more than this start features whatever is around: those of a cube, not of an
/// octahedron, degrees.
constexpr double kSurelySharp = 75;

/// Edges that stand out so clearly go on from features even if they turn by less than
/// kFeatureAngle, down to kWeakAngle, degrees: a crease that fades and comes back is one line.
constexpr double kWeakAngle = 30;
constexpr double kClearRatio = 5;

/// The lines of a feature stand out clearly, or are sharp: half of their edges turn by more than
/// this, degrees. Edges of coarse horns and ears stand out by a ratio of 2 to 4, at 40 to 70.
constexpr double kSharpLine = 70;

/// Edges that a feature has for each of its ends. Of coarse round parts chains of 2 to 11 edges
/// would become creases, with 2 to 4 ends, and rings around a triangle at the tip.
constexpr std::size_t kEdgesPerEnd = 4;
constexpr std::size_t kLeastRing = 4;

/// The edges along which a surface is sharp: borders, cuts, and creases with a tag.
std::vector<Edge> sharp_edges(const Cage& cage) {
  std::vector<Edge> edges;
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  for_each_edge(sides, [&](std::span<const CageSide> edge) {
    if (edge.size() != 2) edges.push_back({edge[0].low, edge[0].high});
  });
  const auto exists = [&](int v) {
    return v >= 0 && static_cast<std::size_t>(v) < cage.points.size();
  };
  for (const Cage::Crease& crease : cage.creases) {
    const auto [low, high] = std::minmax(crease.edge[0], crease.edge[1]);
    if (crease.sharpness >= kSharp && exists(low) && exists(high)) edges.push_back({low, high});
  }
  return edges;
}

/// The vertices to which lines lead from each vertex.
class Lines {
 public:
  Lines(std::vector<Edge> edges, std::size_t vertex_count) : neighbours_(vertex_count) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
      neighbours_[static_cast<std::size_t>(a)].push_back(b);
      neighbours_[static_cast<std::size_t>(b)].push_back(a);
    }
  }

  const std::vector<int>& at(int vertex) const {
    return neighbours_[static_cast<std::size_t>(vertex)];
  }

 private:
  std::vector<std::vector<int>> neighbours_;
};

/// True if the line through a vertex turns there.
bool has_corner(const Lines& lines, int vertex, const Cage& cage) {
  if (lines.at(vertex).size() != 2) return false;
  const auto point = [&](int v) -> const Vec3& { return cage.points[static_cast<std::size_t>(v)]; };
  const Vec3 before = point(vertex) - point(lines.at(vertex)[0]);
  const Vec3 after = point(lines.at(vertex)[1]) - point(vertex);
  return detail::angle_between(before, after) > radians(kCornerAngle);
}

std::size_t add_corners(Cage& cage) {
  const Lines lines(sharp_edges(cage), cage.points.size());
  std::vector<char> has_tag(cage.points.size(), 0);
  for (const Cage::Corner& corner : cage.corners) {
    const auto at = static_cast<std::size_t>(corner.vertex);
    if (corner.vertex >= 0 && at < has_tag.size()) has_tag[at] = 1;
  }
  std::size_t count = 0;
  for (int v = 0; static_cast<std::size_t>(v) < cage.points.size(); ++v) {
    if (has_tag[static_cast<std::size_t>(v)] || !has_corner(lines, v, cage)) continue;
    cage.corners.push_back({v, kSharp});
    ++count;
  }
  return count;
}

/// An edge that may be a feature.
struct Candidate {
  Edge ends = {-1, -1};
  double angle = 0;  ///< at which its faces meet, radians
  double ratio = 0;  ///< of this to the mean angle of the other edges of its faces

  bool is_strong() const {
    return angle > radians(kFeatureAngle) &&
           (ratio >= kFeatureRatio || angle > radians(kSurelySharp));
  }
};

/// The edges that start features, and those that can go on from them; none between holes.
std::vector<Candidate> candidates_of(const Cage& cage) {
  struct Sum {
    double angle = 0;
    int count = 0;
  };
  const std::vector<EdgeTurn> turns = edge_turns(cage);
  std::vector<Sum> of_face(cage.faces.size());
  for (const EdgeTurn& turn : turns) {
    for (const int face : turn.faces) {
      of_face[static_cast<std::size_t>(face)].angle += turn.angle;
      ++of_face[static_cast<std::size_t>(face)].count;
    }
  }
  const std::vector<char> is_hole = marks_of_holes(cage);
  const auto is_shown = [&](int face) { return is_hole[static_cast<std::size_t>(face)] == 0; };
  std::vector<Candidate> candidates;
  for (const EdgeTurn& turn : turns) {
    if (turn.angle <= radians(kWeakAngle)) continue;
    if (std::none_of(turn.faces.begin(), turn.faces.end(), is_shown)) continue;
    const Sum& a = of_face[static_cast<std::size_t>(turn.faces[0])];
    const Sum& b = of_face[static_cast<std::size_t>(turn.faces[1])];
    const int others = a.count + b.count - 2;
    const double angles = a.angle + b.angle - 2 * turn.angle;
    const double ratio =
        angles > 0 ? turn.angle * others / angles : std::numeric_limits<double>::infinity();
    const Candidate candidate{turn.ends, turn.angle, ratio};
    if (candidate.is_strong() || ratio >= kClearRatio) candidates.push_back(candidate);
  }
  return candidates;
}

/// Finds the lines of edges that are features.
class FeatureLines {
 public:
  /// `others` are lines that are there already, at which a feature may end.
  FeatureLines(std::vector<Candidate> candidates, const std::vector<Edge>& others,
               std::size_t vertex_count)
      : edges_(std::move(candidates)), at_(vertex_count), is_on_other_(vertex_count, 0) {
    for (const Edge& edge : others) {
      for (const int v : edge) is_on_other_[static_cast<std::size_t>(v)] = 1;
    }
    connect();
  }

  std::vector<Edge> find() {
    drop_weak_majorities();
    while (drop_twigs()) {
    }
    std::vector<Edge> features;
    for (const std::vector<int>& group : groups()) {
      if (!is_feature(group)) continue;
      for (const int e : group) features.push_back(edge(e).ends);
    }
    return features;
  }

 private:
  const Candidate& edge(int e) const { return edges_[static_cast<std::size_t>(e)]; }
  const std::vector<int>& at(int vertex) const { return at_[static_cast<std::size_t>(vertex)]; }

  /// True if nothing goes on from a vertex of an edge.
  bool is_end(int vertex) const {
    return at(vertex).size() == 1 && is_on_other_[static_cast<std::size_t>(vertex)] == 0;
  }

  void connect() {
    for (std::vector<int>& edges : at_) edges.clear();
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (const int v : edges_[e].ends) {
        at_[static_cast<std::size_t>(v)].push_back(static_cast<int>(e));
      }
    }
  }

  /// The edges from an end to a fork; none if there is no fork before the line would be long.
  std::vector<int> twig_from(int vertex) const {
    std::vector<int> twig;
    int e = at(vertex).front();
    while (twig.size() + 1 < kEdgesPerEnd) {
      twig.push_back(e);
      const Edge& ends = edge(e).ends;
      vertex = ends[0] == vertex ? ends[1] : ends[0];
      const std::vector<int>& around = at(vertex);
      if (around.size() > 2) return twig;
      if (around.size() < 2) break;
      e = around[0] == e ? around[1] : around[0];
    }
    return {};
  }

  /// Leave out some edges; false if there are none.
  bool drop(const std::vector<char>& is_dropped) {
    std::vector<Candidate> kept;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (is_dropped[e] == 0) kept.push_back(edges_[e]);
    }
    const bool has_dropped = kept.size() < edges_.size();
    edges_ = std::move(kept);
    connect();
    return has_dropped;
  }

  /// Leave out weak edges that are more than the strong ones they are connected with: roundings
  /// that the mesh resolves.
  void drop_weak_majorities() {
    std::vector<char> is_dropped(edges_.size(), 0);
    for (const std::vector<int>& group : groups()) {
      const auto strong =
          std::count_if(group.begin(), group.end(), [&](int e) { return edge(e).is_strong(); });
      if (2 * static_cast<std::size_t>(strong) >= group.size()) continue;
      for (const int e : group) is_dropped[static_cast<std::size_t>(e)] = !edge(e).is_strong();
    }
    drop(is_dropped);
  }

  /// Leave out short lines that branch off a feature and do not stand out.
  bool drop_twigs() {
    std::vector<char> is_dropped(edges_.size(), 0);
    for (const Candidate& candidate : edges_) {
      for (const int v : candidate.ends) {
        if (!is_end(v)) continue;
        const std::vector<int> twig = twig_from(v);
        if (twig.empty() || median_ratio(twig) >= kClearRatio) continue;
        for (const int e : twig) is_dropped[static_cast<std::size_t>(e)] = 1;
      }
    }
    return drop(is_dropped);
  }

  /// The edges that are connected with each other.
  std::vector<std::vector<int>> groups() const {
    DisjointSets sets(at_.size());
    for (const Candidate& candidate : edges_) {
      sets.unite(static_cast<std::size_t>(candidate.ends[0]),
                 static_cast<std::size_t>(candidate.ends[1]));
    }
    std::map<std::size_t, std::vector<int>> by_set;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      by_set[sets.find(static_cast<std::size_t>(edges_[e].ends[0]))].push_back(static_cast<int>(e));
    }
    std::vector<std::vector<int>> groups;
    for (auto& [set, edges] : by_set) groups.push_back(std::move(edges));
    return groups;
  }

  double median_ratio(const std::vector<int>& edges) const {
    std::vector<double> ratios;
    for (const int e : edges) ratios.push_back(edge(e).ratio);
    return detail::median_of(std::move(ratios));
  }

  double median_angle(const std::vector<int>& edges) const {
    std::vector<double> angles;
    for (const int e : edges) angles.push_back(edge(e).angle);
    return detail::median_of(std::move(angles));
  }

  /// True for connected edges with few ends that stand out or are sharp.
  bool is_feature(const std::vector<int>& group) const {
    std::size_t ends = 0;
    bool is_apart = true;
    for (const int e : group) {
      for (const int v : edge(e).ends) {
        if (is_end(v)) ++ends;
        if (is_on_other_[static_cast<std::size_t>(v)] != 0) is_apart = false;
      }
    }
    const bool is_tip = is_apart && group.size() < kLeastRing;
    if (is_tip || group.size() < kEdgesPerEnd * ends) return false;
    return median_ratio(group) >= kClearRatio || median_angle(group) > radians(kSharpLine);
  }

  std::vector<Candidate> edges_;
  std::vector<std::vector<int>> at_;  ///< edges, by vertex
  std::vector<char> is_on_other_;     ///< by vertex
};

/// The edges of a mesh that are features by themselves; see tag_features.
std::vector<Edge> features_of(const Cage& cage) {
  std::vector<Edge> others = sharp_edges(cage);
  const std::vector<Edge> borders = border_edges(cage);
  others.insert(others.end(), borders.begin(), borders.end());
  return FeatureLines(candidates_of(cage), others, cage.points.size()).find();
}

}  // namespace

SharpFeatures tag_features(const std::optional<double>& crease_angle, Cage& cage) {
  SharpFeatures features;
  const std::size_t before = cage.creases.size();
  if (!crease_angle) add_creases(features_of(cage), cage);
  if (crease_angle.value_or(0) > 0) add_creases(*crease_angle, cage);
  features.creases = cage.creases.size() - before;
  features.corners = add_corners(cage);
  return features;
}

}  // namespace surfmesh
