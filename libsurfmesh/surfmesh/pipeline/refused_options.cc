// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/refused_options.hh"

#include <fmt/format.h>

#include <map>
#include <string_view>

#include "surfmesh/cage/interpolating_cage.hh"
#include "surfmesh/cage/mend_cage.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/model/cad_input.hh"
#include "surfmesh/pipeline/file_options.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh::detail {

void fail_joining(const std::string& name) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: only patches of formulas have sides to join; {} makes vertices of a "
                          "cage one",
                          name, ranges::kWeld.name));
}

void fail_sew(const std::string& name) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: only CAD files have edges to {}", name, ranges::kSew.name));
}

void check_without_cages(const ModelFile& file, const std::string& name, const CageOptions& given) {
  const auto fail = [](const std::string& location, const char* what) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: only cages have {}", location, what));
  };
  const std::map<std::string_view, const char*> options = {
      {ranges::kPatches.name, "faces, blocks or regions as patches"},
      {ranges::kWeld.name, "vertices to weld"},
      {ranges::kOrient.name, "faces to orient"},
      {ranges::kCreaseAngle.name, "creases by angle"},
      {ranges::kSurface.name, "a surface to choose"},
      {ranges::kFit.name, "points to fit a surface to"}};
  if (given.scheme != Scheme::Auto) fail(name, "a subdivision scheme");
  if (given.patches != PatchKind::Auto) fail(name, options.at(ranges::kPatches.name));
  if (given.weld && given.weld->value != 0) fail(name, options.at(ranges::kWeld.name));
  if (given.orient.value_or(false)) fail(name, options.at(ranges::kOrient.name));
  if (given.crease_angle.value_or(0) > 0) fail(name, options.at(ranges::kCreaseAngle.name));
  if (given.surface != SurfaceKind::Auto) fail(name, options.at(ranges::kSurface.name));
  if (given.fit && given.fit->value != 0) fail(name, options.at(ranges::kFit.name));
  for (const FileOption& entry : file.options) {
    const auto option = options.find(entry.name);
    if (option == options.end() || is_default(entry)) continue;
    fail(name + ": " + entry.origin, option->second);
  }
}

}  // namespace surfmesh::detail
