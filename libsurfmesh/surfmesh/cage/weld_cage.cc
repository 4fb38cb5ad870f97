// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/cage/weld_cage.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "surfmesh/cage/coincident_points.hh"

namespace surfmesh {
namespace {

/// Leaves vertices that do not exist as they are, for others to warn of.
int stand_in(int vertex, const std::vector<int>& stand_ins) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= stand_ins.size()) return vertex;
  return stand_ins[static_cast<std::size_t>(vertex)];
}

void weld_tags(Cage& cage, const std::vector<int>& stand_ins) {
  for (Cage::Crease& crease : cage.creases) {
    for (int& vertex : crease.edge) vertex = stand_in(vertex, stand_ins);
  }
  std::erase_if(cage.creases, [](const Cage::Crease& c) { return c.edge[0] == c.edge[1]; });
  for (Cage::Corner& corner : cage.corners) corner.vertex = stand_in(corner.vertex, stand_ins);
}

}  // namespace

std::vector<int> coincident_vertices(const Cage& cage, double tolerance) {
  const std::vector<int> used = used_vertices(cage);
  std::vector<Vec3> points;
  points.reserve(used.size());
  for (const int v : used) points.push_back(cage.points[static_cast<std::size_t>(v)]);
  const std::vector<int> found = coincident_points(points, tolerance);
  std::vector<int> stand_ins(cage.points.size());
  std::iota(stand_ins.begin(), stand_ins.end(), 0);
  for (std::size_t i = 0; i < used.size(); ++i) {
    stand_ins[static_cast<std::size_t>(used[i])] = used[static_cast<std::size_t>(found[i])];
  }
  return stand_ins;
}

WeldReport weld(Cage& cage, const std::vector<int>& stand_ins) {
  WeldReport report;
  std::vector<char> is_told(stand_ins.size(), 0);
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    std::vector<int> face = cage.faces[f];
    for (int& vertex : face) {
      const int other = stand_in(vertex, stand_ins);
      if (other == vertex) continue;
      if (!std::exchange(is_told[static_cast<std::size_t>(vertex)], char{1})) {
        report.vertices.push_back(vertex);
        report.onto.push_back(other);
      }
      vertex = other;
    }
    if (face == cage.faces[f]) continue;
    face = without_repeats(face);
    if (face.size() < 3) {
      report.collapsed.push_back(static_cast<int>(f));
      face.clear();
    }
    cage.faces[f] = std::move(face);
  }
  if (!report.vertices.empty()) weld_tags(cage, stand_ins);
  return report;
}

}  // namespace surfmesh
