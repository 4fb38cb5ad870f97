// SPDX-License-Identifier: BSD-3-Clause
#include "progress_line.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace surfmesh {
namespace {

/// Of the stage that makes elements, while some are missing: their number is an estimate.
constexpr double kNearlyAll = 0.99;

constexpr std::size_t kWidestBar = 24;
constexpr std::size_t kShortestBar = 4;

std::string bar(double share, std::size_t width, bool has_unicode) {
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(width)));
  std::string text = has_unicode ? "" : "[";
  for (std::size_t i = 0; i < width; ++i) {
    text += has_unicode ? (i < full ? "█" : "░") : (i < full ? "#" : ".");
  }
  return has_unicode ? text : text + ']';
}

}  // namespace

void RunShare::progress(std::string_view stage, std::size_t done, std::size_t total) {
  if (stage == "estimate") {
    expected_ = total;
    return;
  }
  if (rank_of(stage) < rank_of(stage_)) ++pass_;
  stage_ = stage;
  done_ = done;
  total_ = total;
}

/// Where the stage stands among those of the run; behind all where it is not known, and before them
/// while there is none.
std::size_t RunShare::rank_of(std::string_view stage) const {
  if (stage.empty()) return 0;
  const auto found = std::find_if(stages_.begin(), stages_.end(),
                                  [&](const StageWeight& known) { return known.stage == stage; });
  return static_cast<std::size_t>(found - stages_.begin());
}

double RunShare::share_of_stage() const {
  const double units = total_ > 0 ? static_cast<double>(done_) / static_cast<double>(total_) : 0;
  if (stage_ != "mesh" || expected_ == 0 || done_ == total_) return units;
  return std::min(static_cast<double>(elements_) / static_cast<double>(expected_), kNearlyAll);
}

std::optional<double> RunShare::value() const {
  const std::size_t rank = rank_of(stage_);
  if (rank == stages_.size()) return std::nullopt;
  double share = stages_[rank].weight * share_of_stage();
  for (std::size_t i = 0; i < rank; ++i) share += stages_[i].weight;
  if (!has_passes_ || rank == 0 || rank + 1 == stages_.size()) return share;
  // Of several meshes, each counts as half of what is left.
  const double left = std::exp2(1.0 - pass_);
  return 1 - left + 0.5 * left * share;
}

std::string progress_line(const RunShare& share, double seconds, std::size_t width,
                          bool has_unicode) {
  const std::string stage =
      share.total() > 1 ? fmt::format("{} {}/{}", share.stage(), share.done(), share.total())
                        : share.stage();
  const std::optional<double> value = share.value();
  std::string figures = value ? fmt::format("{:>3.0f} %", std::floor(100 * *value)) : "";
  for (const auto& [is_known, figure] :
       {std::pair(share.elements() > 0, fmt::format("{} elements", share.elements())),
        std::pair(share.pass() > 1, fmt::format("pass {}", share.pass())),
        std::pair(true, fmt::format("{:.1f} s", seconds))}) {
    if (!is_known) continue;
    figures += figures.empty() ? "" : "  ";
    figures += figure;
  }
  const std::size_t frame = has_unicode ? 0 : 2;
  const std::size_t taken = stage.size() + 2 + frame + 1 + figures.size();
  if (value && width >= taken + kShortestBar) {
    const std::size_t bar_width = std::min(kWidestBar, width - taken);
    return fmt::format("{}  {} {}", stage, bar(*value, bar_width, has_unicode), figures);
  }
  return fmt::format("{}  {}", stage, figures).substr(0, width);
}

}  // namespace surfmesh
