// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "surfmesh/model/model.hh"

namespace surfmesh::detail {

/// The patches that are marked, as they stand in a message: "patch wing", or "patch wing and 3
/// more", for around a vertex of many faces there may be hundreds; empty if none is.
inline std::string patch_names(const Model& model, const std::vector<char>& is_marked) {
  std::string text;
  std::size_t more = 0;
  for (std::size_t p = 0; p < is_marked.size(); ++p) {
    if (is_marked[p] == 0) continue;
    if (text.empty()) {
      text = fmt::format("patch {}", model.patches[p].name);
    } else {
      ++more;
    }
  }
  return more > 0 ? fmt::format("{} and {} more", text, more) : text;
}

}  // namespace surfmesh::detail
