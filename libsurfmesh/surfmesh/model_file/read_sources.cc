// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_sources.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surfmesh/core/at_location.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/model_file/read_background.hh"
#include "surfmesh/model_file/read_table.hh"
#include "surfmesh/sizes/formula_field.hh"

namespace surfmesh {
namespace {

constexpr std::array<std::string_view, 7> kPatchSources = {
    "everywhere", "at", "along", "inside", "field", "table", "background"};

/// Those of a model. A group alone has its size everywhere.
constexpr std::array<std::string_view, 7> kSpaceSources = {
    "near", "along", "inside", "field", "background", "everywhere", "group"};

/// The kind of a source of a model; a group comes beside another kind, or alone.
std::string kind_in_space(const JsonNode& node) {
  const std::span kinds(kSpaceSources);
  const std::span others = kinds.first(kinds.size() - 1);
  const bool is_alone = std::none_of(others.begin(), others.end(),
                                     [&](std::string_view key) { return node.has(key); });
  return kind_of(node, is_alone ? kinds : others);
}

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
  AlongSource source{patch.index, {}, read_wish(node), node.place()};
  for (std::size_t i = 1; i < uvs.size(); ++i) {
    source.curves.push_back(std::make_shared<SegmentCurve>(uvs[i - 1], uvs[i]));
  }
  model.sources.along.push_back(std::move(source));
}

/// A field, as formulas of these variables; its patch is not set.
FieldSource read_field(const JsonNode& node, const std::vector<std::string>& variables,
                       const Constants& constants) {
  refuse(node, "a field", {"size", "angle", "radius", "outer"});
  const JsonNode field = node.at("field");
  field.expect_keys({"size", "m11", "m12", "m22", "where"});
  FormulaNode formula(field, variables, constants);
  FieldSource source;
  if (field.has("size")) {
    refuse(field, "a field of one size", {"m11", "m12", "m22"});
    const std::string size = formula.text("size");
    source = at_node(field, [&] { return formula_field(size, constants, formula.where()); });
  } else {
    const std::array<std::string, 3> metric = {formula.text("m11"), formula.text("m12"),
                                               formula.text("m22")};
    source = at_node(field, [&] { return formula_field(metric, constants, formula.where()); });
  }
  source.precision = read_precision(node);
  source.origin = node.place();
  return source;
}

void read_table_source(const JsonNode& node, const PatchScope& patch, ModelFile& model) {
  refuse(node, "a table", {"size", "angle", "radius", "outer"});
  const JsonNode table = node.at("table");
  const std::string file = table.text();
  if (file.empty()) table.fail("must not be empty");
  try {
    model.tables.push_back(patch.folder / file);
    model.sources.tables.push_back({patch.index, read_table(model.tables.back(), patch.domain),
                                    read_precision(node), node.place()});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Io) throw;
    table.fail(error.what());
  }
}

BackgroundIn read_in(const JsonNode& node) {
  const auto in = node.find("in");
  if (!in || in->json().is_null()) return BackgroundIn::Space;
  const std::string word = in->text();
  if (word != "space" && word != "uv") in->fail("must be \"space\" or \"uv\"");
  return word == "uv" ? BackgroundIn::Uv : BackgroundIn::Space;
}

/// A background mesh with its values; what is wrong in its file is told with both places.
BackgroundInput read_background_source(const JsonNode& node, const std::filesystem::path& folder,
                                       ModelFile& model) {
  refuse(node, "a background mesh", {"size", "angle", "radius", "outer"});
  const JsonNode background = node.at("background");
  const std::string file = background.text();
  if (file.empty()) background.fail("must not be empty");
  const auto values = node.find("values");
  const BackgroundIn in = read_in(node);
  BackgroundInput input{nullptr, read_precision(node)};
  const auto reach = node.find("reach");
  const bool has_reach = reach && !reach->json().is_null();
  if (has_reach && !(reach->number() > 0)) reach->fail("must be above 0");
  model.tables.push_back(folder / file);
  try {
    BackgroundMesh mesh = read_background(model.tables.back(), values ? values->text() : "", in);
    if (has_reach) mesh.reach = reach->number();
    at_location(model.tables.back().string(), [&] {
      input.sizes = std::make_shared<const BackgroundSizes>(std::move(mesh), in);
    });
  } catch (const Error& error) {
    background.fail(error.what());
  }
  return input;
}

Vec3 read_space_point(const JsonNode& node, const Constants& constants) {
  const std::vector<JsonNode> values = node.elements(3);
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    const JsonNode& value = values[static_cast<std::size_t>(i)];
    point[i] = number_or_expression(value, constants);
    if (!std::isfinite(point[i])) value.fail("must be finite");
  }
  return point;
}

NearSource read_near(const JsonNode& node, const Constants& constants) {
  const JsonNode near = node.at("near");
  const std::vector<JsonNode> elements = near.elements();
  NearSource source{{}, read_wish(node), {}, node.place()};
  if (!elements.empty() && elements[0].json().is_array()) {
    for (const JsonNode& point : elements)
      source.line.push_back(read_space_point(point, constants));
  } else {
    source.line.push_back(read_space_point(near, constants));
  }
  return source;
}

/// A ball is a point with a radius.
NearSource read_ball(const JsonNode& node, const JsonNode& inside, const Constants& constants) {
  if (node.has("radius")) node.at("radius").fail("the ball has its own radius");
  NearSource source{
      {read_space_point(inside.at("ball"), constants)}, read_wish(node), {}, node.place()};
  source.wish.radius = read_length(inside.at("radius"));
  return source;
}

BoxSource read_box(const JsonNode& node, const JsonNode& box, const Constants& constants) {
  const std::vector<JsonNode> corners = box.elements(2);
  const Vec3 a = read_space_point(corners[0], constants),
             b = read_space_point(corners[1], constants);
  return {Eigen::AlignedBox3d(a.cwiseMin(b), a.cwiseMax(b)), read_wish(node), {}, node.place()};
}

void read_inside_space(const JsonNode& node, const Constants& constants, SpaceSource& source) {
  const JsonNode inside = node.at("inside");
  if (inside.json().is_array()) {
    inside.fail(
        "a polygon is in the (u,v) of a patch, and belongs in the sources of that; here it "
        "takes a box or a ball");
  }
  inside.expect_keys({"box", "ball", "radius"});
  if (inside.has("box") == inside.has("ball")) inside.fail("needs either a box or a ball");
  if (inside.has("ball")) {
    source.wish = read_ball(node, inside, constants);
  } else {
    refuse(inside, "a box", {"radius"});
    source.wish = read_box(node, inside.at("box"), constants);
  }
}

/// Read a source that is no field.
void read_space_size(const JsonNode& node, const std::string& kind, const Constants& constants,
                     SpaceSource& source) {
  if (kind == "near") {
    source.wish = read_near(node, constants);
  } else if (kind == "inside") {
    read_inside_space(node, constants, source);
  } else {
    refuse(node, "a size everywhere", {"radius", "outer"});
    if (kind == "everywhere" && !node.at(kind).boolean()) node.at(kind).fail("must be true");
    source.wish = read_size(node);
  }
}

/// Refuse what is in the (u,v) of one patch.
FieldSource read_space_field(const JsonNode& node, const Constants& constants) {
  const JsonNode field = node.at("field");
  for (const std::string_view key : {"m11", "m12", "m22"}) {
    if (field.has(key)) {
      field.at(key).fail("a metric is in the (u,v) of a patch, and belongs in the sources of that");
    }
  }
  const FieldSource source = read_field(node, formula_field_variables(), constants);
  try {
    read_field(node, {"x", "y", "z"}, constants);
  } catch (const Error&) {
    field.fail(
        "u and v are those of one patch: a field of them belongs in the sources of that; "
        "here it takes x, y and z");
  }
  return source;
}

/// A size along contours of the model, by name.
void read_along_contours(const JsonNode& node, ModelFile& model) {
  refuse(node, "a size along contours", {"group"});
  const JsonNode along = node.at("along");
  const LocalSize wish = read_wish(node);
  const auto add = [&](const JsonNode& contour) {
    if (!contour.json().is_string()) {
      contour.fail(
          "must be the name of a contour; points in (u,v) belong in the sources of a patch");
    }
    model.along_contours.push_back({-1, contour.text(), wish, contour.pointer()});
  };
  if (!along.json().is_array()) return add(along);
  if (along.json().empty()) along.fail("must not be empty");
  for (const JsonNode& contour : along.elements()) add(contour);
}

/// Tell where a source belongs that stands at the wrong level.
void refuse_elsewhere(const JsonNode& node, std::initializer_list<std::string_view> keys,
                      std::string_view where) {
  for (const std::string_view key : keys) {
    if (node.has(key))
      node.at(key).fail(fmt::format("{} belongs in the sources of {}", key, where));
  }
}

}  // namespace

void read_patch_source(const JsonNode& node, const PatchScope& patch, ModelFile& model) {
  refuse_elsewhere(node, {"near", "group"}, "the model, beside patches");
  node.expect_keys({"everywhere", "at", "along", "inside", "field", "table", "size", "angle",
                    "radius", "outer", "precision", "background", "values", "in", "reach"});
  Sources& sources = model.sources;
  const std::string kind = kind_of(node, kPatchSources);
  if (kind == "field") {
    FieldSource field = read_field(node, formula_field_variables(), patch.constants);
    field.patch = patch.index;
    sources.fields.push_back(std::move(field));
    return;
  }
  if (kind == "table") return read_table_source(node, patch, model);
  if (kind == "background") {
    model.space_sources.push_back(
        {"", node.pointer(), read_background_source(node, patch.folder, model), patch.index});
    return;
  }
  refuse(node, "a size that is not of a field or table", {"precision"});
  refuse(node, "what is no background mesh", {"values", "in", "reach"});
  if (kind == "everywhere") {
    refuse(node, "a whole patch", {"radius", "outer"});
    if (!node.at(kind).boolean()) node.at(kind).fail("must be true");
    sources.everywhere.push_back({patch.index, read_size(node), node.place()});
  } else if (kind == "at") {
    const Uv uv = read_uv(node.at(kind), patch);
    const LocalSize wish = read_wish(node);
    sources.at.push_back({patch.index, uv, wish.size, wish.radius, wish.outer, node.place()});
  } else if (kind == "along") {
    read_along(node, patch, model);
  } else {
    const auto polygon = read_uvs(node.at(kind), patch, 3);
    sources.inside.push_back({patch.index, polygon, read_wish(node), node.place()});
  }
}

void read_divided_source(const JsonNode& node, const std::vector<PatchScope>& pieces,
                         const Domain& whole, ModelFile& model) {
  for (const std::string_view key : {"along", "inside", "table"}) {
    if (!node.has(key)) continue;
    node.at(key).fail(fmt::format(
        "{} is for one patch, but this one is divided at its creases: divide it at its knots into "
        "patches of their own",
        key));
  }
  if (node.has("background")) {
    read_patch_source(node, pieces.front(), model);
    SpaceSource source = model.space_sources.back();
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      source.patch = pieces[i].index;
      model.space_sources.push_back(source);
    }
    return;
  }
  const auto at = node.find("at");
  PatchScope scope = pieces.front();
  scope.domain = whole;
  const Uv uv = at ? read_uv(*at, scope) : Uv();
  for (const PatchScope& piece : pieces) {
    if (!at || piece.domain.clamp(uv) == uv) read_patch_source(node, piece, model);
  }
}

void read_space_source(const JsonNode& node, const Constants& constants,
                       const std::filesystem::path& folder, ModelFile& model) {
  refuse_elsewhere(node, {"at", "table"}, "a patch");
  node.expect_keys({"group", "everywhere", "near", "along", "inside", "field", "size", "angle",
                    "radius", "outer", "precision", "background", "values", "in", "reach"});
  SpaceSource source;
  source.origin = node.pointer();
  if (const auto group = node.find("group")) {
    source.group = group->text();
    if (source.group.empty()) group->fail("must not be empty");
  }
  const std::string kind = kind_in_space(node);
  if (kind == "field") {
    source.wish = read_space_field(node, constants);
  } else if (kind == "background") {
    source.wish = read_background_source(node, folder, model);
    if (source.group.empty() && read_in(node) == BackgroundIn::Uv) {
      node.at("in").fail(
          "u and v are those of one patch: name it by `group`, or put the source "
          "among those of the patch");
    }
  } else {
    refuse(node, "a size that is not of a field", {"precision"});
    if (kind == "along") return read_along_contours(node, model);
    read_space_size(node, kind, constants, source);
  }
  model.space_sources.push_back(std::move(source));
}

}  // namespace surfmesh
