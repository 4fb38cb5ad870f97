// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// Cheap deterministic random bits (xorshift, Marsaglia 2003) for the order of edges in a walk.
class RandomBits {
 public:
  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }

 private:
  std::uint32_t state_ = 2463534242u;
};

}  // namespace surfmesh
