// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace surfmesh {

/// Remember SIGINT, SIGTERM and SIGHUP, so that the run can end by itself. Where it does not within
/// a quarter of a second, or at a second signal, the program ends at once. Either way the exit
/// status is 128 plus the signal, and no file of a RemovedOnSignal is left behind.
void catch_signals();

/// Turn SIGXFSZ and SIGPIPE into errors of writing, instead of signals that end the program.
void take_errors_for_signals();

/// The signal that came, 0 for none.
int caught_signal();

/// Throws   Cancelled if a signal came
void throw_if_signalled();

/// Run `commit` without interruption. With it the work is done: a signal that comes later still
/// ends the program, but with this exit status.
void commit_against_signals(int status, const std::function<void()>& commit);

/// Do not tell of a signal that ends the program, as where another process tells of it.
void be_silent_on_signals();

/// While it exists, a crash of the program is told by a text, and ends it with exit status 1; no
/// file of a RemovedOnSignal is left behind. For libraries that fall over damaged files.
class TellsCrash {
 public:
  explicit TellsCrash(std::string text);
  ~TellsCrash();
  TellsCrash(const TellsCrash&) = delete;
  TellsCrash& operator=(const TellsCrash&) = delete;

 private:
  std::string text_;
};

/// What to write to the standard error before the program ends at once, or becomes another one, so
/// that no line of progress is left on the terminal. It must live on; null for nothing.
void set_terminal_wipe(const char* text);

/// Write it, if there is something to write. A handler of signals may call this.
void wipe_terminal();

/// A temporary file, or a folder of files, that is removed where a signal ends the program at once.
class RemovedOnSignal {
 public:
  /// `path` may be empty.
  explicit RemovedOnSignal(const std::filesystem::path& path);
  ~RemovedOnSignal();
  RemovedOnSignal(const RemovedOnSignal&) = delete;
  RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;

 private:
  std::string path_;
};

}  // namespace surfmesh
