// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/model_file/read_nurbs.hh"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

namespace surfmesh {
namespace {

std::vector<double> read_numbers(const JsonNode& node, const Constants& constants) {
  std::vector<double> numbers;
  for (const JsonNode& entry : node.elements()) {
    numbers.push_back(number_or_expression(entry, constants));
  }
  return numbers;
}

int read_degree(const JsonNode& node) {
  const double number = node.number();
  if (!(number >= 1 && number <= kMostDegree && number == std::floor(number))) {
    node.fail(fmt::format("a degree must be a whole number from 1 to {}", kMostDegree));
  }
  return static_cast<int>(number);
}

Vec3 read_point(const JsonNode& node, const Constants& constants) {
  const std::vector<JsonNode> values = node.elements(3);
  return {number_or_expression(values[0], constants), number_or_expression(values[1], constants),
          number_or_expression(values[2], constants)};
}

std::vector<Vec3> read_row(const JsonNode& node, const Constants& constants) {
  std::vector<Vec3> row;
  for (const JsonNode& point : node.elements()) row.push_back(read_point(point, constants));
  return row;
}

/// The value at the end of a path as faults have it: "knots/0/5".
JsonNode node_at(JsonNode node, std::string_view path) {
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string_view token = path.substr(0, slash);
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
    if (node.json().is_array()) {
      node = node.elements().at(std::stoul(std::string(token)));
    } else {
      node = node.at(token);
    }
  }
  return node;
}

template <class Input>
Input checked(const JsonNode& node, Input input) {
  if (const auto fault = find_fault(input)) node_at(node, fault->path).fail(fault->text);
  return input;
}

}  // namespace

NurbsNet read_nurbs_net(const JsonNode& node, const Constants& constants) {
  node.expect_keys({"degree", "knots", "points", "weights", "periodic"});
  const std::vector<JsonNode> degree = node.at("degree").elements(2);
  const std::vector<JsonNode> knots = node.at("knots").elements(2);
  NurbsNet net;
  for (const std::size_t d : {0u, 1u}) {
    net.degree[d] = read_degree(degree[d]);
    net.knots[d] = read_numbers(knots[d], constants);
  }
  for (const JsonNode& row : node.at("points").elements()) {
    net.points.push_back(read_row(row, constants));
  }
  if (const auto weights = node.find("weights")) {
    for (const JsonNode& row : weights->elements()) {
      net.weights.push_back(read_numbers(row, constants));
    }
    if (net.weights.empty()) weights->fail("there must be a weight for each point");
  }
  if (const auto periodic = node.find("periodic")) {
    const std::vector<JsonNode> flags = periodic->elements(2);
    for (const std::size_t d : {0u, 1u}) net.periodic[d] = flags[d].boolean();
  }
  return checked(node, std::move(net));
}

std::shared_ptr<const NurbsCurve> read_nurbs_curve(const JsonNode& node,
                                                   const std::optional<CurveRange>& range,
                                                   const Constants& constants) {
  node.expect_keys({"degree", "knots", "points", "weights", "periodic"});
  NurbsPolygon polygon;
  polygon.degree = read_degree(node.at("degree"));
  polygon.knots = read_numbers(node.at("knots"), constants);
  for (const JsonNode& point : node.at("points").elements()) {
    const std::vector<JsonNode> values = point.elements(2);
    polygon.points.push_back(
        {number_or_expression(values[0], constants), number_or_expression(values[1], constants)});
  }
  if (const auto weights = node.find("weights")) {
    polygon.weights = read_numbers(*weights, constants);
    if (polygon.weights.empty()) weights->fail("there must be a weight for each point");
  }
  if (const auto periodic = node.find("periodic")) polygon.periodic = periodic->boolean();
  polygon = checked(node, std::move(polygon));
  return at_node(node.at("knots"), [&] {
    return range ? std::make_shared<const NurbsCurve>(polygon, *range)
                 : std::make_shared<const NurbsCurve>(polygon);
  });
}

std::string piece_name(const std::string& patch, const NurbsPiece& piece) {
  return fmt::format("{}[{},{}]", patch, piece.column, piece.row);
}

}  // namespace surfmesh
