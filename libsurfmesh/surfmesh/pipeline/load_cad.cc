// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_cad.hh"

#include <fmt/format.h>

#include <numeric>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/model/append_model.hh"
#include "surfmesh/pipeline/at_file.hh"
#include "surfmesh/pipeline/file_options.hh"
#include "surfmesh/pipeline/refused_options.hh"

namespace surfmesh::detail {
namespace {

/// Read a CAD file with the reader of the options.
Model read_cad_file(const std::filesystem::path& path, const LoadOptions& options,
                    const CadOptions& cad) {
  if (!options.read_cad) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: STEP, IGES and BREP files are read by the module surfmesh_cad, "
                            "which is not in this build; tools/setup.sh --cad installs what it "
                            "needs, then configure and build again",
                            path.string()));
  }
  Model model = options.read_cad(path, cad);
  for (Patch& patch : model.patches) patch.origin = path.string();
  return model;
}

/// The model with one more group of all its patches, if it gets a name.
void add_whole_group(const std::string& name, Model& model) {
  if (name.empty()) return;
  Group whole{name, std::vector<int>(model.patches.size())};
  std::iota(whole.patches.begin(), whole.patches.end(), 0);
  model.groups.push_back(std::move(whole));
}

}  // namespace

ModelInput load_cad(const std::filesystem::path& path, const LoadOptions& options,
                    const RunContext& context) {
  if (options.joining) fail_joining(path.string());
  check_without_cages({}, path.string(), options.cages);
  ModelInput input;
  input.model = read_cad_file(path, options, options.cad);
  context.throw_if_cancelled();
  set_given(options, input.options);
  note_options(input.options, input.model);
  return input;
}

std::set<std::size_t> append_cad_files(const ModelFile& file, const std::string& name,
                                       const LoadOptions& given, const RunContext& context,
                                       ModelInput& result) {
  std::set<std::size_t> whole_files;
  for (const CadFileInput& input : file.cad) {
    if (input.name.empty() && !result.model.patches.empty()) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{}: {}: a CAD file beside patches or cages needs a name", name,
                              input.origin));
    }
    CadOptions options = given.cad;
    if (!options.sew) options.sew = input.sew;
    if (!options.sew) options.sew = result.options.sew;
    Model part;
    at_file(fmt::format("{}: {}/file", name, input.origin),
            [&] { part = read_cad_file(input.file, given, options); });
    context.throw_if_cancelled();
    add_whole_group(input.name, part);
    append(result.model, std::move(part), input.name.empty() ? "" : input.name + ":");
    if (!input.name.empty()) whole_files.insert(result.model.groups.size() - 1);
  }
  return whole_files;
}

}  // namespace surfmesh::detail
