// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <limits>
#include <mutex>
#include <string_view>

#include "surfmesh/core/observer.hh"

namespace surfmesh {

/// Steps of a loop (insertions, vertices) between two questions whether it is cancelled: some
/// milliseconds.
inline constexpr std::size_t kStepsBetweenCancellation = 4096;

/// Likewise of steps that search surfaces, with some hundred evaluations each.
inline constexpr std::size_t kSearchesBetweenCancellation = 64;

/// What a run makes.
enum class ElementKind { Triangles, Quads };

/// "triangles", "quads".
std::string_view name(ElementKind kind);

/// Unit elements of a kind for each unit triangle that fits into the same area.
double elements_per_triangle(ElementKind kind);

/// What the stages of a run share: who is told of its progress, whether it has been cancelled, and
/// how many elements it may still make.
///
/// Several threads may use it at once; the observer is called by one of them at a time. A run that
/// is once cancelled stays so.
class RunContext {
 public:
  /// `observer` is not owned and may be null. Without bounds by default.
  explicit RunContext(Observer* observer = nullptr,
                      std::size_t max_elements = std::numeric_limits<std::size_t>::max(),
                      ElementKind kind = ElementKind::Triangles)
      : observer_(observer), max_elements_(max_elements), kind_(kind) {}

  RunContext(const RunContext&) = delete;
  RunContext& operator=(const RunContext&) = delete;

  /// Tell how far a stage is.
  /// Throws   Cancelled
  void tell(std::string_view stage, std::size_t done, std::size_t total) const;

  /// Ask the observer, and tell it a few times a second how much is made.
  /// Throws   Cancelled
  void throw_if_cancelled() const;

  /// True if the run has been cancelled so far, without asking the observer.
  bool was_cancelled() const { return was_cancelled_; }

  /// Elements that the whole run may make.
  std::size_t max_elements() const { return max_elements_; }

  ElementKind element_kind() const { return kind_; }

  /// Elements that a patch which is not finished may have. Each patch takes at least one, so
  /// whichever patches are finished, there is an error if, and only if, all together have too many.
  /// Throws   Limit if there is not even one
  std::size_t elements_left() const;

  /// Begin another mesh, which has no elements yet.
  void begin_mesh() const {
    elements_ = 0;
    unfinished_ = 0;
    ++pass_;
  }

  /// The elements of the patches that are finished.
  std::size_t elements() const { return elements_; }

  /// Count the elements of a finished patch.
  /// Throws   Limit if there are too many
  void add_elements(std::size_t count) const;

  /// Change the number of elements of patches that are not finished, which only the observer is
  /// told.
  void change_unfinished(std::ptrdiff_t more) const { unfinished_ += more; }

  /// Throws   Limit
  [[noreturn]] void throw_too_many_elements() const;

 private:
  using Clock = std::chrono::steady_clock;

  void tell_at_work() const;

  Observer* observer_;
  std::size_t max_elements_;
  ElementKind kind_;
  mutable std::mutex mutex_;          ///< of the observer
  mutable Clock::time_point told_{};  ///< when it was last told of elements; under the mutex
  mutable std::atomic<bool> was_cancelled_ = false;
  mutable std::atomic<std::size_t> elements_ = 0;       ///< of the patches that are finished
  mutable std::atomic<std::ptrdiff_t> unfinished_ = 0;  ///< elements of the others
  mutable std::atomic<int> pass_ = 0;                   ///< meshes begun
};

}  // namespace surfmesh
