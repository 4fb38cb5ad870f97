// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/option_schema.hh"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "surfmesh/io/json_node.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh {
namespace {

/// Without a point where it is whole.
Json json_number(double value) {
  if (value == std::floor(value)) return static_cast<std::int64_t>(value);
  return value;
}

Json numbers_rule(const OptionRange& range) {
  return {{"type", range.is_whole ? "integer" : "number"},
          {range.is_open ? "exclusiveMinimum" : "minimum", json_number(range.least)},
          {"maximum", json_number(range.most)}};
}

/// The words of an option, and what JSON has in their place: true, false and 0.
Json words_rule(const Option& option, bool is_off_by_zero) {
  Json words = Json::array();
  for (const std::string_view word : option.words()) {
    const bool is_boolean = word == "true" || word == "false";
    words.push_back(is_boolean ? Json(word == "true") : Json(word));
    if (word == "off" && is_off_by_zero) words.push_back(0);
  }
  words.push_back(nullptr);
  return {{"enum", words}};
}

Json rules(const Option& option) {
  if (std::holds_alternative<LengthAccess>(option.access)) {
    return {{{"$ref", "#/$defs/length"}}, words_rule(option, true)};
  }
  const OptionRange& range = *std::get<NumberAccess>(option.access).range;
  Json result = Json::array();
  if (range.has_numbers()) result.push_back(numbers_rule(range));
  result.push_back(words_rule(option, range.has_numbers()));
  return result;
}

Json rule(const Option& option) {
  Json result = {{"description", option.text}};
  std::visit([&](const auto& value) { result["default"] = value; },
             get_option(PipelineOptions(), option.name()));
  result["anyOf"] = rules(option);
  return result;
}

}  // namespace

std::string schema_with_options(std::string_view schema) {
  Json json = parse_json(schema, "schema");
  Json sizing = Json::object(), options = Json::object();
  for (const Option& option : option_table()) {
    Json& place = option.group == OptionGroup::Sizes ? sizing : options;
    place[std::string(option.name())] = rule(option);
  }
  json["properties"]["sizing"]["properties"] = sizing;
  json["properties"]["options"]["properties"] = options;
  return json.dump(2) + "\n";
}

}  // namespace surfmesh
