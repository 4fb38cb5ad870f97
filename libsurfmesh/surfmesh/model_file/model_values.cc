// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/model_values.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "surfmesh/core/length.hh"

namespace surfmesh {
namespace {

/// A finite length of any sign.
Length read_any_length(const JsonNode& node) {
  Length length;
  if (node.json().is_string()) {
    length = at_node(node, [&] { return parse_length(node.text()); });
    if (!length.is_relative) node.fail("a length in model units is a number, without quotes");
  } else {
    length = Length::units(node.number());
  }
  if (length.is_relative && length.value > 1) node.fail("a share of the diagonal is at most 100%");
  return length;
}

}  // namespace

FormulaNode::FormulaNode(const JsonNode& node, const std::vector<std::string>& variables,
                         const Constants& constants)
    : node_(node), reader_(variables, constants) {
  const auto where = node.find("where");
  if (!where) return;
  for (const auto& [name, value] : where->members()) {
    const NamedFormula formula = {name, value.text()};
    at_node(value, [&] { reader_.define(formula.name, formula.text); });
    where_.push_back(formula);
  }
}

std::string FormulaNode::text(std::string_view key) {
  const JsonNode value = node_.at(key);
  const std::string text = value.text();
  at_node(value, [&] { reader_.read(text); });
  return text;
}

std::string FormulaNode::text(std::string_view key, const std::string& otherwise) {
  return node_.has(key) ? text(key) : otherwise;
}

double number_or_expression(const JsonNode& node, const Constants& constants) {
  if (!node.json().is_string()) return node.number();
  return at_node(node, [&] { return evaluate_constant(node.text(), constants); });
}

Length read_length(const JsonNode& node) {
  const Length length = read_any_length(node);
  if (!(length.value > 0)) node.fail("must be above 0");
  return length;
}

Length read_radius(const JsonNode& node) {
  const Length length = read_any_length(node);
  if (!(length.value >= 0)) node.fail("must be 0 or above");
  return length;
}

std::pair<double, double> read_range(const JsonNode& node, const Constants& constants) {
  const std::vector<JsonNode> bounds = node.elements(2);
  const double from = number_or_expression(bounds[0], constants);
  const double to = number_or_expression(bounds[1], constants);
  if (!std::isfinite(from)) bounds[0].fail("must be finite");
  if (!std::isfinite(to)) bounds[1].fail("must be finite");
  if (!(from < to)) node.fail("the second value must be larger than the first");
  return {from, to};
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

std::string read_name(const JsonNode& node) {
  std::string name = node.text();
  if (name.empty()) node.fail("must not be empty");
  if (name[0] == '-') node.fail("a name must not begin with -, which turns a contour in a loop");
  return name;
}

std::string kind_of(const JsonNode& source, std::span<const std::string_view> kinds) {
  std::string kind;
  for (const std::string_view key : kinds) {
    if (!source.has(key)) continue;
    if (!kind.empty()) source.fail(fmt::format("a source cannot have both {} and {}", kind, key));
    kind = key;
  }
  if (kind.empty()) source.fail(fmt::format("a source needs one of {}", fmt::join(kinds, ", ")));
  return kind;
}

}  // namespace surfmesh
