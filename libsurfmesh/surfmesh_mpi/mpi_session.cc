// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_mpi/mpi_session.hh"

#include <mpi.h>

#include <cstdlib>

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

void MpiSession::abort(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);  // which MPI has done already
}

}  // namespace surfmesh
