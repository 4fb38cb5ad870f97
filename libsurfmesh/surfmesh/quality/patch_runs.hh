// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "surfmesh/core/properties.hh"

namespace surfmesh::detail {

/// The patch of a face, 0 for all of a mesh without patches.
class PatchOf {
 public:
  explicit PatchOf(const PolyMesh& mesh) : mesh_(mesh), handle_(find(mesh, keys::face_patch)) {}

  int operator()(std::size_t face) const {
    return handle_.is_valid() ? mesh_.property(handle_, FaceHandle(static_cast<int>(face))) : 0;
  }

 private:
  const PolyMesh& mesh_;
  decltype(keys::face_patch)::Handle handle_;
};

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

/// The least of some values; infinite for none.
struct Least {
  double value = std::numeric_limits<double>::infinity();
};

/// By patch; empty where no face has one.
inline std::vector<double> least_of_patches(const PatchRuns<Least>& runs) {
  int most = -1;
  for (const auto& [patch, least] : runs) most = std::max(most, patch);
  std::vector<double> values(static_cast<std::size_t>(most + 1), Least().value);
  for (const auto& [patch, least] : runs) {
    if (patch < 0) continue;
    double& own = values[static_cast<std::size_t>(patch)];
    own = std::min(own, least.value);
  }
  return values;
}

}  // namespace surfmesh::detail
