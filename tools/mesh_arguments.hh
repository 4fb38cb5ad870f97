// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "settings.hh"
#include "surfmesh/cage/cage.hh"
#include "verbosity.hh"

namespace surfmesh {

/// What runs the command.
enum class MeshProgram {
  OneProcess,  ///< surfmesh: a mesh in one place, or pieces
  Ranks,       ///< surfmesh-mpi: pieces, or a file of pieces
};

/// The command line of `mesh`.
struct MeshArguments {
  std::string input;
  std::string output;     ///< a file; empty for none
  std::string pieces;     ///< a folder; empty for none
  std::string report;     ///< empty for none
  int piece_count = 0;    ///< 0: see PiecesOptions
  int ranks = 0;          ///< of which a dry run tells, by default those set here; 0 for none
  bool by_metis = false;  ///< tiles are dealt out to pieces by METIS
  Settings named = {};    ///< by flags of their own
  Settings set = {};      ///< by --set, which beats them
  Scheme scheme = Scheme::Auto;
  bool is_quiet = false;
  bool is_verbose = false;
  bool is_dry_run = false;

  /// Add the subcommand and the options that it has there to a program. The object must outlive the
  /// parsing.
  void add_to(CLI::App& app, MeshProgram program = MeshProgram::OneProcess);

  /// All options, in the order of their effect.
  Settings settings() const;

  Verbosity verbosity() const { return {is_quiet, is_verbose}; }

 private:
  void add_files(CLI::App& command, MeshProgram program);
  void add_pieces(CLI::App& command, MeshProgram program);
  void check(const CLI::App& command) const;
};

}  // namespace surfmesh
