// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_arguments.hh"

#include <fmt/format.h>

#include <array>
#include <map>

#include "surfmesh/formats/write_mesh.hh"

namespace surfmesh {
namespace {

constexpr const char* kMeshFooter =
    "Examples:\n"
    "  surfmesh mesh knob.obj -o knob.om --curvature 0.2 --hmax 5% --report knob.json\n";

constexpr const char* kMeshFooterOfRanks =
    "Examples:\n"
    "  mpirun -n 4 surfmesh-mpi mesh knob.obj --pieces knob --curvature 0.2 --report knob.json\n"
    "  mpirun -n 4 surfmesh-mpi mesh knob.obj -o knob.ply --curvature 0.2\n";

/// Numbers of pieces up to this one are taken: their files are in one folder.
constexpr int kMostPieces = 1'000'000;

/// Ranks of a dry run, likewise.
constexpr int kMostRanks = 1'000'000;

/// What deals tiles out to pieces, by the word for it.
std::map<std::string, bool> ways_to_deal() {
  std::map<std::string, bool> ways = {{"runs", false}};
#ifdef SURFMESH_HAS_METIS
  ways["metis"] = true;
#endif
  return ways;
}

/// A transformation as the parser takes it: the text becomes the value, or a fault is returned.
std::string to_way(std::string& text) {
  std::string words;
  for (const auto& [word, value] : ways_to_deal()) {
    if (text == word) {
      text = value ? "true" : "false";
      return {};
    }
    words += (words.empty() ? "" : " or ") + word;
  }
  return fmt::format("{} is not {}", text, words);
}

/// Have the options that count where ranks share the work.
void suit_ranks(CLI::App& command) {
  // What is hidden is known by its address, which another option may get.
  show_in_short_help(command, command.get_option("--across"));
  command.remove_option(command.get_option("--across"));
  hide_in_short_help(command, command.get_option("--normals"));
  show_in_short_help(command, command.get_option("--tile"));
}

}  // namespace

void MeshArguments::add_to(CLI::App& app, MeshProgram program) {
  CLI::App* command = app.add_subcommand(
      "mesh", "Mesh a cage, a CAD file or a model file with triangles or quads.");
  command->footer(program == MeshProgram::Ranks ? kMeshFooterOfRanks : kMeshFooter);
  add_files(*command, program);
  using enum OptionGroup;
  add_flags(*command, named, std::array{Sizes, ControlSpace, Meshing, Cages});
  if (program == MeshProgram::Ranks) suit_ranks(*command);
  add_pieces(*command, program);
  add_scheme(*command, scheme);
  add_set(*command, set, "set any option by its name; beats the other flags and the model file");
}

void MeshArguments::add_files(CLI::App& command, MeshProgram program) {
  command
      .add_option("INPUT", input,
                  "cage: .obj .off .ply .stl .om; CAD: .step .igs .brep; model: .json")
      ->required()
      ->type_name("");
  command
      .add_option("-o,--output", output,
                  program == MeshProgram::Ranks
                      ? "mesh to write, of all pieces: .obj .ply"
                      : fmt::format("mesh to write: {}; .om keeps everything", mesh_endings()))
      ->type_name("FILE");
  command.add_flag("--dry-run", is_dry_run, "estimate the number of elements; needs no --output");
  command.parse_complete_callback([this, &command] { check(command); });
  command.add_option("--report", report, "write the report as JSON")->type_name("FILE.json");
  command.add_flag("--quiet", is_quiet, "print warnings and errors only");
  add_verbose(command, is_verbose, "print all tables, and every warning");
}

void MeshArguments::add_pieces(CLI::App& command, MeshProgram program) {
  CLI::Option* folder = command.add_option(
      "--pieces", pieces, "write pieces that are never in one place: .pvtu and .vtu");
  folder->type_name("FOLDER");
  if (program == MeshProgram::OneProcess) hide_in_short_help(command, folder);
  hide_in_short_help(command,
                     command
                         .add_option("--ranks", ranks,
                                     "with --dry-run: tell how so many ranks would share the work")
                         ->type_name("N")
                         ->check(CLI::Range(1, kMostRanks).description("")));
  hide_in_short_help(command, command
                                  .add_option("--piece-count", piece_count,
                                              "number of pieces; else one a rank, or by size")
                                  ->type_name("N")
                                  ->check(CLI::Range(1, kMostPieces).description("")));
  hide_in_short_help(
      command,
      command.add_option("--deal", by_metis, "tiles to pieces in runs, or for few shared vertices")
          ->transform(CLI::Validator(to_way, ""))
          ->type_name(ways_to_deal().size() > 1 ? "runs|metis" : "runs")
          ->default_str("runs"));
}

/// The parser could check this itself, but would tell of it in the help, at length.
void MeshArguments::check(const CLI::App& command) const {
  if (output.empty() && pieces.empty() && !is_dry_run) throw CLI::RequiredError("--output");
  for (const char* other : {"--output", "--dry-run"}) {
    if (!pieces.empty() && command.count(other) > 0) throw CLI::ExcludesError("--pieces", other);
  }
  if (command.count("--ranks") > 0 && !is_dry_run) {
    throw CLI::RequiresError("--ranks", "--dry-run");
  }
  const bool has_pieces = !pieces.empty() || (is_dry_run && ranks > 0);
  for (const char* more : {"--piece-count", "--deal"}) {
    if (!has_pieces && command.count(more) > 0) {
      throw CLI::RequiresError(more, is_dry_run ? "--ranks" : "--pieces");
    }
  }
}

Settings MeshArguments::settings() const {
  Settings all = named;
  all.insert(all.end(), set.begin(), set.end());
  return all;
}

}  // namespace surfmesh
