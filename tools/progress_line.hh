// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace surfmesh {

/// A stage with its usual share of the time of a run.
struct StageWeight {
  std::string_view stage;
  double weight = 0;
};

/// The stages of kinds of runs, in their order; the weights of each sum up to 1. Those of a mesh
/// are as reports of large ones have them.
inline constexpr std::array kMeshStages = {
    StageWeight{"read", 0.02},  StageWeight{"control", 0.20},  StageWeight{"boundary", 0.03},
    StageWeight{"mesh", 0.55},  StageWeight{"assemble", 0.05}, StageWeight{"across", 0.10},
    StageWeight{"write", 0.05},
};
inline constexpr std::array kControlStages = {
    StageWeight{"read", 0.05},
    StageWeight{"control", 0.85},
    StageWeight{"write", 0.10},
};
inline constexpr std::array kViewModelStages = {
    StageWeight{"read", 0.02},    StageWeight{"control", 0.25},  StageWeight{"boundary", 0.03},
    StageWeight{"mesh", 0.40},    StageWeight{"assemble", 0.05}, StageWeight{"across", 0.05},
    StageWeight{"compare", 0.10}, StageWeight{"write", 0.10},
};
inline constexpr std::array kViewMeshStages = {
    StageWeight{"read", 0.20},
    StageWeight{"control", 0.30},
    StageWeight{"compare", 0.30},
    StageWeight{"write", 0.20},
};
inline constexpr std::array kCheckStages = {
    StageWeight{"read", 0.10},
    StageWeight{"check", 0.30},
    StageWeight{"compare", 0.50},
    StageWeight{"control", 0.10},
};

/// How far a run is, from what its stages tell.
class RunShare {
 public:
  explicit RunShare(std::span<const StageWeight> stages = kMeshStages) : stages_(stages) {}

  /// A run with a sag makes several meshes, nobody knows how many.
  void expect_passes() { has_passes_ = true; }

  /// What an Observer is told.
  void progress(std::string_view stage, std::size_t done, std::size_t total);
  void at_work(std::size_t elements) { elements_ = elements; }

  /// The share of the work of the whole run that is done, from 0 to 1; nothing at a stage that is
  /// not known. It grows, but falls back where a run begins a mesh that was not expected.
  ///
  /// Error    stages are weighed by their usual shares of the time, and the stage that makes
  /// elements
  ///          goes by their estimated number
  std::optional<double> value() const;

  const std::string& stage() const { return stage_; }
  std::size_t done() const { return done_; }
  std::size_t total() const { return total_; }
  std::size_t elements() const { return elements_; }
  int pass() const { return pass_; }  ///< the mesh of the run that is made, from 1

 private:
  std::size_t rank_of(std::string_view stage) const;
  double share_of_stage() const;

  std::span<const StageWeight> stages_;
  bool has_passes_ = false;
  std::string stage_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  std::size_t expected_ = 0;  ///< elements; 0 where they were not estimated
  std::size_t elements_ = 0;  ///< made so far
  int pass_ = 1;
};

/// A line of progress of at most `width` columns: stage, bar, percent, elements, pass, seconds.
/// What does not fit is left out, the bar first.
std::string progress_line(const RunShare& share, double seconds, std::size_t width,
                          bool has_unicode);

}  // namespace surfmesh
