// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/core/notice.hh"
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

/// A shortfall of the patches that are marked; none if no patch is. The reason follows their names.
inline std::optional<Notice> shortfall_of_patches(NoticeKind kind, const Model& model,
                                                  const std::vector<char>& is_marked,
                                                  std::string_view reason) {
  const std::string names = patch_names(model, is_marked);
  if (names.empty()) return std::nullopt;
  Notice notice = shortfall(kind, fmt::format("{}: {}", names, reason));
  notice.patch =
      static_cast<int>(std::find(is_marked.begin(), is_marked.end(), 1) - is_marked.begin());
  return notice;
}

}  // namespace surfmesh::detail
