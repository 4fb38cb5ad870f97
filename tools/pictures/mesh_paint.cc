// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/mesh_paint.hh"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <map>

namespace surfmesh {
namespace {

/// Steps of a colour map in a picture: more, and each face of a vector picture has its own colour.
constexpr double kColourSteps = 160;

/// On large areas categories are drawn paler, so that edges and shades stay visible on them.
constexpr double kWhite = 0.42;

Rgb paler(const Rgb& colour) {
  const auto part = [](double value) { return value + kWhite * (1 - value); };
  return {part(colour.red), part(colour.green), part(colour.blue)};
}

Rgb step_colour(ColourMap map, double share) {
  return colour_at(map, std::round(kColourSteps * share) / kColourSteps);
}

std::string category_name(const MeshNames& names, MeshField field, std::size_t i) {
  const bool is_patch = field == MeshField::Patch;
  std::string name;
  if (is_patch && i < names.patches.size()) name = names.patches[i];
  if (!is_patch && i < names.groups.size()) name = names.groups[i].name;
  return name.empty() ? fmt::format("{} {}", is_patch ? "patch" : "group", i) : name;
}

bool is_of_quads(const PolyMesh& mesh) {
  std::size_t quads = 0;
  for (const FaceHandle fh : mesh.faces()) quads += mesh.valence(fh) == 4 ? 1 : 0;
  return 2 * quads > mesh.n_faces();
}

PaintedMesh paint_categories(const MeshNames& names, MeshField field,
                             const std::vector<double>& values, const std::vector<char>& shown) {
  PaintedMesh result{.paint = {}, .key = {std::string(describe(field).name)}};
  std::map<std::size_t, Rgb> used;
  bool has_nameless = false;
  for (std::size_t f = 0; f < values.size(); ++f) {
    const bool is_known = values[f] >= 0;
    const auto i = static_cast<std::size_t>(is_known ? values[f] : 0);
    const Rgb colour = is_known ? paler(category_colour(i)) : kNoValueColour;
    result.paint.colours.push_back(colour);
    if (shown[f] == 0) continue;
    if (is_known) used.emplace(i, colour);
    has_nameless = has_nameless || !is_known;
  }
  for (const auto& [i, colour] : used) {
    result.key.names.emplace_back(category_name(names, field, i), colour);
  }
  if (has_nameless) result.key.names.emplace_back("none", kNoValueColour);
  return result;
}

}  // namespace

PaintedMesh paint_mesh(const PolyMesh& mesh, const MeshNames& names, std::optional<MeshField> field,
                       const std::vector<char>& shown, const Rgb& plain) {
  if (!field) return {{std::vector<Rgb>(mesh.n_faces(), plain)}, {}};
  const FieldDescription& description = describe(*field);
  const std::vector<double> values = measure_field(mesh, names, *field);
  if (description.is_category) return paint_categories(names, *field, values, shown);
  const bool is_of_vertices = description.of == FieldOf::Vertices;
  std::vector<double> scaled;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_of_vertices || shown[i] != 0) scaled.push_back(values[i]);
  }
  const ColourScale scale = scale_of(*field, scaled, is_of_quads(mesh));
  PaintedMesh result{{{}, is_of_vertices}, {std::string(description.text), scale}};
  result.paint.colours.reserve(values.size());
  for (const double value : values) {
    result.paint.colours.push_back(std::isnan(value) ? kNoValueColour
                                                     : step_colour(scale.map, scale.share(value)));
  }
  return result;
}

}  // namespace surfmesh
