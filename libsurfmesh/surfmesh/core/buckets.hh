// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfmesh/core/parallel.hh"

namespace surfmesh {

/// The indices below a count dealt out by their keys, so that threads can look for equal ones among
/// them: those of equal keys are in one bucket, in growing order.
///
/// Cost     O(n), shared among threads; 4 bytes per index
class Buckets {
 public:
  static constexpr std::size_t kCount = 64;

  /// `keys` are spread evenly, as those of hash() are.
  explicit Buckets(const std::vector<std::uint64_t>& keys) : indices_(keys.size()) {
    const std::size_t pieces = (keys.size() + kPiece - 1) / kPiece;
    std::vector<std::array<std::size_t, kCount>> places(pieces);  // at first, counts
    share_indices(pieces, [&](std::size_t piece) {
      for_each(keys, piece, [&](std::size_t i) { ++places[piece][bucket_of(keys[i])]; });
    });
    std::size_t next = 0;
    for (std::size_t bucket = 0; bucket < kCount; ++bucket) {
      first_[bucket] = next;
      for (auto& of_piece : places) {
        const std::size_t count = of_piece[bucket];
        of_piece[bucket] = next;
        next += count;
      }
    }
    first_[kCount] = next;
    share_indices(pieces, [&](std::size_t piece) {
      for_each(keys, piece, [&](std::size_t i) {
        indices_[places[piece][bucket_of(keys[i])]++] = static_cast<std::uint32_t>(i);
      });
    });
  }

  std::span<const std::uint32_t> operator[](std::size_t bucket) const {
    return {indices_.data() + first_[bucket], first_[bucket + 1] - first_[bucket]};
  }

  static std::size_t bucket_of(std::uint64_t key) { return key >> 58; }

  /// A key of which all bits depend on all of those of `bits`.
  static std::uint64_t hash(std::uint64_t bits) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    bits *= odd;
    bits ^= bits >> 32;
    return bits * odd;
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 14;

  template <class Visit>
  static void for_each(const std::vector<std::uint64_t>& keys, std::size_t piece, Visit visit) {
    const std::size_t end = std::min(keys.size(), (piece + 1) * kPiece);
    for (std::size_t i = piece * kPiece; i < end; ++i) visit(i);
  }

  std::vector<std::uint32_t> indices_;
  std::array<std::size_t, kCount + 1> first_{};
};

}  // namespace surfmesh
