// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// MPI, from its start to its end. A program has one of these, and makes it first; an application
/// that starts MPI itself needs none.
class MpiSession {
 public:
  /// Start MPI. Threads may work beside the calling one, which alone exchanges something
  /// (MPI_THREAD_FUNNELED).
  ///
  /// Throws   Io if MPI does not start, or knows no threads
  MpiSession(int& argc, char**& argv);

  /// End MPI, which waits for all ranks to do so.
  ~MpiSession();

  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

  /// The name and version of the MPI that runs: "Open MPI v4.1.4".
  static std::string library();

  /// End all ranks, whatever they do: this one at once, the others by SIGTERM. Some of them may
  /// wait for this one, which has an error that they do not know of.
  [[noreturn]] static void abort(int status);
};

}  // namespace surfmesh
