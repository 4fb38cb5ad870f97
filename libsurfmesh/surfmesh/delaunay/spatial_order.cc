// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/delaunay/spatial_order.hh"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "surfmesh/core/random_bits.hh"

namespace surfmesh {
namespace {

constexpr int kHilbertBits = 16;

/// Position along the Hilbert curve of a square of 2^bits × 2^bits cells.
std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, int bits) {
  std::uint32_t index = 0;
  for (std::uint32_t s = 1u << (bits - 1); s > 0; s >>= 1) {
    const std::uint32_t rx = (x & s) ? 1 : 0, ry = (y & s) ? 1 : 0;
    index = 4 * index + ((3 * rx) ^ ry);
    if (ry == 0) {
      if (rx == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

/// The bounding rectangle of points, cut into 2^bits × 2^bits cells along a Hilbert curve.
class HilbertCells {
 public:
  HilbertCells(std::span<const Uv> points, int bits) : bits_(bits) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Uv upper{-infinity, -infinity};
    lower_ = {infinity, infinity};
    for (const Uv p : points) {
      lower_ = {std::min(lower_.u, p.u), std::min(lower_.v, p.v)};
      upper = {std::max(upper.u, p.u), std::max(upper.v, p.v)};
    }
    const double count = (1 << bits) - 1;
    scale_ = {upper.u > lower_.u ? count / (upper.u - lower_.u) : 0,
              upper.v > lower_.v ? count / (upper.v - lower_.v) : 0};
  }

  std::uint32_t operator()(Uv p) const {
    return hilbert_index(static_cast<std::uint32_t>((p.u - lower_.u) * scale_.u),
                         static_cast<std::uint32_t>((p.v - lower_.v) * scale_.v), bits_);
  }

 private:
  int bits_;
  Uv lower_;
  Uv scale_;
};

/// A round takes seven eighths of what is left, 2^-3 stays for the rounds before: walks within a
/// long round stay in the cache. A million insertions take 425 ns each, with halves 530.
constexpr int kLogOfShareBefore = 3;

struct Key {
  std::uint64_t rank;  ///< round, then position along the curve
  int index;
};

/// Order points by a round told for each, then along the curve.
template <class Round>
std::vector<int> order_by_rounds(const std::vector<Uv>& points, Round next_round) {
  const HilbertCells cell(points, kHilbertBits);
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint64_t round = next_round();
    keys.push_back({round << 32 | cell(points[i]), static_cast<int>(i)});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.index < b.index;
  });
  std::vector<int> order;
  order.reserve(keys.size());
  for (const Key& key : keys) order.push_back(key.index);
  return order;
}

}  // namespace

std::vector<int> spatial_order(const std::vector<Uv>& points) {
  RandomBits random;
  return order_by_rounds(points, [&] {
    // Each leading zero of random bits is half as probable as one less.
    const int rounds_before_last = std::countl_zero(random.next() | 1u) / kLogOfShareBefore;
    return static_cast<std::uint64_t>(32 - rounds_before_last);
  });
}

std::vector<int> hilbert_order(const std::vector<Uv>& points) {
  return order_by_rounds(points, [] { return std::uint64_t{0}; });
}

std::vector<int> cell_order(std::span<const Uv> points) {
  // A sort by counting: 4^bits cells for up to 4^(bits + 1) points.
  const int bits = std::clamp((static_cast<int>(std::bit_width(points.size())) - 1) / 2, 1, 12);
  const HilbertCells cell_at(points, bits);
  std::vector<std::uint32_t> cells;
  cells.reserve(points.size());
  std::vector<int> next((std::size_t{1} << (2 * bits)) + 1, 0);
  for (const Uv p : points) {
    cells.push_back(cell_at(p));
    ++next[cells.back() + 1];
  }
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    order[static_cast<std::size_t>(next[cells[i]]++)] = static_cast<int>(i);
  }
  return order;
}

}  // namespace surfmesh
