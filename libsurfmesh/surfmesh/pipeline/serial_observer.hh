// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string_view>

#include "surfmesh/core/observer.hh"

namespace surfmesh::detail {

/// Passes on what several threads tell and ask, one at a time. A run that is once cancelled stays
/// so.
class SerialObserver : public Observer {
 public:
  explicit SerialObserver(Observer& observer) : observer_(observer) {}

  void progress(std::string_view stage, std::size_t done, std::size_t total) override {
    const std::lock_guard lock(mutex_);
    observer_.progress(stage, done, total);
  }

  bool is_cancelled() override {
    const std::lock_guard lock(mutex_);
    is_cancelled_ = is_cancelled_ || observer_.is_cancelled();
    return is_cancelled_;
  }

  /// True if the run has been told that it is cancelled.
  bool has_cancelled() const { return is_cancelled_; }

 private:
  Observer& observer_;
  std::mutex mutex_;
  bool is_cancelled_ = false;
};

}  // namespace surfmesh::detail
