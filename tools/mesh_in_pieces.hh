// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "mesh_arguments.hh"
#include "surfmesh/exchange/exchange.hh"
#include "surfmesh/pipeline/mesh_pieces.hh"

namespace surfmesh {

/// What --piece-count and --deal say.
PiecesOptions pieces_options(const MeshArguments& arguments);

/// `surfmesh mesh` where no rank has the whole mesh: to a folder of pieces, or to a file of a
/// format that can be written in pieces.
///
/// All ranks call this with the same arguments; rank 0 speaks. Errors that all ranks know of end it
/// on all of them. For others `abort_all(status)` is called once everything is cleaned up, for
/// ranks may wait for this one; it need not return. Returns  an exit status
int mesh_in_pieces(const MeshArguments& arguments, Exchange& exchange,
                   const std::function<void(int)>& abort_all = {});

}  // namespace surfmesh
