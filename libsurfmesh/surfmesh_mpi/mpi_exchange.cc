// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_mpi/mpi_exchange.hh"

#include <algorithm>

#include "surfmesh_mpi/mpi_check.hh"

namespace surfmesh {
namespace {

/// The part of `length` bytes that a call takes which begins at `first`.
std::size_t part_of(std::uint64_t length, std::size_t first, std::size_t most) {
  return length > first ? std::min<std::size_t>(length - first, most) : 0;
}

}  // namespace

MpiExchange::MpiExchange(MPI_Comm communicator, std::size_t most_bytes) : most_bytes_(most_bytes) {
  detail::check_mpi(MPI_Comm_dup(communicator, &communicator_), "MPI_Comm_dup");
  // Else MPI would end the program before it has removed its files.
  detail::check_mpi(MPI_Comm_set_errhandler(communicator_, MPI_ERRORS_RETURN),
                    "MPI_Comm_set_errhandler");
  detail::check_mpi(MPI_Comm_rank(communicator_, &rank_), "MPI_Comm_rank");
  detail::check_mpi(MPI_Comm_size(communicator_, &size_), "MPI_Comm_size");
}

std::vector<MpiExchange::Bytes> MpiExchange::gather(std::span<const std::byte> mine) {
  const std::uint64_t length = mine.size();
  std::vector<std::uint64_t> lengths(static_cast<std::size_t>(size_));
  detail::check_mpi(
      MPI_Allgather(&length, 1, MPI_UINT64_T, lengths.data(), 1, MPI_UINT64_T, communicator_),
      "MPI_Allgather");
  std::vector<Bytes> all(lengths.size());
  for (std::size_t rank = 0; rank < all.size(); ++rank) all[rank].reserve(lengths[rank]);
  const std::uint64_t longest = *std::max_element(lengths.begin(), lengths.end());
  const std::size_t most = most_bytes_ / lengths.size();
  for (std::size_t first = 0; first < longest; first += most) {
    gather_part(mine, first, most, lengths, all);
  }
  return all;
}

/// Append to the bytes of all ranks those from `first` on, at most `most` of each.
void MpiExchange::gather_part(std::span<const std::byte> mine, std::size_t first, std::size_t most,
                              const std::vector<std::uint64_t>& lengths, std::vector<Bytes>& all) {
  std::vector<int> counts, starts;
  int total = 0;
  for (const std::uint64_t length : lengths) {
    counts.push_back(static_cast<int>(part_of(length, first, most)));
    starts.push_back(total);
    total += counts.back();
  }
  Bytes part(static_cast<std::size_t>(total));
  const int count = counts[static_cast<std::size_t>(rank_)];
  detail::check_mpi(
      MPI_Allgatherv(count > 0 ? mine.data() + first : nullptr, count, MPI_BYTE, part.data(),
                     counts.data(), starts.data(), MPI_BYTE, communicator_),
      "MPI_Allgatherv");
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    const auto begin = part.begin() + starts[rank];
    all[rank].insert(all[rank].end(), begin, begin + counts[rank]);
  }
}

}  // namespace surfmesh
