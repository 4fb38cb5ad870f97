// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
#include "surfmesh/model_file/read_parts.hh"
#include "surfmesh/model_file/read_sources.hh"

namespace surfmesh {
namespace {

double read_at_least(const JsonNode& node, double least) {
  const double value = node.number();
  if (!(value >= least)) node.fail(fmt::format("must be at least {}", least));
  return value;
}

bool is_name(std::string_view text) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
  });
}

Constants read_constants(const JsonNode& node) {
  constexpr std::array<std::string_view, 5> taken = {"pi", "e", "u", "v", "t"};
  Constants constants;
  for (const auto& [name, value] : node.members()) {
    if (!is_name(name)) value.fail("the name of a constant has letters, digits and _ only");
    if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
      value.fail("this name is not to be redefined");
    }
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

SurfaceFormulas read_formulas(const JsonNode& node) {
  node.expect_keys({"x", "y", "z"});
  SurfaceFormulas formulas;
  if (const auto x = node.find("x")) formulas.x = x->text();
  if (const auto y = node.find("y")) formulas.y = y->text();
  formulas.z = node.at("z").text();
  return formulas;
}

std::shared_ptr<const Surface> make_surface(const JsonNode& node, const SurfaceFormulas& formulas,
                                            const Domain& domain, const Constants& constants) {
  try {
    return std::make_shared<FormulaSurface>(formulas, domain, constants);
  } catch (const Error& error) {
    node.fail(error.what());
  }
}

/// What is the same for all patches: constants, and the folder that files are relative to.
struct FileScope {
  Constants constants;
  std::filesystem::path folder;
};

void read_patch(const JsonNode& node, const FileScope& file, ModelFile& model) {
  const Constants& constants = file.constants;
  node.expect_keys({"name", "surface", "domain", "sources", "loops"});
  PatchInput patch;
  patch.name = read_name(node.at("name"));
  for (const PatchInput& other : model.patches) {
    if (other.name == patch.name) {
      node.at("name").fail(fmt::format("there are two patches with the name {}", patch.name));
    }
  }
  const JsonNode surface = node.at("surface");
  const SurfaceFormulas formulas = read_formulas(surface);
  const Domain domain = read_domain(node.at("domain"), constants);
  patch.surface = make_surface(surface, formulas, domain, constants);
  if (const auto loops = node.find("loops")) patch.loops = read_loops(*loops);
  patch.origin = node.pointer();
  if (const auto sources = node.find("sources")) {
    const PatchScope scope = {static_cast<int>(model.patches.size()), domain, constants,
                              file.folder};
    for (const JsonNode& source : sources->elements()) read_patch_source(source, scope, model);
  }
  model.patches.push_back(std::move(patch));
}

/// The patches; there must be some if there are no cages.
void read_patches(const JsonNode& root, const FileScope& file, ModelFile& model) {
  if (!model.cages.empty() && !root.has("patches")) return;
  const JsonNode patches = root.at("patches");
  for (const JsonNode& patch : patches.elements()) read_patch(patch, file, model);
  if (model.patches.empty() && model.cages.empty()) patches.fail("the model has no patches");
}

/// None where it is off.
std::optional<Length> read_sag(const JsonNode& node) {
  const Json& json = node.json();
  if (json.is_null() || json == 0 || json == "off") return std::nullopt;
  return read_length(node);
}

Sizing read_sizing(const JsonNode& node) {
  node.expect_keys({"curvature", "sag", "hmin", "hmax", "stretch", "grade", "contour_curvature",
                    "proximity", "features", "curvature_from"});
  Sizing sizing;
  if (const auto curvature = node.find("curvature")) {
    sizing.curvature = read_at_least(*curvature, 0);
  }
  if (const auto hmin = node.find("hmin")) sizing.hmin = read_length(*hmin);
  if (const auto hmax = node.find("hmax")) sizing.hmax = read_length(*hmax);
  if (const auto stretch = node.find("stretch")) sizing.stretch = read_at_least(*stretch, 1);
  if (const auto grade = node.find("grade")) {
    sizing.grade = grade->number();
    if (sizing.grade != 0 && !(sizing.grade >= 1)) grade->fail("must be 0 (off), or at least 1");
  }
  if (sizing.hmin.is_relative == sizing.hmax.is_relative && sizing.hmin.value > sizing.hmax.value) {
    (node.has("hmax") ? node.at("hmax") : node.at("hmin")).fail("hmin must not be above hmax");
  }
  if (const auto sag = node.find("sag")) sizing.sag = read_sag(*sag);
  if (const auto proximity = node.find("proximity")) {
    sizing.proximity = read_at_least(*proximity, 0);
  }
  if (const auto flag = node.find("contour_curvature")) sizing.contour_curvature = flag->boolean();
  if (const auto flag = node.find("features")) sizing.features = flag->boolean();
  if (const auto from = node.find("curvature_from")) {
    const std::string text = from->text();
    if (text != "exact" && text != "differences") from->fail("must be exact or differences");
    if (text == "differences") sizing.curvature_from = CurvatureFrom::Differences;
  }
  return sizing;
}

}  // namespace

ModelFile parse_model(std::string_view text, const std::string& name) {
  const Json json = parse_json(text, name);
  const JsonNode root(json, name);
  root.expect_keys(
      {"$schema", "constants", "patches", "cages", "contours", "sources", "sizing", "options"});
  ModelFile model;
  FileScope file{{}, std::filesystem::path(name).parent_path()};
  if (const auto node = root.find("constants")) file.constants = read_constants(*node);
  if (const auto node = root.find("cages")) model.cages = read_cages(*node, file.folder);
  read_patches(root, file, model);
  if (const auto node = root.find("contours")) {
    model.contours = read_contours(*node, file.constants);
  }
  check_names(root, model);
  if (const auto node = root.find("sources")) {
    for (const JsonNode& source : node->elements()) {
      read_space_source(source, file.constants, model);
    }
  }
  if (const auto node = root.find("sizing")) model.sizing = read_sizing(*node);
  if (const auto node = root.find("options")) {
    for (const auto& [key, value] : node->members()) {
      model.options.emplace_back(key, value.json().dump());
    }
  }
  return model;
}

ModelFile read_model(const std::filesystem::path& path) {
  return parse_model(read_file(path), path.string());
}

}  // namespace surfmesh
