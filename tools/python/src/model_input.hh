// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/pipeline/given_options.hh"
#include "surfmesh/pipeline/load_model.hh"

namespace surfmesh::python {

/// Options by name, with values as set_option reads them.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A model that is read or built, with what its file asks for. It does not change afterwards, so
/// that several threads may mesh it.
struct HeldInput {
  ModelInput input;
  std::string path;                ///< empty for a model that was built
  std::vector<GivenOption> given;  ///< by its file
  double read_seconds = 0;         ///< of processor time
};

/// What decides how a model is made.
/// Throws   InvalidOption for an unknown scheme, option or value
LoadOptions load_options(const Settings& settings, const std::string& scheme);

/// "auto", "catmark", "loop" or "bilinear".
/// Throws   InvalidOption
Scheme parse_scheme(const std::string& name);

}  // namespace surfmesh::python
