// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surfmesh {

/// How much a command prints.
struct Verbosity {
  bool is_quiet = false;    ///< no summary and no notes, only warnings and errors
  bool is_verbose = false;  ///< all tables, and every warning
};

}  // namespace surfmesh
