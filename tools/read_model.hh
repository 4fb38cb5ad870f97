// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "progress.hh"
#include "settings.hh"
#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/given_options.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh {

/// A model with its options: those of the file, and those of the command line, which beat them.
struct ReadModel {
  ModelInput input = {};
  std::vector<GivenOption> given = {};
};

/// Read a model for a command.
/// Throws   what load_model and set_option throw; Cancelled after a signal
ReadModel read_model(const std::string& path, Scheme scheme, const Settings& settings,
                     Progress& progress);

/// Make the control spaces of a model, on as many threads as its options say.
/// Throws   what make_control_spaces throws, with the path in front; Cancelled after a signal
ControlSpaces make_control_spaces(const std::string& path, const ModelInput& input,
                                  Progress& progress);

}  // namespace surfmesh
