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

/// Call `body(index)` for each of the indices, shared among threads, and tell how far it is.
template <class Body>
void share_and_tell(std::string_view stage, const std::vector<std::size_t>& indices,
                    const RunContext& context, Body body) {
  std::mutex mutex;
  std::size_t done = 0;
  context.tell(stage, 0, indices.size());
  share_indices(indices, [&](std::size_t i) {
    context.throw_if_cancelled();
    body(i);
    const std::lock_guard lock(mutex);
    context.tell(stage, ++done, indices.size());
  });
}

/// Call `body(index)` for each patch of a model, shared among threads, the patches of the greatest
/// weight first; tell how far it is, and name the patch in errors; that of the first patch counts.
template <class Body>
void for_each_patch(const Model& model, std::string_view stage, const RunContext& context,
                    const std::vector<std::size_t>& weights, Body body) {
  share_and_tell(stage, heaviest_first(weights), context,
                 [&](std::size_t p) { at_patch(model.patches[p], [&] { body(p); }); });
}

}  // namespace surfmesh
