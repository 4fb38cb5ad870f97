// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include <limits>

#include "surfmesh/exchange/exchange.hh"

namespace surfmesh {

/// The ranks of a communicator of MPI, which must be running as long as this lives.
class MpiExchange final : public Exchange {
 public:
  /// Greatest number of bytes that all ranks together give in one call of MPI, which counts them as
  /// int. More go in several calls.
  static constexpr std::size_t kMostBytes = std::numeric_limits<int>::max();

  /// Called by all ranks of the communicator, of which a copy is used until MPI
  /// ends: to give it back earlier would wait for ranks that may have given up.
  /// Pre      `most_bytes` is from the number of ranks to kMostBytes
  /// Throws   Io with MPI's reason
  explicit MpiExchange(MPI_Comm communicator = MPI_COMM_WORLD, std::size_t most_bytes = kMostBytes);

  int rank() const override { return rank_; }
  int size() const override { return size_; }

 private:
  using Bytes = std::vector<std::byte>;

  std::vector<Bytes> gather(std::span<const std::byte> mine) override;
  void gather_part(std::span<const std::byte> mine, std::size_t first, std::size_t most,
                   const std::vector<std::uint64_t>& lengths, std::vector<Bytes>& all);

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  std::size_t most_bytes_;
};

}  // namespace surfmesh
