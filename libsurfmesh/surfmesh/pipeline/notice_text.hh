// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "surfmesh/core/counted.hh"
#include "surfmesh/core/notice.hh"

namespace surfmesh::detail {

/// The notices in a summary: "none", "2 warnings, 1 note", "1 warning; NOT REACHED:
/// sag_not_reached". Their texts are told elsewhere.
inline std::string notices_text(const Notices& notices) {
  std::size_t warnings = 0, notes = 0;
  std::string missed;
  std::vector<NoticeKind> kinds;
  for (const Notice& notice : notices) {
    if (notice.severity == Severity::Warning) {
      ++warnings;
      continue;
    }
    if (notice.severity == Severity::Information) {
      ++notes;
      continue;
    }
    if (std::find(kinds.begin(), kinds.end(), notice.kind) != kinds.end()) continue;
    kinds.push_back(notice.kind);
    missed += missed.empty() ? "NOT REACHED: " : ", ";
    missed += name(notice.kind);
  }
  std::string text;
  if (warnings > 0) text = counted(warnings, "warning", "warnings");
  if (notes > 0) text += (text.empty() ? "" : ", ") + counted(notes, "note", "notes");
  if (text.empty()) return missed.empty() ? "none" : missed;
  return missed.empty() ? text : fmt::format("{}; {}", text, missed);
}

}  // namespace surfmesh::detail
