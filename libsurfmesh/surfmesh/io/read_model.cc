// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/read_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "surfmesh/control/parse_length.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/geometry/formula.hh"
#include "surfmesh/geometry/formula_surface.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/json_node_detail.hh"

namespace surfmesh {
namespace {

using Constants = std::map<std::string, double>;

/// Read a number, or a string with a constant expression.
double number_or_expression(const JsonNode& node, const Constants& constants) {
  if (!node.json().is_string()) return node.number();
  try {
    return evaluate_constant(node.text(), constants);
  } catch (const Error& error) {
    node.fail(error.what());
  }
}

Length read_length(const JsonNode& node) {
  Length length;
  if (node.json().is_string()) {
    try {
      length = parse_length(node.text());
    } catch (const Error& error) {
      node.fail(error.what());
    }
    if (!length.is_relative) node.fail("a length in model units is a number, without quotes");
  } else {
    length = {node.number(), false};
  }
  if (!(length.value > 0) || !std::isfinite(length.value)) node.fail("must be above 0");
  return length;
}

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

/// The two bounds of one parameter.
std::pair<double, double> read_range(const JsonNode& node, const Constants& constants) {
  const std::vector<JsonNode> bounds = node.elements(2);
  const double from = number_or_expression(bounds[0], constants);
  const double to = number_or_expression(bounds[1], constants);
  if (!std::isfinite(from)) bounds[0].fail("must be finite");
  if (!std::isfinite(to)) bounds[1].fail("must be finite");
  if (!(from < to)) node.fail("the second value must be larger than the first");
  return {from, to};
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

Size read_size(const JsonNode& source) {
  const JsonNode node = source.at("size");
  Size size;
  if (node.json().is_array()) {
    const std::vector<JsonNode> lengths = node.elements(2);
    size.along = read_length(lengths[0]);
    size.across = read_length(lengths[1]);
  } else {
    size.along = size.across = read_length(node);
  }
  if (const auto angle = source.find("angle")) {
    size.angle = angle->number() * std::numbers::pi / 180;
  }
  return size;
}

/// The patch that a source belongs to.
struct PatchScope {
  int index;
  const Domain& domain;
  const Constants& constants;
};

Uv read_place(const JsonNode& node, const PatchScope& patch) {
  const std::vector<JsonNode> values = node.elements(2);
  const Uv uv = {number_or_expression(values[0], patch.constants),
                 number_or_expression(values[1], patch.constants)};
  const Domain& domain = patch.domain;
  if (!(uv.u >= domain.u0 && uv.u <= domain.u1 && uv.v >= domain.v0 && uv.v <= domain.v1)) {
    node.fail("this point is outside of the domain");
  }
  return uv;
}

/// The one key that tells what a source is.
std::string kind_of(const JsonNode& source) {
  std::string kind;
  for (const char* key : {"everywhere", "at", "along", "inside", "field", "table"}) {
    if (!source.has(key)) continue;
    if (!kind.empty()) source.fail(fmt::format("a source cannot have both {} and {}", kind, key));
    kind = key;
  }
  if (kind.empty()) {
    source.fail("a source needs one of everywhere, at, along, inside, field, table");
  }
  return kind;
}

void read_source(const JsonNode& node, const PatchScope& patch, Sources& sources) {
  node.expect_keys({"everywhere", "at", "along", "inside", "field", "table", "size", "angle",
                    "radius", "outer", "precision"});
  const std::string kind = kind_of(node);
  if (kind != "everywhere" && kind != "at") node.at(kind).fail("this key is not built yet");
  if (const auto radius = node.find("radius")) radius->expect_off({0});
  if (const auto outer = node.find("outer")) outer->expect_off({});
  if (const auto precision = node.find("precision")) precision->expect_off({0.1});
  if (kind == "at") {
    sources.at.push_back({patch.index, read_place(node.at("at"), patch), read_size(node)});
  } else {
    if (!node.at("everywhere").boolean()) node.at("everywhere").fail("must be true");
    sources.everywhere.push_back({patch.index, read_size(node)});
  }
}

void read_patch(const JsonNode& node, const Constants& constants, ModelFile& model) {
  node.expect_keys({"name", "surface", "domain", "sources", "loops"});
  PatchInput patch;
  patch.name = node.at("name").text();
  if (patch.name.empty()) node.at("name").fail("must not be empty");
  for (const PatchInput& other : model.patches) {
    if (other.name == patch.name) {
      node.at("name").fail(fmt::format("there are two patches with the name {}", patch.name));
    }
  }
  const JsonNode surface = node.at("surface");
  const SurfaceFormulas formulas = read_formulas(surface);
  const Domain domain = read_domain(node.at("domain"), constants);
  patch.surface = make_surface(surface, formulas, domain, constants);
  if (const auto loops = node.find("loops")) loops->expect_off({});
  if (const auto sources = node.find("sources")) {
    const PatchScope scope = {static_cast<int>(model.patches.size()), domain, constants};
    for (const JsonNode& source : sources->elements()) {
      read_source(source, scope, model.sources);
    }
  }
  model.patches.push_back(std::move(patch));
}

Sizing read_sizing(const JsonNode& node) {
  node.expect_keys({"curvature", "sag", "hmin", "hmax", "stretch", "grade", "contour_curvature",
                    "proximity", "features"});
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
  if (const auto sag = node.find("sag")) sag->expect_off({0, "off"});
  if (const auto proximity = node.find("proximity")) proximity->expect_off({0, 1});
  // Not built yet, but on is the default, so either value may stand there.
  for (const char* key : {"contour_curvature", "features"}) {
    if (const auto flag = node.find(key)) flag->boolean();
  }
  return sizing;
}

}  // namespace

ModelFile parse_model(std::string_view text, const std::string& name) {
  const Json json = parse_json(text, name);
  const JsonNode root(json, name);
  root.expect_keys({"constants", "patches", "cages", "contours", "sources", "sizing", "options"});
  for (const char* key : {"cages", "contours", "sources"}) {
    if (const auto node = root.find(key)) node->expect_off({});
  }
  ModelFile model;
  Constants constants;
  if (const auto node = root.find("constants")) constants = read_constants(*node);
  const JsonNode patches = root.at("patches");
  for (const JsonNode& patch : patches.elements()) read_patch(patch, constants, model);
  if (model.patches.empty()) patches.fail("the model has no patches");
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
