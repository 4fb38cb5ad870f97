// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// A copy of a model whose surfaces count how often they are evaluated.
///
/// Cost     of each evaluation, 5 ns more
class CountedModel {
 public:
  explicit CountedModel(const Model& model);

  const Model& model() const { return model_; }

  /// The evaluations of all surfaces so far.
  std::size_t evaluations() const;

 private:
  /// Of one surface; in a cache line of its own, for patches are meshed by several threads at once.
  struct alignas(64) Count {
    std::atomic<std::size_t> evaluations = 0;
  };
  class CountedSurface;

  Model model_;
  std::unique_ptr<Count[]> counts_;  ///< by patch
};

}  // namespace surfmesh::detail
