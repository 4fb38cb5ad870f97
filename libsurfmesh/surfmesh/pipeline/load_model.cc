// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_model.hh"

#include <fmt/format.h>

#include <new>
#include <string>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/out_of_memory.hh"
#include "surfmesh/core/run_context.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/mesh_format.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/model_file/read_model.hh"
#include "surfmesh/pipeline/along_sources.hh"
#include "surfmesh/pipeline/at_file.hh"
#include "surfmesh/pipeline/file_options.hh"
#include "surfmesh/pipeline/load_cad.hh"
#include "surfmesh/pipeline/load_cages.hh"
#include "surfmesh/pipeline/refused_options.hh"
#include "surfmesh/pipeline/space_sources.hh"

namespace surfmesh {
namespace {

ModelInput load_model_file(const std::filesystem::path& path, const LoadOptions& given,
                           const RunContext& context) {
  const std::string name = path.string();
  const ModelFile file = read_model(path, detail::places_of_options());
  ModelInput input;
  input.options = detail::file_options(file, name);
  if (file.cages.empty()) detail::check_without_cages(file, name, given.cages);
  detail::set_given(given, input.options);
  if (file.patches.empty() && input.options.joining) detail::fail_joining(name);
  if (file.cad.empty() && input.options.sew) detail::fail_sew(name);
  if (!file.patches.empty()) {
    const JoinOptions join{input.options.joining.value_or(JoinOptions().joining)};
    detail::at_file(name,
                    [&] { input.model = model_from_patches(file.patches, file.contours, join); });
    for (Notice& notice : input.model.notices) locate(name, notice);
    for (Patch& patch : input.model.patches) patch.origin = name + ": " + patch.origin;
    for (const DividedPatch& divided : file.divided) {
      input.model.groups.push_back({divided.name, divided.pieces});
    }
  }
  auto whole_files = detail::append_cages(file, name, given.cages, context, input);
  whole_files.merge(detail::append_cad_files(file, name, given, context, input));
  detail::note_options(input.options, input.model);
  input.sources = file.sources;
  for (const CageInput& cage : file.cages) input.files.push_back(cage.file);
  for (const CadFileInput& cad : file.cad) input.files.push_back(cad.file);
  input.files.insert(input.files.end(), file.tables.begin(), file.tables.end());
  detail::add_space_sources(file, name, whole_files, input);
  detail::add_along_sources(file, name, input);
  return input;
}

bool is_mesh(const std::filesystem::path& path) { return find_format(path) != nullptr; }

/// By the ending, see load_model.
ModelInput load(const std::filesystem::path& path, const LoadOptions& options,
                const RunContext& context) {
  if (has_cage_ending(path)) return detail::load_cage(path, options, context);
  if (has_cad_ending(path)) return detail::load_cad(path, options, context);
  if (lower_case_ending(path) != ".json") {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: {}the ending of a cage is {}, that of a CAD file .step, .stp, "
                            ".iges, .igs or .brep, that of a model file .json",
                            path.string(), is_mesh(path) ? "this is a mesh, no model; " : "",
                            cage_endings()));
  }
  return load_model_file(path, options, context);
}

}  // namespace

ModelInput load_model(const std::filesystem::path& path, const LoadOptions& options,
                      Observer* observer) try {
  const RunContext context(observer);
  ModelInput input = load(path, options, context);
  context.throw_if_cancelled();
  detail::at_file(path.string(), [&] { check(input.model); });
  input.files.insert(input.files.begin(), path);
  return input;
} catch (const std::bad_alloc&) {
  fail_without_memory("while reading " + path.string());
}

}  // namespace surfmesh
