// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/comparison.hh"

namespace surfmesh::compare {

struct Bar {
  std::string label;
  double value = 0;
  std::string text;  ///< beside the bar
};

/// Bars that share a scale.
struct BarGroup {
  std::string title;
  std::vector<Bar> bars;
};

/// A picture (SVG) of horizontal bars. The longest of each group has the full length.
std::string bar_chart(const std::string& title, const std::vector<BarGroup>& groups);

/// Triangles per processor second of the whole process, a group for each plane case. In a cage by
/// its sag the better mesh has fewer triangles, so their number a second would tell nothing.
std::string speed_chart(const std::vector<CaseResult>& cases);

/// The deviation σ of metric lengths and, for cages, the number of triangles.
std::string quality_chart(const std::vector<CaseResult>& cases);

}  // namespace surfmesh::compare
