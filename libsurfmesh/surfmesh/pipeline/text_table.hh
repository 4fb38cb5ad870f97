// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/pipeline/text_style.hh"
#include "surfmesh/quality/quad_statistics.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh::detail {

/// Columns of a summary. Only words that are longer, such as paths, stand out.
inline constexpr std::size_t kTextWidth = 80;

/// A row of a histogram.
struct HistogramRow {
  std::string label;
  std::size_t count = 0;
};

/// A histogram as the summaries show it, one beside another.
struct HistogramText {
  std::vector<std::string> heading;
  std::vector<HistogramRow> rows;
  HistogramRow share;     ///< of what is wanted, or is not, in a last row; none without a label
  std::size_t total = 0;  ///< of which the rows tell shares
};

/// Rows for the ranges between limits, each the sum of the bins in it. The last one begins at the
/// last limit.
std::vector<HistogramRow> rows_between(std::span<const HistogramBin> bins,
                                       std::span<const double> limits);

HistogramText quality_text(std::string_view what, const QualityStatistics& quality,
                           const TextStyle& style);
HistogramText jacobian_text(const QuadStatistics& quads, const TextStyle& style);
HistogramText length_text(const EdgeStatistics& edges, const TextStyle& style);

/// "99.8 % in [1/√2, √2]", in the letters of a style.
std::string unit_share_text(const EdgeStatistics& edges, const TextStyle& style);

/// A number of code points of a text in UTF-8.
std::size_t columns(std::string_view text);

/// Makes the lines of a summary: keys with their values, histograms in pairs, and tables.
class TextTable {
 public:
  explicit TextTable(const TextStyle& style) : style_(style) {}

  const TextStyle& style() const { return style_; }

  /// A key and a value, which goes on in the next lines where it is too long. An empty key goes on
  /// with what the last one is about.
  void add(std::string_view key, std::string_view value);

  /// A key and a value of its own line, however long it is.
  void add_line(std::string_view key, std::string_view value);

  void add_blank() { text_ += '\n'; }

  /// Two histograms side by side, or one alone where the other is empty.
  void add_histograms(const HistogramText& left, const HistogramText& right);

  /// Rows below a heading: the first column to the left, all others to the right.
  void add_rows(const std::vector<std::string>& heading,
                const std::vector<std::vector<std::string>>& rows);

  std::string take();

 private:
  TextStyle style_;
  std::string text_;
};

}  // namespace surfmesh::detail
