// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <span>
#include <string_view>
#include <thread>

#include "progress_line.hh"
#include "signals.hh"
#include "surfmesh/core/observer.hh"
#include "terminal.hh"

namespace surfmesh {

/// Shows the progress of a run on the terminal of the standard error, and stops the run on a
/// signal.
///
/// A line with a bar is drawn again a few times a second, by a thread of its own, so that it goes
/// on where a stage has nothing to tell. It fits the terminal, which may change its width, and is
/// taken away in the end. A terminal that cannot take it back (TERM=dumb) gets a line for each
/// stage.
class Progress : public Observer {
 public:
  /// The stages are those of the kind of run.
  explicit Progress(bool is_shown, std::span<const StageWeight> stages = kMeshStages);
  ~Progress() override { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void progress(std::string_view stage, std::size_t done, std::size_t total) override;
  void at_work(std::size_t elements, int pass) override;
  bool is_cancelled() override { return caught_signal() != 0; }

  /// A run with a sag makes several meshes.
  void expect_passes();

  /// Take the line away, before anything else is printed. Nothing is shown afterwards.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  void draw_until_cleared();
  void draw();
  void tell_stage();

  bool is_shown_;
  bool has_bar_;  ///< otherwise a line for each stage
  bool has_unicode_;
  Clock::time_point start_ = Clock::now();
  bool is_cleared_ = false;
  std::mutex mutex_;  ///< of the two below and of the one above
  std::condition_variable has_ended_;
  RunShare share_;
  std::thread drawer_;
};

}  // namespace surfmesh
