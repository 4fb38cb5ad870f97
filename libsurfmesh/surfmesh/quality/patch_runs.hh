// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace surfmesh::detail {

/// Values of runs of faces of one patch each. The faces of a patch follow each other, mostly, so
/// that a range of faces has few runs.
template <class Value>
class PatchRuns {
 public:
  /// The value of the run that the next face, which is of this patch, belongs to.
  Value& next(int patch) {
    if (runs_.empty() || runs_.back().first != patch) runs_.emplace_back(patch, Value());
    return runs_.back().second;
  }

  PatchRuns& operator+=(const PatchRuns& other) {
    runs_.insert(runs_.end(), other.runs_.begin(), other.runs_.end());
    return *this;
  }

  auto begin() const { return runs_.begin(); }
  auto end() const { return runs_.end(); }

 private:
  std::vector<std::pair<int, Value>> runs_;
};

}  // namespace surfmesh::detail
