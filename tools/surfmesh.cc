// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>

#include "command_line.hh"
#include "exit_status.hh"
#include "run_program.hh"
#include "signals.hh"
#include "standard_output.hh"

int main(int argc, char** argv) {
  surfmesh::keep_closed_streams_closed();
  surfmesh::take_errors_for_signals();
  try {
    surfmesh::CommandLine line;
    return surfmesh::run_program(line.app(), argc, argv, [&] { return line.run(); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh: error: %s\n", error.what());
    return surfmesh::kFailed;
  }
}
