// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surfmesh/core/notice.hh"

namespace surfmesh {

/// The texts of notices, all or those of one severity; those that came more than once with how
/// often more.
inline std::vector<std::string> texts_of(const Notices& notices,
                                         std::optional<Severity> severity = {}) {
  std::vector<std::string> texts;
  for (const Notice& notice : notices) {
    if (severity && notice.severity != *severity) continue;
    texts.push_back(notice.text);
    if (notice.count > 1) {
      texts.back() += " (and " + std::to_string(notice.count - 1) + " more)";
    }
  }
  return texts;
}

}  // namespace surfmesh
