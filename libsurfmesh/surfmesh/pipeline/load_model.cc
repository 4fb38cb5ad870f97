// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/join_sides.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/read_cage.hh"
#include "surfmesh/io/read_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// Call `body`, and put the place in front of its errors. What is wrong with an option is so in
/// the file.
template <class Body>
void at_place(const std::string& place, Body body) {
  try {
    body();
  } catch (const Error& error) {
    const ErrorCode code =
        error.code() == ErrorCode::InvalidOption ? ErrorCode::InvalidInput : error.code();
    throw Error(code, fmt::format("{}: {}", place, error.what()));
  }
}

ModelInput load_cage(const std::filesystem::path& path, const CageOptions& cage_options) {
  const Cage cage = read_cage(path);
  ModelInput input;
  at_place(path.string(), [&] { input.model = model_from_cage(cage, cage_options); });
  std::vector<std::string>& warnings = input.model.warnings;
  warnings.insert(warnings.begin(), cage.warnings.begin(), cage.warnings.end());
  return input;
}

/// Set one entry of a file's `options`; its value is JSON text, null leaves the default.
void set_file_option(PipelineOptions& options, const std::string& key, const std::string& value) {
  const auto json = nlohmann::json::parse(value);
  if (is_sizing_option(key)) {
    throw Error(ErrorCode::InvalidInput, "its place is in sizing");
  }
  if (!json.is_null()) set_option(options, key, json.is_string() ? json.get<std::string>() : value);
}

ModelInput load_model_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  const ModelFile file = read_model(path);
  ModelInput input;
  input.options.sizing = file.sizing;
  for (const auto& [key, value] : file.options) {
    at_place(fmt::format("{}: /options/{}", name, key),
             [&, k = key, v = value] { set_file_option(input.options, k, v); });
  }
  at_place(name, [&] { input.model = model_from_patches(file.patches); });
  input.sources = file.sources;
  return input;
}

}  // namespace

ModelInput load_model(const std::filesystem::path& path, const CageOptions& cage_options) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".obj" || ending == ".off") return load_cage(path, cage_options);
  if (ending != ".json") {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: the ending of a cage is .obj or .off, that of a model file .json",
                            path.string()));
  }
  if (cage_options.scheme != Scheme::Auto) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: only cages have a subdivision scheme", path.string()));
  }
  return load_model_file(path);
}

}  // namespace surfmesh
