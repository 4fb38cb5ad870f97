// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "signals.hh"
#include "surfmesh/core/observer.hh"

namespace surfmesh {

/// Shows the progress of a run in one line of the terminal, and stops the run on a signal.
class Progress : public Observer {
 public:
  explicit Progress(bool is_shown) : is_shown_(is_shown) {}
  ~Progress() override { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void progress(std::string_view stage, std::size_t done, std::size_t total) override;
  void at_work(std::size_t elements, int pass) override;
  bool is_cancelled() override { return caught_signal() != 0; }

  /// Take the line away, before anything else is printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void show();

  bool is_shown_;
  bool has_line_ = false;
  std::string stage_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  std::size_t elements_ = 0;
  int pass_ = 0;  ///< the mesh of the run that is made; a sag takes several
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_;
};

/// True if warnings and errors go to a terminal.
bool is_terminal();

}  // namespace surfmesh
