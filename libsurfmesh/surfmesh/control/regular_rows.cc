// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/control/regular_rows.hh"

#include <cmath>

namespace surfmesh {
namespace {

/// True for a metric in which rectangles have their four corners on a circle.
bool is_along_rows(const Metric& spacing) {
  return std::isfinite(spacing.m11) && std::isfinite(spacing.m22) && spacing.m12 == 0;
}

class RowScan {
 public:
  RowScan(const Domain& domain, const std::vector<ControlNode>& nodes)
      : domain_(domain), nodes_(nodes) {}

  RegularRows scan() const {
    if (!is_node(0, {domain_.u0, domain_.v0}) || !is_along_rows(nodes_[0].spacing)) return {};
    RegularRows rows{1, 1};
    while (is_node(rows.width) && nodes_[rows.width].uv.v == domain_.v0) ++rows.width;
    if (!is_first_row(rows.width)) return {};
    while (is_row(rows, rows.height)) ++rows.height;
    const bool covers = rows.height > 1 && nodes_[rows.count() - 1].uv.v == domain_.v1;
    return covers ? rows : RegularRows();
  }

 private:
  bool is_node(std::size_t i) const {
    return i < nodes_.size() && nodes_[i].spacing == nodes_[0].spacing;
  }

  bool is_node(std::size_t i, Uv uv) const { return is_node(i) && nodes_[i].uv == uv; }

  bool is_first_row(std::size_t width) const {
    for (std::size_t i = 1; i < width; ++i) {
      if (!(nodes_[i - 1].uv.u < nodes_[i].uv.u)) return false;
    }
    return width > 1 && nodes_[width - 1].uv.u == domain_.u1;
  }

  /// True if a row follows, above the one before.
  bool is_row(const RegularRows& rows, std::size_t row) const {
    const std::size_t first = row * rows.width;
    if (!is_node(first) || !(nodes_[first - 1].uv.v < nodes_[first].uv.v)) return false;
    for (std::size_t i = 0; i < rows.width; ++i) {
      if (!is_node(first + i, {nodes_[i].uv.u, nodes_[first].uv.v})) return false;
    }
    return true;
  }

  const Domain& domain_;
  const std::vector<ControlNode>& nodes_;
};

}  // namespace

RegularRows find_regular_rows(const Domain& domain, const std::vector<ControlNode>& nodes) {
  return RowScan(domain, nodes).scan();
}

std::vector<std::array<int, 3>> triangles_between(const RegularRows& rows) {
  std::vector<std::array<int, 3>> triangles;
  if (rows.count() == 0) return triangles;
  triangles.reserve(2 * (rows.width - 1) * (rows.height - 1));
  const int width = static_cast<int>(rows.width);
  for (int row = 0; row + 1 < static_cast<int>(rows.height); ++row) {
    for (int column = 0; column + 1 < width; ++column) {
      const int a = row * width + column, b = a + 1, c = b + width, d = a + width;
      if ((row + column) % 2 == 0) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  }
  return triangles;
}

}  // namespace surfmesh
