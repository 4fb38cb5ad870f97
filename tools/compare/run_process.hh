// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace surfmesh::compare {

/// A program with its arguments.
using Command = std::vector<std::string>;

/// What a finished process was like.
struct ProcessRun {
  double processor_seconds = 0;  ///< user and system, of the process and its children
  double clock_seconds = 0;      ///< from its start to its end
  bool is_timed_out = false;
  int signal = 0;   ///< that ended it, 0 for none
  int status = 0;   ///< its exit status, if no signal ended it
  std::string log;  ///< its standard output and error
};

/// Run a program in a directory, with one thread for OpenMP. After so many seconds by the clock it
/// is killed with all that it started.
///
/// Throws   Io if no process can be started. A program that is not there has exit status 127
ProcessRun run_process(const Command& command, const std::filesystem::path& directory,
                       double time_limit);

/// Why a run is of no use, in a few words; empty if its exit status is 0.
std::string failure_of(const ProcessRun& run);

/// The command as one would type it.
std::string command_line(const Command& command);

}  // namespace surfmesh::compare
