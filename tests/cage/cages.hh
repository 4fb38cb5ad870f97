// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/cage/refine_cage.hh"

namespace surfmesh::testing {

/// The cube [-1,1]³ of six quads.
inline Cage cube() {
  Cage cage;
  for (int i = 0; i < 8; ++i) {
    cage.points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  cage.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cage;
}

/// A torus of m × n quads, all vertices regular.
inline Cage torus(int m = 6, int n = 4) {
  Cage cage;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      const double a = 2 * M_PI * i / m, b = 2 * M_PI * j / n, r = 3 + std::cos(b);
      cage.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
    }
  }
  const auto at = [=](int i, int j) { return j % n * m + i % m; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return cage;
}

/// The triangles of a cage of quads, all diagonals from the first corner.
inline Cage halved_quads(Cage cage) {
  std::vector<std::vector<int>> triangles;
  for (const std::vector<int>& q : cage.faces) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  cage.faces = triangles;
  return cage;
}

/// The triangles of a cage of quads. Their diagonals run this way and that, so that half of the
/// vertices are irregular.
inline Cage triangulated(Cage cage) {
  std::vector<std::vector<int>> triangles;
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<int> q = cage.faces[f];
    const std::size_t first = f * f % 7 < 2 ? 1 : 0;
    triangles.push_back({q[first], q[first + 1], q[first + 2]});
    triangles.push_back({q[first], q[first + 2], q[(first + 3) % 4]});
  }
  cage.faces = triangles;
  return cage;
}

/// An open tube about the z axis of m × n quads, all vertices regular.
inline Cage tube(int m, int n, double radius = 1) {
  Cage cage;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i < m; ++i) {
      const double a = 2 * M_PI * i / m;
      cage.points.emplace_back(radius * std::cos(a), radius * std::sin(a), j);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      const int next = (i + 1) % m;
      cage.faces.push_back({j * m + i, j * m + next, (j + 1) * m + next, (j + 1) * m + i});
    }
  }
  return cage;
}

/// A Möbius band of m × n quads, n across.
inline Cage mobius_strip(int m, int n) {
  Cage cage;
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double a = 2 * M_PI * i / m, s = static_cast<double>(j) / n - 0.5;
      const double r = 2 + s * std::cos(a / 2);
      cage.points.emplace_back(r * std::cos(a), r * std::sin(a), s * std::sin(a / 2));
    }
  }
  const auto at = [=](int i, int j) { return i < m ? i * (n + 1) + j : n - j; };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return cage;
}

/// A bent sheet of m × n quads with a boundary.
inline Cage sheet(int m = 3, int n = 3) {
  Cage cage;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= m; ++i) cage.points.emplace_back(i, j, 0.3 * i * i - 0.2 * i * j);
  }
  const auto at = [=](int i, int j) { return j * (m + 1) + i; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      cage.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return cage;
}

/// The same, but nearly flat.
inline Cage flat_sheet(int m, int n) {
  Cage cage = sheet(m, n);
  for (Vec3& point : cage.points) point.z() *= 0.3 / (m + n);
  return cage;
}

/// A bent sheet with every quad cut into two triangles: interior vertices have valence 6.
inline Cage triangle_sheet(int m = 3, int n = 3) { return halved_quads(sheet(m, n)); }

/// A hump of quads around vertex 0, which has the valence given.
inline Cage quad_fan(int valence) {
  Cage cage;
  cage.points = {{0, 0, 1}};
  for (int i = 0; i < 2 * valence; ++i) {
    const double angle = M_PI * i / valence, r = i % 2 == 0 ? 1 : 1.4;
    cage.points.emplace_back(r * std::cos(angle), r * std::sin(angle), i % 2 == 0 ? 0.5 : 0);
  }
  for (int i = 0; i < valence; ++i) {
    cage.faces.push_back({0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % (2 * valence)});
  }
  return cage;
}

inline Cage tetrahedron() {
  Cage cage;
  cage.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  cage.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return cage;
}

inline Cage octahedron() {
  Cage cage;
  cage.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  cage.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return cage;
}

inline Cage icosahedron() {
  const double t = (1 + std::sqrt(5.0)) / 2;
  Cage cage;
  cage.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  cage.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return cage;
}

/// Two quads with the same four vertices, facing away from each other: interior valence 2.
inline Cage pillow() {
  Cage cage;
  cage.points = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0}, {0, 1, 0.2}};
  cage.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  return cage;
}

/// A prism over a polygon of n sides: two polygons and n quads.
inline Cage prism(int n) {
  Cage cage;
  cage.faces.resize(2);
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < n; ++i) {
      cage.points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 2 * k);
      cage.faces[static_cast<std::size_t>(k)].push_back(k == 0 ? n - 1 - i : n + i);
    }
  }
  for (int i = 0; i < n; ++i) cage.faces.push_back({i, (i + 1) % n, (i + 1) % n + n, i + n});
  return cage;
}

/// Two pentagons and five quads.
inline Cage pentagon_prism() { return prism(5); }

/// Three quads that share the edge 0-1.
inline Cage fan() {
  Cage cage;
  cage.points = {{0, 0, 0},  {0, 0, 1},  {1, 0, 0},   {1, 0, 1},
                 {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
  cage.faces = {{0, 2, 3, 1}, {0, 4, 5, 1}, {1, 7, 6, 0}};
  return cage;
}

/// The cage with these faces in the other direction.
inline Cage turned(Cage cage, const std::vector<std::size_t>& faces) {
  for (const std::size_t f : faces) std::reverse(cage.faces[f].begin() + 1, cage.faces[f].end());
  return cage;
}

/// The same faces with vertices of their own.
inline Cage split(const Cage& cage) {
  Cage result;
  for (const std::vector<int>& face : cage.faces) {
    std::vector<int>& own = result.faces.emplace_back();
    for (const int vertex : face) {
      own.push_back(static_cast<int>(result.points.size()));
      result.points.push_back(cage.points[static_cast<std::size_t>(vertex)]);
    }
  }
  return result;
}

/// The cage refined so many times by Catmull and Clark.
inline Cage refined(Cage cage, int times) {
  for (int i = 0; i < times; ++i) cage = refine_once(cage, Scheme::CatmullClark).cage;
  return cage;
}

}  // namespace surfmesh::testing
