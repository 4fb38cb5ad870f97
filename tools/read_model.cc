// SPDX-License-Identifier: BSD-3-Clause
#include "read_model.hh"

#include "mesh_command.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {

ReadModel read_model(const std::string& path, Scheme scheme, const Settings& settings,
                     Progress& progress) {
  progress.progress("read", 0, 1);
  ReadModel model{.input = load_model(path, load_options(scheme, settings), &progress)};
  PipelineOptions& options = model.input.options;
  model.given = options_of_file(options, model.input.model);
  for (const auto& [name, value] : settings) {
    set_option(options, name, value);
    add_given({name, value, OptionOrigin::CommandLine}, model.given);
  }
  throw_if_signalled();
  return model;
}

ControlSpaces make_control_spaces(const std::string& path, const ModelInput& input,
                                  Progress& progress) {
  ControlSpaces control;
  with_threads(input.options.threads, [&] {
    at_input(path, [&] {
      control = make_control_spaces(input.model, input.sources,
                                    resolve(input.options.sizing, input.model),
                                    input.options.control, RunContext(&progress));
    });
  });
  throw_if_signalled();
  return control;
}

}  // namespace surfmesh
