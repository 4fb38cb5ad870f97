// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "surfmesh/quality/statistics.hh"

namespace surfmesh::detail {

/// Triangles below this quality are counted apart.
inline constexpr double kPoorQuality = 0.3;

inline constexpr int kQualityBins = 10;  ///< from 0 to 1

/// A bin for what is turned over, from −1 to 0, and ten from 0 to 1, all empty.
inline std::vector<HistogramBin> empty_quality_histogram() {
  std::vector<HistogramBin> bins = {{-1, 0, 0}};
  for (int i = 0; i < kQualityBins; ++i) {
    bins.push_back(
        {static_cast<double>(i) / kQualityBins, static_cast<double>(i + 1) / kQualityBins, 0});
  }
  return bins;
}

inline constexpr int kBinsPerOctave = 4;
inline constexpr int kOctaves = 2;  ///< each way from 1

/// The bins of EdgeStatistics, all empty.
inline std::vector<HistogramBin> empty_length_histogram() {
  const auto limit = [](int i) {
    return std::exp2(static_cast<double>(i) / kBinsPerOctave - kOctaves);
  };
  std::vector<HistogramBin> bins;
  for (int i = 0; i < 2 * kOctaves * kBinsPerOctave; ++i) {
    bins.push_back({i == 0 ? 0 : limit(i), limit(i + 1), 0});
  }
  return bins;
}

/// The bin of a length by its logarithm; those beyond the ends fall into the first and last one.
inline std::size_t length_bin(double length, std::size_t bins) {
  const double position = (std::log2(length) + kOctaves) * kBinsPerOctave;
  return static_cast<std::size_t>(std::clamp(position, 0.0, static_cast<double>(bins - 1)));
}

/// Add the counts of a histogram of the same bins.
inline void add_counts(const std::vector<HistogramBin>& more, std::vector<HistogramBin>& bins) {
  for (std::size_t i = 0; i < bins.size(); ++i) bins[i].count += more[i].count;
}

/// Count a quality, which by rounding may be a little beyond 1; one that is no number counts as
/// turned over. The bins agree with comparisons to their limits: a quality is below 0.3 exactly if
/// its bin is.
inline void count_quality(double quality, std::vector<HistogramBin>& bins) {
  const double position = std::clamp(1 + quality * kQualityBins, 0.0, double{kQualityBins});
  std::size_t bin = quality >= 0 ? static_cast<std::size_t>(position) : 0;
  if (bin > 0 && quality < bins[bin].from) --bin;
  ++bins[bin].count;
}

}  // namespace surfmesh::detail
