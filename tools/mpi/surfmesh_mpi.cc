// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "completion_command.hh"
#include "exit_status.hh"
#include "man_command.hh"
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
#ifdef SURFMESH_HAS_METIS
#include "surfmesh_metis/deal_by_metis.hh"
#endif

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  mpirun -n 64 surfmesh-mpi mesh wing.step --hmax 0.1% --pieces wing   to a folder of pieces\n"
    "  mpirun -n 4 surfmesh-mpi mesh wing.step --hmax 1% -o wing.obj        to one file\n"
    "Exit status as that of surfmesh.\n";

/// "surfmesh 1.2.3 with Open MPI v4.1.4 and METIS 5.1.0".
std::string version() {
  std::string text = "surfmesh " SURFMESH_VERSION " with " + surfmesh::MpiSession::library();
#ifdef SURFMESH_HAS_METIS
  text += " and METIS " + surfmesh::metis_version();
#endif
  return text;
}

/// The commands of the program.
class CommandLine {
 public:
  /// A dry run tells how `ranks` would share the work, unless others are asked about.
  explicit CommandLine(int ranks) {
    arguments_.ranks = ranks;
    app_.set_version_flag("--version", version());
    app_.footer(kFooter);
    app_.require_subcommand(1);
    arguments_.add_to(app_, surfmesh::MeshProgram::Ranks);
    completion_.add_to(app_);
    man_.add_to(app_);
  }

  CLI::App& app() { return app_; }

  /// Returns an exit status.
  int run(surfmesh::Exchange& exchange) const {
    if (!app_.got_subcommand("mesh")) return exchange.rank() == 0 ? describe() : surfmesh::kDone;
    if (arguments_.is_dry_run) return exchange.rank() == 0 ? estimate() : surfmesh::kDone;
    return surfmesh::mesh_in_pieces(arguments_, exchange, surfmesh::MpiSession::abort);
  }

 private:
  int describe() const { return app_.got_subcommand("man") ? man_.run() : completion_.run(); }

  int estimate() const { return surfmesh::MeshCommand(arguments_).run(); }

  CLI::App app_{"Mesh as surfmesh does, by the processes that mpirun starts.", "surfmesh-mpi"};
  surfmesh::MeshArguments arguments_;
  surfmesh::CompletionCommand completion_;
  surfmesh::ManCommand man_;
};

int run(int argc, char** argv) {
  surfmesh::MpiExchange exchange;
  if (exchange.rank() != 0) {
    surfmesh::be_silent(true);
    surfmesh::be_silent_on_signals();
  }
  CommandLine line(exchange.size());
  return surfmesh::run_program(line.app(), argc, argv, [&] { return line.run(exchange); });
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
