// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// How the ranks of a run, the processes that make one mesh together, hand each other what they
/// made. All of it goes through `all_gather`, so that the same code serves one process, many by
/// MPI, and threads in tests.
///
/// Every rank has to call the same functions in the same order. An object is used by one thread at
/// a time.
class Exchange {
 public:
  Exchange() = default;
  virtual ~Exchange() = default;
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;

  /// From 0 to size() - 1.
  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// Give bytes, of which each rank may have any number, and get those of all ranks.
  ///
  /// Returns  by rank
  /// Cost     memory for the bytes of all ranks
  /// Throws   Io if another rank cannot be reached
  std::vector<std::vector<std::byte>> all_gather(std::span<const std::byte> mine) {
    if (size() > 1) bytes_sent_ += static_cast<std::int64_t>(mine.size());
    return gather(mine);
  }

  /// Bytes that this rank has given so far; how often they travel is up to the implementation. 0 if
  /// it is the only one.
  std::int64_t bytes_sent() const { return bytes_sent_; }

 private:
  virtual std::vector<std::vector<std::byte>> gather(std::span<const std::byte> mine) = 0;

  std::int64_t bytes_sent_ = 0;
};

/// Gather values as they are in memory: all ranks run the same program on machines of one kind.
/// Returns  by rank
template <class Value>
std::vector<std::vector<Value>> gather_all(Exchange& exchange, std::span<const Value> mine) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::vector<std::vector<Value>> values;
  for (const std::vector<std::byte>& bytes : exchange.all_gather(std::as_bytes(mine))) {
    std::vector<Value>& of_rank = values.emplace_back(bytes.size() / sizeof(Value));
    if (!bytes.empty()) std::memcpy(of_rank.data(), bytes.data(), bytes.size());
  }
  return values;
}

/// Returns  by rank
template <class Value>
std::vector<std::vector<Value>> gather_all(Exchange& exchange, const std::vector<Value>& mine) {
  return gather_all(exchange, std::span<const Value>(mine));
}

/// Gather one value of each rank.
/// Returns  by rank
template <class Value>
std::vector<Value> gather_one(Exchange& exchange, const Value& mine) {
  std::vector<Value> values;
  for (const std::vector<Value>& of_rank : gather_all(exchange, std::span(&mine, 1))) {
    values.push_back(of_rank.front());
  }
  return values;
}

/// The text that rank 0 gives; those of others are not used.
inline std::string text_of_rank_0(Exchange& exchange, std::string_view mine) {
  if (exchange.rank() != 0) mine = {};
  const std::vector<char> text = gather_all(exchange, std::span<const char>(mine)).front();
  return {text.begin(), text.end()};
}

/// The sum over all ranks, added in their order. A sum of floating-point numbers depends on how
/// they are dealt to ranks: gather those that must not, and add them in an order of their own.
template <class Number>
Number sum_all(Exchange& exchange, Number mine) {
  Number sum{};
  for (const Number of_rank : gather_one(exchange, mine)) sum += of_rank;
  return sum;
}

/// Where the numbers of a rank begin, if those of rank 0 come first, then those of rank 1, ...
struct RankOffset {
  std::int64_t first = 0;  ///< how many all ranks before this one have
  std::int64_t total = 0;  ///< how many all have
};

/// The offset of this rank, which has `count` of them. Each rank calls it.
inline RankOffset offset_of_rank(Exchange& exchange, std::int64_t count) {
  RankOffset offset;
  const std::vector<std::int64_t> counts = gather_one(exchange, count);
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    if (static_cast<int>(rank) < exchange.rank()) offset.first += counts[rank];
    offset.total += counts[rank];
  }
  return offset;
}

}  // namespace surfmesh
