// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string_view>
#include <vector>

#include "surfmesh/core/at_place.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Tell an observer, which may be null, how far a stage is.
/// Throws   Limit where it cancels
inline void tell(Observer* observer, std::string_view stage, std::size_t done, std::size_t total) {
  if (!observer) return;
  observer->progress(stage, done, total);
  throw_if_cancelled(observer);
}

/// Call `body(index)` for each patch of a model, shared among threads, the patches of the greatest
/// weight first; tell how far it is, and name the patch in errors; that of the first patch counts.
template <class Body>
void for_each_patch(const Model& model, std::string_view stage, Observer* observer,
                    const std::vector<std::size_t>& weights, Body body) {
  std::mutex mutex;
  std::size_t done = 0;
  tell(observer, stage, 0, model.patches.size());
  share_indices(heaviest_first(weights), [&](std::size_t p) {
    throw_if_cancelled(observer);
    at_place("patch " + model.patches[p].name, [&] { body(p); });
    const std::lock_guard lock(mutex);
    tell(observer, stage, ++done, model.patches.size());
  });
}

}  // namespace surfmesh
