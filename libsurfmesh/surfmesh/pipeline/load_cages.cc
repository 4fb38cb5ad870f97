// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/load_cages.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/cage/creases.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/cage/weld_cage.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/length.hh"
#include "surfmesh/formats/read_cage.hh"
#include "surfmesh/model/append_model.hh"
#include "surfmesh/pipeline/at_file.hh"
#include "surfmesh/pipeline/file_options.hh"
#include "surfmesh/pipeline/refused_options.hh"

namespace surfmesh::detail {
namespace {

/// The model of a cage that a file holds.
Model model_of(const Cage& cage, const std::filesystem::path& path, const CageOptions& options) {
  Model model;
  at_file(path.string(), [&] { model = model_from_cage(cage, options); });
  for (Notice& notice : model.notices) locate(path.string(), notice);
  for (Patch& patch : model.patches) patch.origin = path.string();
  model.notices.insert(model.notices.begin(), cage.notices.begin(), cage.notices.end());
  return model;
}

/// What is asked for from outside comes first, then what a cage names itself, then what the file
/// has in its options.
CageOptions options_of(const CageInput& input, const CageOptions& given,
                       const PipelineOptions& of_file) {
  CageOptions options = given;
  if (options.scheme == Scheme::Auto) options.scheme = input.scheme;
  if (options.patches == PatchKind::Auto) options.patches = input.patches;
  if (options.patches == PatchKind::Auto) options.patches = of_file.patches;
  if (!options.weld) options.weld = input.weld;
  if (!options.weld) options.weld = of_file.weld;
  if (!options.orient) options.orient = input.orient;
  if (!options.orient) options.orient = of_file.orient;
  if (!options.crease_angle) options.crease_angle = input.crease_angle;
  if (!options.crease_angle) options.crease_angle = of_file.crease_angle;
  if (options.surface == SurfaceKind::Auto) options.surface = input.surface;
  if (options.surface == SurfaceKind::Auto) options.surface = of_file.surface;
  if (!options.fit) options.fit = input.fit;
  if (!options.fit) options.fit = of_file.fit;
  return options;
}

/// The cage with its vertices welded, which keep their numbers.
Cage welded(const Cage& cage, const std::optional<Length>& tolerance) {
  Cage result = cage;
  if (!tolerance || tolerance->value == 0) return result;
  check_option(ranges::kWeld, tolerance);
  weld(result, coincident_vertices(result, tolerance->in_units(diagonal(cage))));
  return result;
}

/// The whole cage has no border to make a crease of.
[[noreturn]] void fail_whole_cage(const Cage& cage, const std::string& name) {
  std::vector<std::string_view> groups;
  for (const Cage::FaceGroup& group : cage.groups) groups.push_back(group.name);
  throw Error(
      ErrorCode::InvalidInput,
      fmt::format("{} is the whole cage; a crease is the border of a group in its file, "
                  "which has {}",
                  name, groups.empty() ? "none" : fmt::format("{}", fmt::join(groups, ", "))));
}

/// Add a crease at the border of a group. Where vertices are welded, its edges are there only then.
void add_group_crease(const CageInput& input, const CreaseInput& crease,
                      const std::optional<Length>& tolerance, Cage& cage) {
  const auto is_meant = [&](const Cage::FaceGroup& group) { return group.name == crease.group; };
  const bool is_group = std::any_of(cage.groups.begin(), cage.groups.end(), is_meant);
  if (!is_group && crease.group == input.name) fail_whole_cage(cage, input.name);
  Cage joined = welded(cage, tolerance);
  add_crease_around(crease.group, crease.sharpness, joined);
  cage.creases = std::move(joined.creases);
}

/// Add the creases that a model file gives a cage.
void add_creases(const CageInput& input, const std::string& name,
                 const std::optional<Length>& tolerance, Cage& cage) {
  for (const CreaseInput& crease : input.creases) {
    at_file(fmt::format("{}: {}", name, crease.origin), [&] {
      if (crease.group.empty()) {
        add_crease(crease.vertices, crease.sharpness, cage);
      } else {
        add_group_crease(input, crease, tolerance, cage);
      }
    });
  }
}

}  // namespace

ModelInput load_cage(const std::filesystem::path& path, const LoadOptions& options,
                     const RunContext& context) {
  if (options.joining) fail_joining(path.string());
  if (options.cad.sew) fail_sew(path.string());
  const CageOptions& cages = options.cages;
  const Cage cage = read_cage(path);
  context.throw_if_cancelled();
  ModelInput input;
  input.model = model_of(cage, path, cages);
  set_given(options, input.options);
  return input;
}

std::set<std::size_t> append_cages(const ModelFile& file, const std::string& name,
                                   const CageOptions& given, const RunContext& context,
                                   ModelInput& result) {
  Model& model = result.model;
  std::set<std::size_t> whole_cages;
  for (const CageInput& input : file.cages) {
    const CageOptions options = options_of(input, given, result.options);
    const std::string location = fmt::format("{}: {}/file", name, input.origin);
    Cage cage;
    at_file(location, [&] { cage = read_cage(input.file); });
    context.throw_if_cancelled();
    add_creases(input, name, options.weld, cage);
    Model part;
    at_file(location, [&] { part = model_of(cage, input.file, options); });
    Group& whole = part.groups.emplace_back();
    whole.name = input.name;
    for (std::size_t p = 0; p < part.patches.size(); ++p)
      whole.patches.push_back(static_cast<int>(p));
    append(model, std::move(part), input.name + ":");
    whole_cages.insert(model.groups.size() - 1);
  }
  return whole_cages;
}

}  // namespace surfmesh::detail
