// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_mpi/mpi_session.hh"

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh_mpi/mpi_check.hh"

namespace surfmesh {

MpiSession::MpiSession(int& argc, char**& argv) {
  int provided = MPI_THREAD_SINGLE;
  detail::check_mpi(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided),
                    "MPI_Init_thread");
  if (provided >= MPI_THREAD_FUNNELED) return;
  MPI_Finalize();
  throw Error(ErrorCode::Io, "this MPI knows no threads (MPI_THREAD_FUNNELED)");
}

MpiSession::~MpiSession() { MPI_Finalize(); }

std::string MpiSession::library() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int size = 0;
  detail::check_mpi(MPI_Get_library_version(text.data(), &size), "MPI_Get_library_version");
  const std::string_view all(text.data(), static_cast<std::size_t>(size));
  return std::string(all.substr(0, all.find_first_of(",\n")));
}

void MpiSession::abort(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);  // which MPI has done already
}

}  // namespace surfmesh
