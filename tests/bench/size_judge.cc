// SPDX-License-Identifier: BSD-3-Clause
// Judges a mesh by the exact sizes of its model, graded on grids of their own: it shares nothing
// with the control space. Tells the edges in the exact metric, and how many triangles there are for
// each one that the sizes ask for.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/judge_mesh.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh::judge {
namespace {

struct Arguments {
  std::string model;
  std::string mesh;
  std::vector<std::string> settings;  ///< key=value
  JudgeOptions options;
  bool is_json = false;
};

void set_options(PipelineOptions& options, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == setting.npos) {
      throw Error(ErrorCode::InvalidOption, fmt::format("{} is not key=value", setting));
    }
    set_option(options, setting.substr(0, equals), setting.substr(equals + 1));
  }
}

Judgement judge(const Arguments& arguments) {
  PipelineOptions of_cage;
  set_options(of_cage, arguments.settings);
  ModelInput input = load_model(arguments.model, {.cages = {.patches = of_cage.patches}});
  set_options(input.options, arguments.settings);
  MeshFile file = read_mesh(arguments.mesh);
  return judge_mesh(file.mesh, input, arguments.options);
}

void print_json(const Arguments& arguments, const Judgement& j) {
  const nlohmann::ordered_json json = {
      {"model", arguments.model},
      {"mesh", arguments.mesh},
      {"triangles", j.triangles},
      {"ideal", j.ideal},
      {"coarse_ideal", j.coarse_ideal},
      {"settled", j.is_settled()},
      {"nodes", j.nodes},
      {"bounded", j.is_bounded},
      {"count_per_ideal", static_cast<double>(j.triangles) / j.ideal},
      {"mean", j.edges.mean},
      {"stddev", j.edges.stddev},
      {"min", j.edges.min},
      {"max", j.edges.max},
      {"unit_fraction", j.edges.unit_fraction}};
  fmt::print("{}\n", json.dump(2));
}

void print_line(const Arguments& arguments, const Judgement& j) {
  fmt::print(
      "{}: count/ideal {:.3f}, mean {:.3f}, sigma {:.3f}, unit {:.1f} %; {} triangles, ideal "
      "{:.0f} (coarse {:.0f}, ratio {:.3f}, {}), {} nodes{}\n",
      arguments.mesh, static_cast<double>(j.triangles) / j.ideal, j.edges.mean, j.edges.stddev,
      100 * j.edges.unit_fraction, j.triangles, j.ideal, j.coarse_ideal, j.coarse_ideal / j.ideal,
      j.is_settled() ? "settled" : "NOT settled", j.nodes,
      j.is_bounded ? " (bounded, see --max-nodes)" : "");
}

void add_to(CLI::App& app, Arguments& arguments) {
  app.add_option("MODEL", arguments.model, "cage or model file")->required();
  app.add_option("MESH", arguments.mesh, "an .om file of a mesh of it")->required();
  app.add_option("--nodes", arguments.options.nodes, "of the grid of each patch")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--max-nodes", arguments.options.most_nodes,
                 "of all grids together; about 150 bytes each")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--adaptive", arguments.options.is_adaptive,
               "refine the grids of patches whose counts have not settled");
  app.add_option("--set", arguments.settings, "key=value, as for the mesh")
      ->expected(1)
      ->take_all();
  app.add_flag("--json", arguments.is_json, "print JSON text");
}

}  // namespace
}  // namespace surfmesh::judge

int main(int argc, char** argv) {
  using namespace surfmesh::judge;
  Arguments arguments;
  CLI::App app("Judge a mesh by the exact sizes of its model, without a control space.");
  add_to(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    const Judgement result = judge(arguments);
    arguments.is_json ? print_json(arguments, result) : print_line(arguments, result);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "surfmesh_size_judge: error: {}\n", error.what());
    return 1;
  }
}
