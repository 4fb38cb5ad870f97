// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/sharp_features.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/creases.hh"

namespace surfmesh {
namespace {

using Edge = std::array<int, 2>;

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// A feature turns by so many times the angle of the other edges of its faces. Without it creases
/// run over coarse meshes of narrow round parts. Where two creases meet in a triangle of a box, the
/// angle is twice that of the others.
constexpr double kFeatureRatio = 1.5;

/// Edges of more than this are features whatever is around: those of a cube, not of an octahedron.
constexpr double kSurelySharp = 75;

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

  /// True for a line that no other one goes on from.
  bool is_alone(const Edge& edge) const { return at(edge[0]).size() + at(edge[1]).size() == 2; }

 private:
  std::vector<std::vector<int>> neighbours_;
};

/// True if the line through a vertex turns there.
bool has_corner(const Lines& lines, int vertex, const Cage& cage) {
  if (lines.at(vertex).size() != 2) return false;
  const auto point = [&](int v) -> const Vec3& { return cage.points[static_cast<std::size_t>(v)]; };
  const Vec3 before = point(vertex) - point(lines.at(vertex)[0]);
  const Vec3 after = point(lines.at(vertex)[1]) - point(vertex);
  return std::atan2(before.cross(after).norm(), before.dot(after)) > radians(kCornerAngle);
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

/// The edges of a mesh that are features by themselves; see tag_features.
std::vector<Edge> features_of(const Cage& cage) {
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
  std::vector<Edge> edges;
  for (const EdgeTurn& turn : turns) {
    if (turn.angle <= radians(kFeatureAngle)) continue;
    const Sum& a = of_face[static_cast<std::size_t>(turn.faces[0])];
    const Sum& b = of_face[static_cast<std::size_t>(turn.faces[1])];
    const int others = a.count + b.count - 2;
    const double angles = a.angle + b.angle - 2 * turn.angle;
    const bool stands_out = turn.angle * others >= kFeatureRatio * angles;
    if (stands_out || turn.angle > radians(kSurelySharp)) edges.push_back(turn.ends);
  }
  return edges;
}

/// Make creases of edges, but of none that is alone.
void add_lines(std::vector<Edge> found, Cage& cage) {
  std::vector<Edge> all = sharp_edges(cage);
  all.insert(all.end(), found.begin(), found.end());
  const Lines lines(std::move(all), cage.points.size());
  std::erase_if(found, [&](const Edge& edge) { return lines.is_alone(edge); });
  add_creases(found, cage);
}

}  // namespace

SharpFeatures tag_features(const std::optional<double>& crease_angle, Cage& cage) {
  SharpFeatures features;
  const std::size_t before = cage.creases.size();
  if (!crease_angle) add_lines(features_of(cage), cage);
  if (crease_angle.value_or(0) > 0) add_creases(*crease_angle, cage);
  features.creases = cage.creases.size() - before;
  features.corners = add_corners(cage);
  return features;
}

}  // namespace surfmesh
