// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/creases.hh"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "surfmesh/cage/cage_sides.hh"
#include "surfmesh/cage/face_angles.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

/// Adds creases, and makes those sharper that are there.
class CreaseList {
 public:
  explicit CreaseList(Cage& cage) : cage_(cage) {
    for (std::size_t i = 0; i < cage.creases.size(); ++i) {
      const auto [a, b] = cage.creases[i].edge;
      number_of_.emplace(std::minmax(a, b), i);
    }
  }

  void add(int a, int b, double sharpness) {
    const auto [entry, is_new] = number_of_.emplace(std::minmax(a, b), cage_.creases.size());
    if (is_new) {
      cage_.creases.push_back({{a, b}, sharpness});
    } else {
      double& old = cage_.creases[entry->second].sharpness;
      old = std::max(old, sharpness);
    }
  }

 private:
  Cage& cage_;
  std::map<std::pair<int, int>, std::size_t> number_of_;
};

}  // namespace

std::vector<EdgeTurn> edge_turns(const Cage& cage) {
  std::vector<Vec3> areas;
  areas.reserve(cage.faces.size());
  for (const std::vector<int>& face : cage.faces) {
    areas.push_back(detail::area_vector(face, cage.points));
  }
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  std::vector<EdgeTurn> turns;
  for_each_edge(sides, [&](std::span<const CageSide> edge) {
    if (edge.size() != 2) return;
    const Vec3& a = areas[static_cast<std::size_t>(edge[0].face)];
    const Vec3& b = areas[static_cast<std::size_t>(edge[1].face)];
    const double sign = edge[0].is_rising == edge[1].is_rising ? -1 : 1;
    turns.push_back({{edge[0].low, edge[0].high},
                     {edge[0].face, edge[1].face},
                     detail::angle_between(a, sign * b)});
  });
  return turns;
}

void add_creases(double degrees, Cage& cage) { add_creases(edges_above(degrees, cage), cage); }

std::vector<std::array<int, 2>> edges_above(double degrees, const Cage& cage) {
  const double least = degrees / detail::kDegrees;
  std::vector<std::array<int, 2>> edges;
  for (const EdgeTurn& edge : edge_turns(cage)) {
    if (edge.angle > least) edges.push_back(edge.ends);
  }
  return edges;
}

std::vector<char> marks_of_holes(const Cage& cage) {
  std::vector<char> is_hole(cage.faces.size(), 0);
  for (const int face : cage.holes) {
    const auto at = static_cast<std::size_t>(face);
    if (face >= 0 && at < is_hole.size()) is_hole[at] = 1;
  }
  return is_hole;
}

std::vector<std::array<int, 2>> border_edges(const Cage& cage) {
  const std::vector<char> is_hole = marks_of_holes(cage);
  std::vector<std::array<int, 2>> edges;
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  for_each_edge(sides, [&](std::span<const CageSide> edge) {
    const auto visible = std::count_if(edge.begin(), edge.end(), [&](const CageSide& side) {
      return is_hole[static_cast<std::size_t>(side.face)] == 0;
    });
    if (visible > 0 && (visible == 1 || edge.size() > 2)) {
      edges.push_back({edge[0].low, edge[0].high});
    }
  });
  return edges;
}

void add_creases(const std::vector<std::array<int, 2>>& edges, Cage& cage) {
  CreaseList creases(cage);
  for (const auto& [low, high] : edges) creases.add(low, high, kSharp);
}

void add_crease(const std::vector<int>& vertices, double sharpness, Cage& cage) {
  add_creases({vertices}, sharpness, cage);
}

void add_creases(const std::vector<std::vector<int>>& chains, double sharpness, Cage& cage) {
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  CreaseList creases(cage);
  for (const std::vector<int>& vertices : chains) {
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const auto [low, high] = std::minmax(vertices[i - 1], vertices[i]);
      const auto at = std::lower_bound(sides.begin(), sides.end(), std::pair(low, high),
                                       [](const CageSide& side, const std::pair<int, int>& wanted) {
                                         return std::pair(side.low, side.high) < wanted;
                                       });
      if (at == sides.end() || at->low != low || at->high != high) {
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("vertices {} and {} are not the ends of an edge", vertices[i - 1],
                                vertices[i]));
      }
      creases.add(low, high, sharpness);
    }
  }
}

void add_crease_around(const std::string& group, double sharpness, Cage& cage) {
  const auto found = std::find_if(cage.groups.begin(), cage.groups.end(),
                                  [&](const Cage::FaceGroup& g) { return g.name == group; });
  if (found == cage.groups.end()) {
    std::vector<std::string_view> names;
    for (const Cage::FaceGroup& g : cage.groups) names.push_back(g.name);
    const auto meant = nearest_word(group, names);
    throw Error(ErrorCode::InvalidInput,
                fmt::format("there is no group {}{}", group,
                            meant ? fmt::format(", did you mean {}?", *meant) : ""));
  }
  std::vector<char> is_inside(cage.faces.size(), 0);
  for (const int face : found->faces) {
    const auto at = static_cast<std::size_t>(face);
    if (face >= 0 && at < is_inside.size()) is_inside[at] = 1;
  }
  CreaseList creases(cage);
  bool has_border = false;
  const std::vector<CageSide> sides = sorted_sides(cage.faces);
  for_each_edge(sides, [&](std::span<const CageSide> edge) {
    const auto is_in = [&](const CageSide& side) {
      return is_inside[static_cast<std::size_t>(side.face)] != 0;
    };
    const auto count = std::count_if(edge.begin(), edge.end(), is_in);
    if (count == 0 || count == static_cast<std::ptrdiff_t>(edge.size())) return;
    creases.add(edge[0].low, edge[0].high, sharpness);
    has_border = true;
  });
  if (has_border) return;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("no edge lies between a face of group {} and one of the others; vertices "
                          "that are not welded make none",
                          group));
}

}  // namespace surfmesh
