// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surfmesh {

/// How the program ends.
enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,
  kWrongUsage = 2,
  kFellShort = 3,        ///< done, but something asked for was not reached
  kKilledBySignal = 128  ///< plus the number of the signal
};

}  // namespace surfmesh
