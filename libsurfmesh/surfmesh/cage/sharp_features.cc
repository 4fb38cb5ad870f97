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
  return std::atan2(before.cross(after).norm(), before.dot(after)) >
         kCornerAngle * std::numbers::pi / 180;
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

std::size_t add_lines(double degrees, Cage& cage) {
  std::vector<Edge> found = edges_above(degrees, cage);
  std::vector<Edge> all = sharp_edges(cage);
  all.insert(all.end(), found.begin(), found.end());
  const Lines lines(std::move(all), cage.points.size());
  std::erase_if(found, [&](const Edge& edge) { return lines.is_alone(edge); });
  const std::size_t before = cage.creases.size();
  add_creases(found, cage);
  return cage.creases.size() - before;
}

}  // namespace

SharpFeatures tag_features(double degrees, Cage& cage) {
  SharpFeatures features;
  if (degrees > 0) features.creases = add_lines(degrees, cage);
  features.corners = add_corners(cage);
  return features;
}

}  // namespace surfmesh
