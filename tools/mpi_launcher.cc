// SPDX-License-Identifier: BSD-3-Clause
#include "mpi_launcher.hh"

#include <array>
#include <cstdlib>

namespace surfmesh {
namespace {

/// The first of these variables that is set, as a number; 0 if none is.
int number_in(const std::array<const char*, 2>& names) {
  for (const char* name : names) {
    if (const char* text = std::getenv(name)) return std::atoi(text);
  }
  return 0;
}

}  // namespace

int processes_by_mpirun() { return number_in({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}); }

int rank_by_mpirun() { return number_in({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}); }

}  // namespace surfmesh
