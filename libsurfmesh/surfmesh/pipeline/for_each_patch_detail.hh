// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "surfmesh/core/at_place.hh"
#include "surfmesh/core/observer.hh"
#include "surfmesh/geometry/model.hh"

namespace surfmesh {

/// Tell an observer, which may be null, how far a stage is.
/// Throws   Limit where it cancels
inline void tell(Observer* observer, std::string_view stage, std::size_t done, std::size_t total) {
  if (!observer) return;
  observer->progress(stage, done, total);
  throw_if_cancelled(observer);
}

/// Call `body(index)` for each patch of a model, tell how far it is, and name the patch in errors.
template <class Body>
void for_each_patch(const Model& model, std::string_view stage, Observer* observer, Body body) {
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    tell(observer, stage, p, model.patches.size());
    at_place("patch " + model.patches[p].name, [&] { body(p); });
  }
  tell(observer, stage, model.patches.size(), model.patches.size());
}

}  // namespace surfmesh
