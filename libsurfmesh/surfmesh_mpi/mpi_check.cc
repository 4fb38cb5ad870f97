// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_mpi/mpi_check.hh"

#include <fmt/format.h>
#include <mpi.h>

#include <array>
#include <string>

#include "surfmesh/core/error.hh"

namespace surfmesh::detail {

void check_mpi(int code, std::string_view function) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text;
  int size = 0;
  MPI_Error_string(code, text.data(), &size);
  throw Error(ErrorCode::Io,
              fmt::format("{}: {}", function,
                          std::string_view(text.data(), static_cast<std::size_t>(size))));
}

}  // namespace surfmesh::detail
