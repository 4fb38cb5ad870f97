// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace surfmesh::detail {

/// Mean and variance in one pass, without the cancellation of Σx² − (Σx)²/n (Welford).
class Moments {
 public:
  /// Those of numbers of which only these are known.
  static Moments of(std::size_t count, double mean, double stddev) {
    Moments moments;
    moments.count_ = count;
    moments.mean_ = mean;
    moments.squares_ = static_cast<double>(count) * stddev * stddev;
    return moments;
  }

  void add(double x) {
    ++count_;
    const double before = x - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (x - mean_);
  }

  /// Add the numbers that another one has got.
  /// Source   Chan, Golub, LeVeque, Algorithms for computing the sample variance (1983)
  Moments& operator+=(const Moments& other) {
    if (other.count_ == 0) return *this;
    const auto own = static_cast<double>(count_), more = static_cast<double>(other.count_);
    const double step = other.mean_ - mean_;
    count_ += other.count_;
    mean_ += step * (more / (own + more));
    squares_ += other.squares_ + step * step * (own * more / (own + more));
    return *this;
  }

  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  double stddev() const {
    return count_ == 0 ? 0 : std::sqrt(squares_ / static_cast<double>(count_));
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

}  // namespace surfmesh::detail
