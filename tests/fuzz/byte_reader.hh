// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/targets.hh"

namespace surfmesh::fuzz {

/// Takes decisions from bytes, one after the other; when there are no more, they are all 0, which
/// should be the simplest of each.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : rest_(bytes) {}

  bool is_empty() const { return rest_.empty(); }

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }

  /// From 0 to `count` - 1.
  std::size_t below(std::size_t count) { return byte() % count; }

  /// True for the last `chances` values of a byte.
  bool happens(int chances) { return byte() >= 256 - chances; }

  /// One of the elements of a list.
  template <class List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }

  /// In steps of 1/255 from `from` to `to`: a change of a byte shows, and texts stay short.
  double real(double from, double to) { return from + (to - from) * byte() / 255.0; }

  /// All that is left.
  std::string rest() {
    std::string text(rest_.begin(), rest_.end());
    rest_ = {};
    return text;
  }

 private:
  Bytes rest_;
};

}  // namespace surfmesh::fuzz
