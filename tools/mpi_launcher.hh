// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surfmesh {

/// The processes that mpirun has started with this one, as Open MPI, MPICH and its kin tell them in
/// the environment; 0 if none of them has started it.
int processes_by_mpirun();

/// The number of this process among them, 0 if mpirun has not started it.
int rank_by_mpirun();

}  // namespace surfmesh
