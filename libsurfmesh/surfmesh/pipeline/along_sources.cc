// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/along_sources.hh"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/divide_contours.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/pipeline/at_file.hh"

namespace surfmesh::detail {
namespace {

/// True for a name like "wing:u0". Contours of a named file have a colon, too.
bool is_side(const Model& model, const std::string& name) {
  return name.find(':') != std::string::npos && find_contour(model, name) < 0;
}

/// The uses of a side or a contour and its parts, by name, on one patch.
std::vector<std::shared_ptr<const Curve>> curves_on(const Model& model, const std::string& name,
                                                    int patch) {
  std::vector<std::shared_ptr<const Curve>> curves;
  const auto add = [&](const Contour& contour) {
    for (const ContourUse& use : contour.uses) {
      if (use.patch == patch) curves.push_back(use.curve);
    }
  };
  if (is_side(model, name)) {
    for (const LoopEntry& entry : side_uses(model, name)) add(model.contour(entry));
    return curves;
  }
  for (const Contour& contour : model.contours) {
    if (is_part_of(contour.name, name)) add(contour);
  }
  return curves;
}

/// The contours along which sizes are asked for stay in the mesh.
void name_contours(Model& model, const std::string& name) {
  if (is_side(model, name)) {
    for (const LoopEntry& entry : side_uses(model, name)) {
      model.contour(entry.contour).is_named = true;
    }
    return;
  }
  for (Contour& contour : model.contours) {
    if (is_part_of(contour.name, name)) contour.is_named = true;
  }
}

/// The patches in which a size along a contour may hold.
std::vector<int> patches_along(const AlongContour& along, const Model& model) {
  if (along.patch >= 0) return {along.patch};
  std::vector<int> all(model.patches.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

[[noreturn]] void fail_along(const AlongContour& along, const Model& model) {
  std::vector<std::string_view> names;
  for (const Contour& contour : model.contours) names.push_back(contour.name);
  const auto meant = nearest_word(along.contour, names);
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{} is no contour or side of {}{}", along.contour,
                          along.patch >= 0 ? "this patch" : "the model",
                          meant ? fmt::format(", did you mean {}?", *meant) : ""));
}

}  // namespace

void add_along_sources(const ModelFile& file, const std::string& name, ModelInput& input) {
  for (const AlongContour& along : file.along_contours) {
    at_file(fmt::format("{}: {}", name, along.origin), [&] {
      bool is_found = false;
      for (const int patch : patches_along(along, input.model)) {
        AlongSource source{patch, curves_on(input.model, along.contour, patch), along.wish,
                           fmt::format("{}: {}", name, along.origin)};
        if (source.curves.empty()) continue;
        is_found = true;
        input.sources.along.push_back(std::move(source));
      }
      if (!is_found) fail_along(along, input.model);
      name_contours(input.model, along.contour);
    });
  }
}

}  // namespace surfmesh::detail
