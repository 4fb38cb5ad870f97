// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <exception>
#include <string>
#include <utility>

#include "exit_status.hh"
#include "mesh_arguments.hh"
#include "mesh_command.hh"
#include "mesh_in_pieces.hh"
#include "run_program.hh"
#include "signals.hh"
#include "standard_output.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh_mpi/mpi_exchange.hh"
#include "surfmesh_mpi/mpi_session.hh"

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  mpirun -n 64 surfmesh-mpi mesh wing.step --hmax 0.1% --pieces wing   to a folder of pieces\n"
    "  mpirun -n 4 surfmesh-mpi mesh wing.step --hmax 1% -o wing.obj        to one file\n"
    "Exit status as that of surfmesh.\n";

/// Rank 0 alone tells how all of them would share the work, unless others are asked about.
int estimate(surfmesh::MeshArguments arguments, const surfmesh::Exchange& exchange) {
  if (exchange.rank() != 0) return surfmesh::kDone;
  if (arguments.ranks == 0) arguments.ranks = exchange.size();
  return surfmesh::MeshCommand(std::move(arguments)).run();
}

int run(int argc, char** argv) {
  surfmesh::MpiExchange exchange;
  if (exchange.rank() != 0) {
    surfmesh::be_silent(true);
    surfmesh::be_silent_on_signals();
  }
  CLI::App app("Mesh as surfmesh does, by the processes that mpirun starts.", "surfmesh-mpi");
  app.set_version_flag("--version", "surfmesh " SURFMESH_VERSION);
  app.footer(kFooter);
  app.require_subcommand(1);
  surfmesh::MeshArguments arguments;
  arguments.add_to(app, surfmesh::ShortHelp::MostUsed);
  return surfmesh::run_program(app, argc, argv, [&] {
    if (arguments.is_dry_run) return estimate(arguments, exchange);
    return surfmesh::mesh_in_pieces(arguments, exchange, surfmesh::MpiSession::abort);
  });
}

}  // namespace

int main(int argc, char** argv) {
  surfmesh::keep_closed_streams_closed();
  surfmesh::take_errors_for_signals();
  try {
    const surfmesh::MpiSession session(argc, argv);
    try {
      return run(argc, argv);
    } catch (const std::exception& error) {
      surfmesh::tell(std::string("surfmesh: error: ") + error.what() + "\n");
      surfmesh::MpiSession::abort(surfmesh::kFailed);
    }
  } catch (const surfmesh::Error& error) {  // there is no MPI
    surfmesh::tell(std::string("surfmesh: error: ") + error.what() + "\n");
    return surfmesh::kFailed;
  }
}
