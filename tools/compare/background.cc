// SPDX-License-Identifier: BSD-3-Clause
#include "compare/background.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "compare/triangle_file.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh::compare {
namespace {

Uv node_at(const Background& grid, int i, int j) {
  return grid.domain.at(double(i) / grid.cells, double(j) / grid.cells);
}

/// The number of a node in files, which count from 1.
int number(const Background& grid, int i, int j) { return j * (grid.cells + 1) + i + 1; }

using Text = fmt::memory_buffer;

void write(const std::filesystem::path& stem, const char* ending, const Text& text) {
  std::filesystem::path path = stem;
  path += ending;
  write_file(path, {text.data(), text.size()});
}

/// Call `visit` with the node numbers of each triangle, two to a cell.
template <class Visitor>
void for_each_triangle(const Background& grid, Visitor visit) {
  for (int j = 0; j < grid.cells; ++j) {
    for (int i = 0; i < grid.cells; ++i) {
      const int a = number(grid, i, j), b = number(grid, i + 1, j), c = number(grid, i + 1, j + 1),
                d = number(grid, i, j + 1);
      visit(a, b, c);
      visit(a, c, d);
    }
  }
}

/// Call `visit` with the coordinates of each node, in the order of their numbers.
template <class Visitor>
void for_each_node(const Background& grid, Visitor visit) {
  for (int j = 0; j <= grid.cells; ++j) {
    for (int i = 0; i <= grid.cells; ++i) visit(node_at(grid, i, j));
  }
}

int triangle_count(const Background& grid) { return 2 * grid.cells * grid.cells; }

double size_of(const Metric& metric) { return 1 / std::sqrt(metric.m11); }

void add_border(const Background& grid, Text& text) {
  const auto out = fmt::appender(text);
  const int n = grid.cells;
  fmt::format_to(out, "Edges\n{}\n", 4 * n);
  for (int i = 0; i < n; ++i) {
    fmt::format_to(out, "{} {} 1\n", number(grid, i, 0), number(grid, i + 1, 0));
    fmt::format_to(out, "{} {} 2\n", number(grid, n, i), number(grid, n, i + 1));
    fmt::format_to(out, "{} {} 3\n", number(grid, n - i, n), number(grid, n - i - 1, n));
    fmt::format_to(out, "{} {} 4\n", number(grid, 0, n - i), number(grid, 0, n - i - 1));
  }
  fmt::format_to(out, "Corners\n4\n{}\n{}\n{}\n{}\n", number(grid, 0, 0), number(grid, n, 0),
                 number(grid, n, n), number(grid, 0, n));
}

Text plane_mesh(const Background& grid) {
  Text text;
  const auto out = fmt::appender(text);
  fmt::format_to(out, "MeshVersionFormatted 2\nDimension\n2\nVertices\n{}\n", grid.metrics.size());
  for_each_node(grid, [&](Uv uv) { fmt::format_to(out, "{} {} 0\n", uv.u, uv.v); });
  add_border(grid, text);
  fmt::format_to(out, "Triangles\n{}\n", triangle_count(grid));
  for_each_triangle(grid,
                    [&](int a, int b, int c) { fmt::format_to(out, "{} {} {} 1\n", a, b, c); });
  fmt::format_to(out, "End\n");
  return text;
}

/// The metrics, or sizes if they are isotropic, a line each.
void add_values(const Background& grid, Text& text) {
  const auto out = fmt::appender(text);
  for (const Metric& m : grid.metrics) {
    if (grid.is_isotropic) {
      fmt::format_to(out, "{}\n", size_of(m));
    } else {
      fmt::format_to(out, "{} {} {}\n", m.m11, m.m12, m.m22);
    }
  }
}

}  // namespace

Background sample_background(const ExactMetric& metric, int cells, bool is_isotropic) {
  Background grid{metric.domain(), cells, is_isotropic, {}};
  for_each_node(grid, [&](Uv uv) { grid.metrics.push_back(metric.at(uv)); });
  return grid;
}

void write_background(const Background& background, const std::filesystem::path& stem) {
  write(stem, ".mesh", plane_mesh(background));
  Text bamg;
  fmt::format_to(fmt::appender(bamg), "{} {}\n", background.metrics.size(),
                 background.is_isotropic ? 1 : 3);
  add_values(background, bamg);
  write(stem, ".mtr", bamg);
  Text mmg;
  fmt::format_to(fmt::appender(mmg),
                 "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{}\n1 {}\n",
                 background.metrics.size(), background.is_isotropic ? 1 : 3);
  add_values(background, mmg);
  fmt::format_to(fmt::appender(mmg), "End\n");
  write(stem, ".sol", mmg);
}

void write_gmsh_view(const Background& background, const std::filesystem::path& stem) {
  Text text;
  const auto out = fmt::appender(text);
  fmt::format_to(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
                 background.metrics.size());
  int node = 0;
  for_each_node(background,
                [&](Uv uv) { fmt::format_to(out, "{} {} {} 0\n", ++node, uv.u, uv.v); });
  fmt::format_to(out, "$EndNodes\n$Elements\n{}\n", triangle_count(background));
  int triangle = 0;
  for_each_triangle(background, [&](int a, int b, int c) {
    fmt::format_to(out, "{} 2 2 1 1 {} {} {}\n", ++triangle, a, b, c);
  });
  // Of a tensor in space, the third direction is not used.
  fmt::format_to(out, "$EndElements\n$NodeData\n1\n\"sizes\"\n1\n0\n3\n0\n{}\n{}\n",
                 background.is_isotropic ? 1 : 9, background.metrics.size());
  node = 0;
  for (const Metric& m : background.metrics) {
    if (background.is_isotropic) {
      fmt::format_to(out, "{} {}\n", ++node, size_of(m));
    } else {
      fmt::format_to(out, "{} {} {} 0 {} {} 0 0 0 1\n", ++node, m.m11, m.m12, m.m12, m.m22);
    }
  }
  fmt::format_to(out, "$EndNodeData\n");
  write(stem, ".msh", text);
}

void write_gmsh_square(const Background& background, const std::filesystem::path& path) {
  const Domain& d = background.domain;
  write_file(path, fmt::format("Point(1) = {{{0}, {1}, 0}};\nPoint(2) = {{{2}, {1}, 0}};\n"
                               "Point(3) = {{{2}, {3}, 0}};\nPoint(4) = {{{0}, {3}, 0}};\n"
                               "Line(1) = {{1, 2}};\nLine(2) = {{2, 3}};\nLine(3) = {{3, 4}};\n"
                               "Line(4) = {{4, 1}};\nCurve Loop(1) = {{1, 2, 3, 4}};\n"
                               "Plane Surface(1) = {{1}};\n"
                               "Mesh.MeshSizeExtendFromBoundary = 0;\n"
                               "Mesh.MeshSizeFromPoints = 0;\n",
                               d.u0, d.v0, d.u1, d.v1));
}

}  // namespace surfmesh::compare
