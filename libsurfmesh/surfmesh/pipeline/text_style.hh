// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// How the summary of a run or a check is written for a terminal.
struct TextStyle {
  bool is_long = false;      ///< with all tables; otherwise about twenty lines
  bool has_unicode = false;  ///< bars of block characters, and √; otherwise ASCII alone
};

}  // namespace surfmesh
