// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/msh_views.hh"

#include <fmt/format.h>

#include <algorithm>

#include "surfmesh/io/text_scanner.hh"

namespace surfmesh::msh {
namespace {

constexpr int kInt = 4, kDouble = 8;

/// The most numbers of a value: a tensor of 3 × 3.
constexpr std::int64_t kMostComponents = 9;

}  // namespace

/// Tags are lines of text, then numbers of text: the name; the time; the time step, the components,
/// the number of values, and possibly a partition.
Views::Header Views::read_header() {
  Header header;
  const std::size_t strings = scanner_.count(kInt, 1, "the number of text tags");
  scanner_.line();
  for (std::size_t i = 0; i < strings; ++i) {
    const std::string_view line = scanner_.line();
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (first == last) scanner_.fail("a text tag has no quotes");
    if (i == 0) header.name = line.substr(first + 1, last - first - 1);
  }
  const std::size_t reals = scanner_.count(kInt, 1, "the number of real tags");
  for (std::size_t i = 0; i < reals; ++i) scanner_.number(kDouble, "a real tag");
  const std::size_t integers = scanner_.count(kInt, 1, "the number of integer tags");
  if (integers < 3) scanner_.fail("a view needs three integer tags");
  for (std::size_t i = 0; i < integers; ++i) {
    if (i == 2) {
      header.count = scanner_.count(kInt, 1, "the number of values");
      continue;
    }
    const std::int64_t value = scanner_.integer(kInt, "an integer tag");
    if (i != 1) continue;
    if (value < 1 || value > kMostComponents) {
      scanner_.fail(fmt::format("values with {} components", value));
    }
    header.components = static_cast<int>(value);
  }
  scanner_.line();
  return header;
}

GridValues& Views::view_of(const Header& header, std::size_t nodes, double value) {
  const auto known = std::find_if(views_.begin(), views_.end(),
                                  [&](const GridValues& view) { return view.name == header.name; });
  const bool is_new = known == views_.end();
  if (!is_new)
    leave_out(fmt::format("time steps of {} before the last", surfmesh::quoted(header.name)));
  GridValues& view = is_new ? views_.emplace_back() : *known;
  view.name = header.name;
  view.components = header.components;
  numbers_ += nodes * static_cast<std::size_t>(header.components);
  if (numbers_ > scanner_.bytes().size()) {
    scanner_.fail("views have more numbers than the file has bytes");
  }
  view.numbers.assign(nodes * static_cast<std::size_t>(header.components), value);
  return view;
}

void Views::read_at_nodes(const std::function<void()>& begin, const NodeNumbers& nodes) {
  const Header header = read_header();
  begin();
  if (header.count == 0) return leave_out("views without values");
  GridValues& view = view_of(header, nodes.size(), kUnset);
  const auto components = static_cast<std::size_t>(header.components);
  for (std::size_t i = 0; i < header.count; ++i) {
    const std::int64_t number = scanner_.integer(kInt, "the number of a node");
    const int node = nodes.index(number);
    if (node < 0) {
      scanner_.fail(fmt::format("a value is that of the node {}, which is not there", number));
    }
    for (std::size_t k = 0; k < components; ++k) {
      view.numbers[static_cast<std::size_t>(node) * components + k] =
          scanner_.number(kDouble, "a value of a view");
    }
  }
}

void Views::read_at_element_nodes(const std::function<void()>& begin, Model& model) {
  const Header header = read_header();
  begin();
  if (header.count == 0) return leave_out("views without values");
  const std::size_t nodes = model.numbers().size();
  GridValues& view = view_of(header, nodes, 0);
  std::vector<double> counts(nodes, 0);
  const auto components = static_cast<std::size_t>(header.components);
  for (std::size_t i = 0; i < header.count; ++i) {
    const std::int64_t number = scanner_.integer(kInt, "the number of an element");
    const std::span<const int> element = model.nodes_of(number);
    const std::int64_t given = scanner_.integer(kInt, "the number of nodes of an element");
    if (element.empty() || given < 0 || given > static_cast<std::int64_t>(element.size())) {
      scanner_.fail(fmt::format("values are those of {} nodes of the element {}, which is not so",
                                given, number));
    }
    for (const int node : element.first(static_cast<std::size_t>(given))) {
      counts[static_cast<std::size_t>(node)] += 1;
      for (std::size_t k = 0; k < components; ++k) {
        view.numbers[static_cast<std::size_t>(node) * components + k] +=
            scanner_.number(kDouble, "a value of a view");
      }
    }
  }
  // 0/0 is NaN where there is none.
  for (std::size_t i = 0; i < view.numbers.size(); ++i) view.numbers[i] /= counts[i / components];
}

std::vector<GridValues> Views::finish() { return std::move(views_); }

}  // namespace surfmesh::msh
