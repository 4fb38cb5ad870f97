// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace surfmesh::detail {

/// Turn what a function of MPI returns into an Error.
/// Throws   Io with the name of the function and MPI's text, unless `code` is success
void check_mpi(int code, std::string_view function);

}  // namespace surfmesh::detail
