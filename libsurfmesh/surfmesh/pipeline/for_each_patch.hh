// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/model/model.hh"

namespace surfmesh {

/// Run `body`. Its errors get the patch in front, unless they tell a place in its part of a file.
template <class Body>
void at_patch(const Patch& patch, Body body) {
  try {
    body();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (!patch.origin.empty() && text.starts_with(patch.origin + "/")) throw;
    throw Error(error.code(), label(patch) + ": " + text);
  }
}

/// Call `body(index)` for each patch of a model, shared among threads, the patches of the greatest
/// weight first; tell how far it is, and name the patch in errors; that of the first patch counts.
template <class Body>
void for_each_patch(const Model& model, std::string_view stage, const RunContext& context,
                    const std::vector<std::size_t>& weights, Body body) {
  std::mutex mutex;
  std::size_t done = 0;
  context.tell(stage, 0, model.patches.size());
  share_indices(heaviest_first(weights), [&](std::size_t p) {
    context.throw_if_cancelled();
    at_patch(model.patches[p], [&] { body(p); });
    const std::lock_guard lock(mutex);
    context.tell(stage, ++done, model.patches.size());
  });
}

}  // namespace surfmesh
