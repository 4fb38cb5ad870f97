// SPDX-License-Identifier: BSD-3-Clause
// Makes the tables and figures of the paper, section 5, from its three examples.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "exit_status.hh"
#include "paper/example_files.hh"
#include "paper/figures.hh"
#include "paper/laboratory.hh"
#include "pictures/machine.hh"
#include "surfmesh/core/error.hh"
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
    "and figure1.svg, figure4.svg to figure10.svg. Files of these names are replaced. Takes about\n"
    "half a minute.\n"
    "Exit status: 0 done; 1 not done, a line says why; 2 wrong usage\n";

std::string heading(const surfmesh::Machine& before) {
  return fmt::format(
      "surfmesh {}, {}, on one thread of {}, {} cores, load {:.1f} before and {:.1f} after. Ours "
      "first, the paper's in parentheses, whose times are those of a Pentium 4 with 2.7 GHz. Times "
      "are processor seconds: in tables 2 and 4, but for \"today\", medians of several runs, "
      "elsewhere of one.\n\n",
      SURFMESH_VERSION, before.day, before.processor, before.cores, before.load_before,
      surfmesh::load_now());
}

/// Files that are made together. They are opened before the work begins, so that a folder that
/// cannot be written to is told at once.
class Pages {
 public:
  explicit Pages(std::filesystem::path folder) : folder_(std::move(folder)) {
    for (const char* name : {"tables.md", "tables.json"}) open(name);
    for (const std::string& name : surfmesh::paper::figure_names()) open(name);
  }

  void write(const std::string& name, const std::string& text) { files_.at(name)->write(text); }

  void commit() {
    std::vector<surfmesh::OutputFile*> files;
    for (const auto& [name, file] : files_) files.push_back(file.get());
    surfmesh::OutputFile::commit_all(files);
  }

 private:
  void open(const std::string& name) {
    files_.emplace(name, std::make_unique<surfmesh::OutputFile>(folder_ / name));
  }

  std::filesystem::path folder_;
  std::map<std::string, std::unique_ptr<surfmesh::OutputFile>> files_;
};

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw surfmesh::Error(surfmesh::ErrorCode::Io, fmt::format("cannot make the folder '{}': {}",
                                                               folder.string(), error.message()));
  }
}

void make_pages(const Arguments& arguments) {
  const surfmesh::Machine machine = surfmesh::this_machine();
  make_folder(arguments.folder);
  for (const surfmesh::paper::ExampleFile& file : surfmesh::paper::example_files()) {
    surfmesh::write_file(arguments.folder / file.name, file.text);
  }
  Pages pages(arguments.folder);
  const auto tell = [&](const std::string& line) {
    if (!arguments.is_quiet) std::fprintf(stderr, "%s\n", line.c_str());
  };
  Laboratory laboratory(arguments.folder, arguments.rounds, tell);
  const std::vector<Table> tables = laboratory.tables();
  std::string text = heading(machine);
  for (const Table& table : tables) text += to_markdown(table) + "\n";
  pages.write("tables.md", text);
  pages.write("tables.json", to_json(tables, SURFMESH_VERSION, machine.processor));
  tell("figures");
  for (const surfmesh::paper::Figure& figure : draw_figures(laboratory)) {
    pages.write(figure.file, figure.svg);
  }
  pages.commit();
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
  app.add_option("--rounds", arguments.rounds, "runs, a whole number, of which times are medians")
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
