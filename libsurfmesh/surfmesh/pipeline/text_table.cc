// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/text_table.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "surfmesh/metric/triangle.hh"

namespace surfmesh::detail {
namespace {

constexpr std::size_t kKeyWidth = 10;

/// A histogram is as wide as half a line: label, count, percent and bar, with blanks between them.
constexpr std::size_t kLabelWidth = 14;
constexpr std::size_t kCountWidth = 8;
constexpr std::size_t kShareWidth = 7;
constexpr std::size_t kBarWidth = 8;
constexpr std::size_t kHistogramWidth = kLabelWidth + kCountWidth + 1 + kShareWidth + 1 + kBarWidth;
constexpr std::size_t kGap = kTextWidth - 2 * kHistogramWidth;

/// Longer names are cut in tables, which would be too wide.
constexpr std::size_t kLongestCell = 20;

constexpr std::array kQualityLimits = {-1.0, 0.0, 0.3, 0.6, 0.8, 0.9};
constexpr std::array kLengthLimits = {0.0, 0.5, kShortestUnit, 1.0, kLongestUnit, 2.0};

std::string padded(std::string text, std::size_t width) {
  const std::size_t length = columns(text);
  if (length < width) text.append(width - length, ' ');
  return text;
}

std::string padded_left(const std::string& text, std::size_t width) {
  const std::size_t length = columns(text);
  return (length < width ? std::string(width - length, ' ') : std::string()) + text;
}

/// Without the blanks at its end.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The end of a bar in eighths of a column.
constexpr std::array kEighths = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

/// A bar for a share of the whole width; what is there at all is seen.
std::string bar(double share, const TextStyle& style) {
  if (!(share > 0)) return {};
  std::string text;
  if (!style.has_unicode) {
    const auto full = static_cast<std::size_t>(std::lround(share * kBarWidth));
    return full > 0 ? std::string(full, '#') : ".";
  }
  const auto eighths =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(share * kBarWidth * 8)));
  for (std::size_t i = 0; i < eighths / 8; ++i) text += "█";
  return text + kEighths[eighths % 8];
}

double share_of(std::size_t count, std::size_t total) {
  return total == 0 ? 0 : static_cast<double>(count) / static_cast<double>(total);
}

/// `digits` behind the point of the percentage.
std::string row_text(const HistogramRow& row, std::size_t total, int digits) {
  return fmt::format("{}{:>{}} {:>{}}", padded(row.label, kLabelWidth), row.count, kCountWidth,
                     fmt::format("{:.{}f} %", 100 * share_of(row.count, total), digits),
                     kShareWidth);
}

std::vector<std::string> lines_of(const HistogramText& histogram, const TextStyle& style) {
  std::vector<std::string> lines;
  for (const std::string& heading : histogram.heading) lines.push_back(heading);
  std::size_t most = 0;
  for (const HistogramRow& row : histogram.rows) most = std::max(most, row.count);
  for (const HistogramRow& row : histogram.rows) {
    lines.push_back(row_text(row, histogram.total, 1) + ' ' +
                    bar(share_of(row.count, most), style));
  }
  return lines;
}

/// The rows of these bins, from the greatest values to the least; what is below 0 is turned over.
std::vector<HistogramRow> quality_rows(std::span<const HistogramBin> bins, const TextStyle& style) {
  std::vector<double> limits(kQualityLimits.begin(), kQualityLimits.end());
  if (style.is_long) {
    limits.clear();
    for (const HistogramBin& bin : bins) limits.push_back(bin.from);
  }
  std::vector<HistogramRow> rows = rows_between(bins, limits);
  if (!rows.empty()) rows.front().label = "turned over";
  std::reverse(rows.begin(), rows.end());
  return rows;
}

std::size_t count_of(double share, std::size_t total) {
  return static_cast<std::size_t>(std::llround(share * static_cast<double>(total)));
}

/// The words of a text in lines of at most `width` columns; a longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at + 1), text.size());
    const std::string_view word = text.substr(at, end - at);  // with the blank before it
    if (!lines.back().empty() && columns(lines.back()) + columns(word) > width) {
      lines.emplace_back(word.substr(word.starts_with(' ') ? 1 : 0));
    } else {
      lines.back() += word;
    }
    at = end;
  }
  return lines;
}

std::string cut_cell(const std::string& text) {
  if (columns(text) <= kLongestCell) return text;
  std::size_t end = 0;
  for (std::size_t count = 0; count < kLongestCell - 3; ++count) {
    for (++end; end < text.size() && (text[end] & '\xC0') == '\x80';) ++end;
  }
  return text.substr(0, end) + "...";
}

}  // namespace

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::vector<HistogramRow> rows_between(std::span<const HistogramBin> bins,
                                       std::span<const double> limits) {
  std::vector<HistogramRow> rows;
  for (std::size_t i = 0; i < limits.size() && !bins.empty(); ++i) {
    const bool is_last = i + 1 == limits.size();
    const double end = is_last ? bins.back().to : limits[i + 1];
    rows.push_back({fmt::format("{:.3g} to {:.3g}", limits[i], end), 0});
    for (const HistogramBin& bin : bins) {
      // Limits of bins may be rounded: their middles tell where they belong.
      const double middle = 0.5 * (bin.from + bin.to);
      if (middle > limits[i] && (is_last || middle < end)) rows.back().count += bin.count;
    }
  }
  return rows;
}

HistogramText quality_text(std::string_view what, const QualityStatistics& quality,
                           const TextStyle& style) {
  return {.heading = {std::string(what),
                      fmt::format("least {:.3f}, mean {:.3f}", quality.min, quality.mean)},
          .rows = quality_rows(quality.histogram, style),
          .share = {"below 0.3", count_of(quality.below_0_3, quality.count)},
          .total = quality.count};
}

HistogramText jacobian_text(const QuadStatistics& quads, const TextStyle& style) {
  return {
      .heading = {"scaled Jacobian of quads", fmt::format("least {:.3f}, mean {:.3f}",
                                                          quads.min_jacobian, quads.mean_jacobian)},
      .rows = quality_rows(quads.histogram, style),
      .share = {fmt::format("below {}", kFlatQuad), quads.flat},
      .total = quads.count};
}

HistogramText length_text(const EdgeStatistics& edges, const TextStyle& style) {
  std::vector<double> limits(kLengthLimits.begin(), kLengthLimits.end());
  if (style.is_long) {
    limits.clear();
    for (const HistogramBin& bin : edges.histogram) limits.push_back(bin.from);
  }
  return {.heading = {"metric length of edges (1 is wanted)",
                      fmt::format("{:.3f} to {:.3f}, mean {:.3f}, dev. {:.3f}", edges.min,
                                  edges.max, edges.mean, edges.stddev)},
          .rows = rows_between(edges.histogram, limits),
          .share = {style.has_unicode ? "[1/√2, √2]" : "0.707 to 1.41",
                    count_of(edges.unit_fraction, edges.count)},
          .total = edges.count};
}

std::string unit_share_text(const EdgeStatistics& edges, const TextStyle& style) {
  return fmt::format("{:.1f} % in {}", 100 * edges.unit_fraction,
                     style.has_unicode ? "[1/√2, √2]" : "[0.707, 1.414]");
}

void TextTable::add(std::string_view key, std::string_view value) {
  for (const std::string& line : wrapped(value, kTextWidth - kKeyWidth)) {
    add_line(key, line);
    key = "";
  }
}

void TextTable::add_line(std::string_view key, std::string_view value) {
  text_ += trimmed(fmt::format("{:<{}}{}", key, kKeyWidth, value)) + '\n';
}

void TextTable::add_histograms(const HistogramText& left, const HistogramText& right) {
  const std::vector<std::string> first = lines_of(left, style_), second = lines_of(right, style_);
  const std::size_t indent = first.empty() ? 0 : kHistogramWidth + kGap;
  const std::string none;
  const auto add_pair = [&](const std::string& a, const std::string& b) {
    text_ += trimmed(padded(a, indent) + b) + '\n';
  };
  for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
    add_pair(i < first.size() ? first[i] : none, i < second.size() ? second[i] : none);
  }
  const auto share = [](const HistogramText& histogram) {
    if (histogram.share.label.empty()) return std::string();
    return row_text(histogram.share, histogram.total, 2);
  };
  add_pair(share(left), share(right));
}

void TextTable::add_rows(const std::vector<std::string>& heading,
                         const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::string& cell : heading) widths.push_back(columns(cell));
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns(cut_cell(row[i])));
    }
  }
  const auto add_row = [&](const std::vector<std::string>& row) {
    std::string line = padded(cut_cell(row.front()), widths.front());
    for (std::size_t i = 1; i < row.size(); ++i) {
      line += "  " + padded_left(cut_cell(row[i]), widths[i]);
    }
    text_ += trimmed(std::move(line)) + '\n';
  };
  add_row(heading);
  for (const auto& row : rows) add_row(row);
}

std::string TextTable::take() { return std::exchange(text_, {}); }

}  // namespace surfmesh::detail
