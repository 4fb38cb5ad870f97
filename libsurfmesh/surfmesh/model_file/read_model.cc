// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_model.hh"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "surfmesh/core/error.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_surface.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/json_node.hh"
#include "surfmesh/model_file/model_values.hh"
#include "surfmesh/model_file/read_nurbs.hh"
#include "surfmesh/model_file/read_parts.hh"
#include "surfmesh/model_file/read_sources.hh"

namespace surfmesh {
namespace {

Constants read_constants(const JsonNode& node) {
  Constants constants;
  for (const auto& [name, value] : node.members()) {
    const std::string_view fault = formula_name_fault(name);
    if (!fault.empty()) value.fail(fmt::format("this {}", fault));
    constants[name] = number_or_expression(value, constants);
  }
  return constants;
}

Domain read_domain(const JsonNode& node, const Constants& constants) {
  node.expect_keys({"u", "v"});
  Domain domain;
  std::tie(domain.u0, domain.u1) = read_range(node.at("u"), constants);
  std::tie(domain.v0, domain.v1) = read_range(node.at("v"), constants);
  return domain;
}

SurfaceFormulas read_formulas(const JsonNode& node, const Constants& constants) {
  node.expect_keys({"x", "y", "z", "where"});
  FormulaNode formula(node, {"u", "v"}, constants);
  SurfaceFormulas formulas;
  formulas.x = formula.text("x", formulas.x);
  formulas.y = formula.text("y", formulas.y);
  formulas.z = formula.text("z");
  formulas.where = formula.where();
  return formulas;
}

/// What is the same for all patches: constants, and the folder that files are relative to.
struct FileScope {
  Constants constants;
  std::filesystem::path folder;
};

/// Where the sources of the next patch are read.
PatchScope next_scope(const Domain& domain, const FileScope& file, const ModelFile& model) {
  return {static_cast<int>(model.patches.size()), domain, file.constants, file.folder};
}

/// A surface that is a whole patch, with its loops and sources.
void add_patch(const JsonNode& node, std::shared_ptr<const Surface> surface, const FileScope& file,
               ModelFile& model) {
  PatchInput patch{node.at("name").text(), std::move(surface), {}, node.pointer()};
  if (const auto loops = node.find("loops")) patch.loops = read_loops(*loops);
  if (const auto sources = node.find("sources")) {
    const PatchScope scope = next_scope(patch.surface->domain(), file, model);
    for (const JsonNode& source : sources->elements()) read_patch_source(source, scope, model);
  }
  model.patches.push_back(std::move(patch));
}

/// The pieces of a surface that is creased, with the sources of the whole patch.
void add_pieces(const JsonNode& node, const std::vector<NurbsPiece>& pieces, const Domain& whole,
                const FileScope& file, ModelFile& model) {
  if (node.has("loops")) {
    node.at("loops").fail(fmt::format(
        "a surface with creases inside cannot have loops: divide it at its knots into {} patches",
        pieces.size()));
  }
  DividedPatch divided{node.at("name").text(), {}};
  std::vector<PatchScope> scopes;
  for (const NurbsPiece& piece : pieces) {
    scopes.push_back(next_scope(piece.surface->domain(), file, model));
    divided.pieces.push_back(scopes.back().index);
    model.patches.push_back({piece_name(divided.name, piece), piece.surface, {}, node.pointer()});
  }
  if (const auto sources = node.find("sources")) {
    for (const JsonNode& source : sources->elements()) {
      read_divided_source(source, scopes, whole, model);
    }
  }
  model.divided.push_back(std::move(divided));
}

void read_nurbs_patch(const JsonNode& node, const FileScope& file, ModelFile& model) {
  const JsonNode surface = node.at("surface");
  surface.expect_keys({"nurbs"});
  const NurbsNet net = read_nurbs_net(surface.at("nurbs"), file.constants);
  const auto part = node.find("domain");
  const Domain domain = part ? read_domain(*part, file.constants) : knot_domain(net);
  const std::vector<NurbsPiece> pieces =
      at_node(part ? *part : surface, [&] { return split_at_creases(net, domain); });
  if (pieces.size() > 1) return add_pieces(node, pieces, domain, file, model);
  add_patch(node, pieces.front().surface, file, model);
}

void read_patch(const JsonNode& node, const FileScope& file, ModelFile& model) {
  node.expect_keys({"name", "surface", "domain", "sources", "loops"});
  read_name(node.at("name"));
  const JsonNode surface = node.at("surface");
  if (surface.has("nurbs")) return read_nurbs_patch(node, file, model);
  const SurfaceFormulas formulas = read_formulas(surface, file.constants);
  const Domain domain = read_domain(node.at("domain"), file.constants);
  add_patch(
      node,
      at_node(surface,
              [&] { return std::make_shared<FormulaSurface>(formulas, domain, file.constants); }),
      file, model);
}

/// The patches; there must be some if there are no cages.
void read_patches(const JsonNode& root, const FileScope& file, ModelFile& model) {
  const bool has_files = !model.cages.empty() || !model.cad.empty();
  if (has_files && !root.has("patches")) return;
  if (!root.has("patches")) root.fail("a model needs patches, cages or cad");
  const JsonNode patches = root.at("patches");
  for (const JsonNode& patch : patches.elements()) read_patch(patch, file, model);
  if (model.patches.empty() && !has_files) patches.fail("the model has no patches");
}

void read_options(const JsonNode& root, const char* key, ModelFile& model) {
  const auto node = root.find(key);
  if (!node) return;
  for (const auto& [name, value] : node->members()) {
    model.options.push_back(
        {name, value.json().dump(), key == std::string_view("sizing"), value.pointer()});
  }
}

/// Where the keys of model files belong; those that are known at a place are never looked up.
KeyPlaces places_of_keys(const KeyPlaces& options) {
  KeyPlaces places = options;
  for (const char* key :
       {"patches", "cages", "cad", "contours", "constants", "sizing", "options"}) {
    places[key] = "the model itself";
  }
  for (const char* key : {"surface", "domain", "loops"}) places[key] = "a patch";
  for (const char* key : {"file", "scheme", "creases"}) places[key] = "a cage";
  for (const char* key : {"range", "xyz", "on"}) places[key] = "a contour";
  for (const char* key : {"vertices", "sharpness"}) places[key] = "the creases of a cage";
  for (const char* key : {"everywhere", "at", "along", "inside", "field", "table", "background",
                          "values", "in", "reach", "radius", "outer", "angle"}) {
    places[key] = "sources";
  }
  for (const char* key : {"near", "group"}) places[key] = "the sources of the model";
  for (const char* key : {"box", "ball"}) places[key] = "the inside of a source of the model";
  for (const char* key : {"nurbs", "degree", "knots", "points", "weights", "periodic"}) {
    places[key] = "a surface, or the curve of a contour";
  }
  for (const char* key : {"x", "y", "z"}) places[key] = "a surface, or the xyz of a contour";
  return places;
}

}  // namespace

ModelFile parse_model(std::string_view text, const std::string& name, const KeyPlaces& options) {
  const Json json = parse_json(text, name);
  const KeyPlaces places = places_of_keys(options);
  const JsonNode root(json, name, "", &places);
  root.expect_keys({"$schema", "constants", "patches", "cages", "cad", "contours", "sources",
                    "sizing", "options"});
  ModelFile model;
  FileScope file{{}, std::filesystem::path(name).parent_path()};
  if (const auto node = root.find("constants")) file.constants = read_constants(*node);
  if (const auto node = root.find("cages")) model.cages = read_cages(*node, file.folder);
  if (const auto node = root.find("cad")) model.cad = read_cad_files(*node, file.folder);
  read_patches(root, file, model);
  if (const auto node = root.find("contours")) {
    model.contours = read_contours(*node, file.constants);
  }
  check_names(root, model);
  if (const auto node = root.find("sources")) {
    for (const JsonNode& source : node->elements()) {
      read_space_source(source, file.constants, file.folder, model);
    }
  }
  read_options(root, "sizing", model);
  read_options(root, "options", model);
  return model;
}

ModelFile read_model(const std::filesystem::path& path, const KeyPlaces& options) {
  return parse_model(read_file(path), path.string(), options);
}

}  // namespace surfmesh
