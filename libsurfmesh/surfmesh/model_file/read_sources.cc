// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_sources.hh"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "surfmesh/core/error.hh"
#include "surfmesh/model_file/read_table.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

constexpr std::array<std::string_view, 6> kPatchSources = {"everywhere", "at",    "along",
                                                           "inside",     "field", "table"};

/// Refuse keys that a kind of source has no use for.
void refuse(const JsonNode& node, std::string_view subject,
            std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    if (!node.has(key)) continue;
    const JsonNode value = node.at(key);
    const Json& json = value.json();
    const bool is_off = json.is_null() || json == 0 || (json.is_structured() && json.empty());
    if (!is_off) value.fail(fmt::format("{} has no {}", subject, key));
  }
}

/// `size`, `angle`, `radius` and `outer` of a source with a location.
LocalSize read_wish(const JsonNode& node) {
  LocalSize wish{read_size(node)};
  if (const auto radius = node.find("radius")) wish.radius = read_radius(*radius);
  const auto outer = node.find("outer");
  if (!outer || outer->json().is_null() || outer->json().empty()) return wish;
  outer->expect_keys({"size", "angle", "radius"});
  wish.outer = {read_size(*outer), read_radius(outer->at("radius"))};
  return wish;
}

std::optional<double> read_precision(const JsonNode& node) {
  const auto precision = node.find("precision");
  if (!precision || precision->json().is_null()) return std::nullopt;
  const double value = precision->number();
  if (!(value > 0)) precision->fail("must be above 0");
  return value;
}

Uv read_uv(const JsonNode& node, const PatchScope& patch) {
  const std::vector<JsonNode> values = node.elements(2);
  const Uv uv = {number_or_expression(values[0], patch.constants),
                 number_or_expression(values[1], patch.constants)};
  const Domain& domain = patch.domain;
  if (!(uv.u >= domain.u0 && uv.u <= domain.u1 && uv.v >= domain.v0 && uv.v <= domain.v1)) {
    node.fail("this point is outside of the domain");
  }
  return uv;
}

std::vector<Uv> read_uvs(const JsonNode& node, const PatchScope& patch, std::size_t least) {
  std::vector<Uv> uvs;
  for (const JsonNode& entry : node.elements()) uvs.push_back(read_uv(entry, patch));
  if (uvs.size() < least) node.fail(fmt::format("needs at least {} points", least));
  return uvs;
}

void read_along(const JsonNode& node, const PatchScope& patch, ModelFile& model) {
  const JsonNode along = node.at("along");
  if (along.json().is_string()) {
    model.along_contours.push_back({patch.index, along.text(), read_wish(node), along.pointer()});
    return;
  }
  const std::vector<Uv> uvs = read_uvs(along, patch, 2);
  AlongSource source{patch.index, {}, read_wish(node)};
  for (std::size_t i = 1; i < uvs.size(); ++i) {
    source.curves.push_back(std::make_shared<SegmentCurve>(uvs[i - 1], uvs[i]));
  }
  model.sources.along.push_back(std::move(source));
}

void read_field(const JsonNode& node, const PatchScope& patch, Sources& sources) {
  refuse(node, "a field", {"size", "angle", "radius", "outer"});
  const JsonNode field = node.at("field");
  field.expect_keys({"size", "m11", "m12", "m22", "where"});
  FormulaNode formula(field, formula_field_variables(), patch.constants);
  FieldSource source;
  if (field.has("size")) {
    refuse(field, "a field of one size", {"m11", "m12", "m22"});
    const std::string size = formula.text("size");
    source = at_node(field, [&] { return formula_field(size, patch.constants, formula.where()); });
  } else {
    const std::array<std::string, 3> metric = {formula.text("m11"), formula.text("m12"),
                                               formula.text("m22")};
    source =
        at_node(field, [&] { return formula_field(metric, patch.constants, formula.where()); });
  }
  source.patch = patch.index;
  source.precision = read_precision(node);
  sources.fields.push_back(std::move(source));
}

void read_table_source(const JsonNode& node, const PatchScope& patch, ModelFile& model) {
  refuse(node, "a table", {"size", "angle", "radius", "outer"});
  const JsonNode table = node.at("table");
  const std::string file = table.text();
  if (file.empty()) table.fail("must not be empty");
  try {
    model.tables.push_back(patch.folder / file);
    model.sources.tables.push_back(
        {patch.index, read_table(model.tables.back(), patch.domain), read_precision(node)});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Io) throw;
    table.fail(error.what());
  }
}

Vec3 read_point(const JsonNode& node, const Constants& constants) {
  const std::vector<JsonNode> values = node.elements(3);
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    const JsonNode& value = values[static_cast<std::size_t>(i)];
    point[i] = number_or_expression(value, constants);
    if (!std::isfinite(point[i])) value.fail("must be finite");
  }
  return point;
}

void read_near(const JsonNode& node, const Constants& constants, Sources& sources) {
  refuse(node, "a source near a place", {"precision"});
  const JsonNode near = node.at("near");
  const std::vector<JsonNode> elements = near.elements();
  NearSource source{{}, read_wish(node)};
  if (!elements.empty() && elements[0].json().is_array()) {
    for (const JsonNode& point : elements) source.line.push_back(read_point(point, constants));
  } else {
    source.line.push_back(read_point(near, constants));
  }
  sources.near.push_back(std::move(source));
}

}  // namespace

void read_patch_source(const JsonNode& node, const PatchScope& patch, ModelFile& model) {
  node.expect_keys({"everywhere", "at", "along", "inside", "field", "table", "size", "angle",
                    "radius", "outer", "precision"});
  Sources& sources = model.sources;
  const std::string kind = kind_of(node, kPatchSources);
  if (kind == "field") return read_field(node, patch, sources);
  if (kind == "table") return read_table_source(node, patch, model);
  refuse(node, "a size that is not of a field or table", {"precision"});
  if (kind == "everywhere") {
    refuse(node, "a whole patch", {"radius", "outer"});
    if (!node.at(kind).boolean()) node.at(kind).fail("must be true");
    sources.everywhere.push_back({patch.index, read_size(node)});
  } else if (kind == "at") {
    const Uv uv = read_uv(node.at(kind), patch);
    const LocalSize wish = read_wish(node);
    sources.at.push_back({patch.index, uv, wish.size, wish.radius, wish.outer});
  } else if (kind == "along") {
    read_along(node, patch, model);
  } else {
    const auto polygon = read_uvs(node.at(kind), patch, 3);
    sources.inside.push_back({patch.index, polygon, read_wish(node)});
  }
}

void read_space_source(const JsonNode& node, const Constants& constants, ModelFile& model) {
  node.expect_keys({"near", "group", "size", "angle", "radius", "outer", "precision"});
  const std::string kind = kind_of(node, std::array<std::string_view, 2>{"near", "group"});
  if (kind == "near") return read_near(node, constants, model.sources);
  refuse(node, "a group", {"radius", "outer", "precision"});
  const JsonNode group = node.at("group");
  model.groups.push_back({group.text(), read_size(node), group.pointer()});
}

}  // namespace surfmesh
