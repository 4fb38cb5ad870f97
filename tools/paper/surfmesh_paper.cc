// SPDX-License-Identifier: BSD-3-Clause
// Makes the tables and figures of the paper, section 5, from its three examples.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "exit_status.hh"
#include "paper/example_files.hh"
#include "paper/figures.hh"
#include "paper/laboratory.hh"
#include "pictures/machine.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/io/output_file.hh"

namespace {

using surfmesh::paper::Laboratory;
using surfmesh::paper::Table;

struct Arguments {
  std::filesystem::path folder;
  int rounds = 3;
  bool is_quiet = false;
};

constexpr const char* kFooter =
    "Writes the examples as model files (example1.json to example3.json), tables.md, tables.json,\n"
    "and figure1.svg, figure4.svg to figure10.svg. Takes about a minute on two cores.\n"
    "Exit status: 0 done; 1 not done, a line says why; 2 wrong usage\n";

std::string heading(const std::string& machine) {
  return fmt::format(
      "surfmesh {}, on one thread of {}. Ours first, the paper's in parentheses; its times are of "
      "a "
      "Pentium 4 with 2.7 GHz. Times are processor seconds, medians where a table of the paper has "
      "them.\n\n",
      SURFMESH_VERSION, machine);
}

void write_tables(const std::filesystem::path& folder, const std::vector<Table>& tables) {
  const surfmesh::Machine here = surfmesh::this_machine();
  const std::string machine =
      fmt::format("{}, {} cores, load {:.1f}", here.processor, here.cores, here.load_before);
  std::string text = heading(machine);
  for (const Table& table : tables) text += to_markdown(table) + "\n";
  surfmesh::write_file(folder / "tables.md", text);
  surfmesh::write_file(folder / "tables.json", to_json(tables, SURFMESH_VERSION, machine));
}

void make_pages(const Arguments& arguments) {
  std::filesystem::create_directories(arguments.folder);
  for (const surfmesh::paper::ExampleFile& file : surfmesh::paper::example_files()) {
    surfmesh::write_file(arguments.folder / file.name, file.text);
  }
  const auto tell = [&](const std::string& line) {
    if (!arguments.is_quiet) std::fprintf(stderr, "%s\n", line.c_str());
  };
  Laboratory laboratory(arguments.folder, arguments.rounds, tell);
  write_tables(arguments.folder, laboratory.tables());
  tell("figures");
  for (const surfmesh::paper::Figure& figure : draw_figures(laboratory)) {
    surfmesh::write_file(arguments.folder / figure.file, figure.svg);
  }
  tell(fmt::format("tables.md, tables.json and figures are in {}", arguments.folder.string()));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Make the tables and figures of the paper from its three examples.",
               "surfmesh-paper");
  app.set_version_flag("--version", "surfmesh-paper " SURFMESH_VERSION);
  app.footer(kFooter);
  app.add_option("-o,--output", arguments.folder, "folder to write to; made if it is missing")
      ->required();
  app.add_option("--rounds", arguments.rounds, "runs of which times are medians")
      ->check(CLI::Range(1, 99))
      ->capture_default_str();
  app.add_flag("--quiet", arguments.is_quiet, "no progress on standard error");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? surfmesh::kDone : surfmesh::kWrongUsage;
  }
  try {
    make_pages(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surfmesh-paper: error: %s\n", error.what());
    return surfmesh::kFailed;
  }
  return surfmesh::kDone;
}
