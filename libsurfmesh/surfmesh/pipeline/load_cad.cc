// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_cad.hh"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "surfmesh/core/error.hh"

namespace surfmesh::detail {

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

void add_whole_group(const std::string& name, Model& model) {
  if (name.empty()) return;
  Group whole{name, std::vector<int>(model.patches.size())};
  std::iota(whole.patches.begin(), whole.patches.end(), 0);
  model.groups.push_back(std::move(whole));
}

}  // namespace surfmesh::detail
