// SPDX-License-Identifier: BSD-3-Clause
#include "compare/chart.hh"

#include <fmt/format.h>

#include <algorithm>

#include "compare/cage_comparison.hh"
#include "pictures/svg.hh"

namespace surfmesh::compare {
namespace {

// All in pixels.
constexpr double kWidth = 640, kMargin = 12, kTitle = 18, kText = 12;
constexpr double kLabels = 90;       // width of the names of tools
constexpr double kLongestBar = 380;  // the rest is for the text beside it
constexpr double kBar = 16, kRow = 21, kGroup = 40, kHead = 40;

double height_of(const std::vector<BarGroup>& groups) {
  double height = kHead + kMargin;
  for (const BarGroup& group : groups) {
    height += kGroup + kRow * static_cast<double>(group.bars.size());
  }
  return height;
}

/// The first bar of a group, surfmesh's, stands out.
PictureStyle style_of(std::size_t bar) { return {bar == 0 ? "#1f6fb4" : grey(0.7), "none", 0}; }

void add_group(Svg& picture, const BarGroup& group, double top) {
  picture.add_text({kMargin, top + kGroup - 0.6 * kText}, group.title, kText);
  double greatest = 0;
  for (const Bar& bar : group.bars) greatest = std::max(greatest, bar.value);
  double y = top + kGroup;
  for (std::size_t i = 0; i < group.bars.size(); ++i, y += kRow) {
    const Bar& bar = group.bars[i];
    const double length = greatest > 0 ? kLongestBar * bar.value / greatest : 0;
    const double left = kMargin + kLabels, line = y + 0.5 * kBar + 0.35 * kText;
    picture.add_text({left - 0.5 * kText, line}, bar.label, kText, TextAnchor::End);
    picture.add_rectangle({left, y}, length, kBar, style_of(i));
    picture.add_text({left + length + 0.5 * kText, line}, bar.text, kText);
  }
}

/// A group of the bars of one case, by what `bar_of` tells of each tool.
template <class BarOf>
BarGroup group_of(const CaseResult& result, const std::string& title, BarOf bar_of) {
  BarGroup group{title, {}};
  for (const ToolResult& tool : result.tools) {
    group.bars.push_back(tool.failure.empty() ? bar_of(tool) : Bar{tool.tool, 0, tool.failure});
  }
  return group;
}

Bar speed_bar(const ToolResult& tool, const std::vector<double>& seconds) {
  const double value = speed(tool.mesh.triangles, seconds).value_or(0);
  return {tool.tool, value, value > 0 ? fmt::format("{:.0f} thousand", value / 1000) : "–"};
}

Bar deviation_bar(const ToolResult& tool) {
  return {tool.tool, tool.mesh.stddev, fmt::format("{:.3f}", tool.mesh.stddev)};
}

Bar count_bar(const ToolResult& tool) {
  // Meshes that are farther away than asked for are not comparable by their triangles.
  if (tool.distance > kWantedSag) return {tool.tool, 0, "does not reach the sag"};
  return {tool.tool, static_cast<double>(tool.mesh.triangles),
          fmt::format("{} at {:.3f} %", tool.mesh.triangles, 100 * tool.distance)};
}

}  // namespace

std::string bar_chart(const std::string& title, const std::vector<BarGroup>& groups) {
  Svg picture(kWidth, height_of(groups));
  picture.add_text({kMargin, kMargin + kTitle}, title, kTitle);
  double top = kHead;
  for (const BarGroup& group : groups) {
    add_group(picture, group, top);
    top += kGroup + kRow * static_cast<double>(group.bars.size());
  }
  return picture.text();
}

std::string speed_chart(const std::vector<CaseResult>& cases) {
  std::vector<BarGroup> groups;
  for (const CaseResult& result : cases) {
    if (result.is_cage) continue;
    groups.push_back(group_of(result, result.name + ", whole process", [](const ToolResult& tool) {
      return speed_bar(tool, tool.processor_seconds);
    }));
    groups.push_back(group_of(result, result.name + ", meshing alone", [](const ToolResult& tool) {
      return speed_bar(tool, tool.meshing_seconds);
    }));
  }
  return bar_chart("Triangles per processor second (more is better)", groups);
}

std::string quality_chart(const std::vector<CaseResult>& cases) {
  std::vector<BarGroup> groups;
  for (const CaseResult& result : cases) {
    groups.push_back(
        result.is_cage
            ? group_of(result, result.name + ": triangles, and their sag", count_bar)
            : group_of(result, result.name + ": deviation σ of the metric lengths", deviation_bar));
  }
  return bar_chart("Quality (less is better)", groups);
}

}  // namespace surfmesh::compare
