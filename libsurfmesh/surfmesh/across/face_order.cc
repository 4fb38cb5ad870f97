// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/across/face_order.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"

namespace surfmesh {
namespace {

/// The runs of a range of faces.
struct FoundRuns {
  std::vector<FaceRun> runs;

  FoundRuns& operator+=(const FoundRuns& other) {
    runs.insert(runs.end(), other.runs.begin(), other.runs.end());
    return *this;
  }
};

std::vector<FaceRun> runs_of(const PolyMesh& result, const std::vector<char>& is_taken) {
  const auto patch_of = require(result, keys::face_patch);
  return sum_of_ranges(result.n_faces(),
                       [&](std::size_t first, std::size_t end) {
                         FoundRuns own;
                         for (std::size_t f = first; f < end; ++f) {
                           const int patch =
                               result.property(patch_of, FaceHandle(static_cast<int>(f)));
                           if (own.runs.empty() || own.runs.back().patch != patch) {
                             own.runs.push_back({patch, f, f, 0, 0});
                           }
                           ++own.runs.back().end;
                           if (is_taken[f] == 0) ++own.runs.back().count;
                         }
                         return own;
                       })
      .runs;
}

}  // namespace

FaceOrder::FaceOrder(const PolyMesh& result, const std::vector<char>& is_taken,
                     std::span<const ReturningRegion> regions)
    : runs_(runs_of(result, is_taken)) {
  for (const ReturningRegion& region : regions) numbers_.push_back(region.face_counts());
  count_by_patch();
  number();
}

void FaceOrder::count_by_patch() {
  const auto add = [this](int patch, std::size_t count) {
    const auto after = static_cast<std::size_t>(patch) + 1;
    if (after >= first_of_patches_.size()) first_of_patches_.resize(after + 1, 0);
    first_of_patches_[after] += count;
  };
  first_of_patches_.assign(1, 0);
  for (const FaceRun& run : runs_) add(run.patch, run.count);
  for (const auto& counts : numbers_) {
    for (const auto& [patch, count] : counts) add(patch, count);
  }
  std::partial_sum(first_of_patches_.begin(), first_of_patches_.end(), first_of_patches_.begin());
}

void FaceOrder::number() {
  std::vector<std::size_t> next = first_of_patches_;
  const auto take = [&next](int patch, std::size_t count) {
    std::size_t& of_patch = next[static_cast<std::size_t>(patch)];
    return std::exchange(of_patch, of_patch + count);
  };
  for (FaceRun& run : runs_) run.number = take(run.patch, run.count);
  for (auto& numbers : numbers_) {
    for (auto& [patch, number] : numbers) number = take(patch, number);
  }
}

}  // namespace surfmesh
