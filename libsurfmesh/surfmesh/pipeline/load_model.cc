// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/formula_surface.hh"
#include "surfmesh/geometry/join_sides.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/read_cage.hh"
#include "surfmesh/io/read_model.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// Call `body`, and put the place in front of its errors.
template <class Body>
void at_place(const std::string& place, ErrorCode code, Body body) {
  try {
    body();
  } catch (const Error& error) {
    throw Error(code, fmt::format("{}: {}", place, error.what()));
  }
}

ModelInput load_cage(const std::filesystem::path& path, const CageOptions& cage_options) {
  const Cage cage = read_cage(path);
  ModelInput input;
  at_place(path.string(), ErrorCode::InvalidInput,
           [&] { input.model = model_from_cage(cage, cage_options); });
  std::vector<std::string>& warnings = input.model.warnings;
  warnings.insert(warnings.begin(), cage.warnings.begin(), cage.warnings.end());
  return input;
}

PatchInput make_patch(const PatchDescription& patch) {
  const auto& [x, y, z] = patch.formulas;
  return {patch.name, std::make_shared<FormulaSurface>(SurfaceFormulas{x, y, z}, patch.domain,
                                                       patch.constants)};
}

Model make_model(const ModelFile& file, const std::string& name) {
  std::vector<PatchInput> patches;
  for (std::size_t i = 0; i < file.patches.size(); ++i) {
    at_place(fmt::format("{}: /patches/{}/surface", name, i), ErrorCode::InvalidInput,
             [&] { patches.push_back(make_patch(file.patches[i])); });
  }
  Model model;
  at_place(name, ErrorCode::Geometry, [&] { model = model_from_patches(patches); });
  return model;
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
    at_place(fmt::format("{}: /options/{}", name, key), ErrorCode::InvalidInput,
             [&, k = key, v = value] { set_file_option(input.options, k, v); });
  }
  input.model = make_model(file, name);
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
