// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arrays.hh"
#include "bindings.hh"
#include "held_sources.hh"
#include "model_input.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/model/divide_contours.hh"
#include "surfmesh/model/join_sides.hh"
#include "surfmesh/sizes/formula_field.hh"
#include "tabulated_field.hh"

namespace surfmesh::python {
namespace {

/// Lengths along and across as text, and the angle in radians.
using SizeText = std::tuple<std::string, std::string, double>;
/// A size, its radius, and the size farther away with its radius.
using WishText = std::tuple<SizeText, std::string, std::optional<std::pair<SizeText, std::string>>>;

Length length_from(const std::string& text) {
  const Length length = parse_length(text);
  if (length.is_legal()) return length;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{} is no length: those are from 0, shares up to 100%", text));
}

Size size_from(const SizeText& text) {
  const auto& [along, across, angle] = text;
  const Size size{length_from(along), length_from(across), angle};
  if (size.along.value > 0 && size.across.value > 0) return size;
  throw Error(ErrorCode::InvalidInput, "a size is above 0");
}

LocalSize wish_from(const WishText& text) {
  const auto& [size, radius, outer] = text;
  LocalSize wish{size_from(size), length_from(radius)};
  if (outer) wish.outer = {size_from(outer->first), length_from(outer->second)};
  return wish;
}

void add_everywhere(HeldSources& held, const std::vector<int>& patches, const SizeText& size) {
  for (const int patch : patches) {
    held.sources.everywhere.push_back({.patch = patch, .size = size_from(size)});
  }
}

void add_at(HeldSources& held, int patch, const std::pair<double, double>& uv,
            const WishText& text) {
  const LocalSize wish = wish_from(text);
  held.sources.at.push_back({.patch = patch,
                             .at = {uv.first, uv.second},
                             .size = wish.size,
                             .radius = wish.radius,
                             .outer = wish.outer});
}

/// The contours of a name, or of a side, with their uses.
std::vector<int> contours_of(const Model& model, const std::string& name) {
  std::vector<int> found;
  for (std::size_t i = 0; i < model.contours.size(); ++i) {
    if (is_part_of(model.contours[i].name, name)) found.push_back(static_cast<int>(i));
  }
  if (!found.empty()) return found;
  if (name.find(':') != std::string::npos) {
    for (const LoopEntry& entry : side_uses(model, name)) found.push_back(entry.contour);
    return found;
  }
  std::vector<std::string_view> names;
  for (const Contour& contour : model.contours) names.push_back(contour.name);
  const auto meant = nearest_word(name, names);
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{} is no contour or side of the model{}", name,
                          meant ? fmt::format(", did you mean {}?", *meant) : ""));
}

void add_along(HeldSources& held, const HeldInput& input, const std::string& name,
               const WishText& text) {
  const Model& model = input.input.model;
  const LocalSize wish = wish_from(text);
  for (const int contour : contours_of(model, name)) {
    held.along.insert(contour);
    for (const ContourUse& use : model.contour(contour).uses) {
      held.sources.along.push_back({.patch = use.patch, .curves = {use.curve}, .wish = wish});
    }
  }
}

void add_inside(HeldSources& held, int patch, const Doubles& polygon, const WishText& wish) {
  held.sources.inside.push_back(
      {.patch = patch, .polygon = uvs_from(polygon), .wish = wish_from(wish)});
}

void add_near(HeldSources& held, const std::vector<int>& patches, const Doubles& line,
              const WishText& wish) {
  held.sources.near.push_back(
      {.line = points_from(line), .wish = wish_from(wish), .patches = patches});
}

void add_box(HeldSources& held, const std::vector<int>& patches, const Doubles& corners,
             const WishText& wish) {
  const std::vector<Vec3> points = points_from(corners);
  held.sources.boxes.push_back(
      {.box = {points.at(0), points.at(1)}, .wish = wish_from(wish), .patches = patches});
}

/// One formula of a size, or three of a metric.
void add_formula(HeldSources& held, const std::vector<int>& patches,
                 const std::vector<std::string>& formulas,
                 const std::map<std::string, double>& constants,
                 const std::optional<double>& precision) {
  FieldSource field =
      formulas.size() == 1
          ? formula_field(formulas[0], constants)
          : formula_field(std::array{formulas.at(0), formulas.at(1), formulas.at(2)}, constants);
  field.precision = precision;
  for (const int patch : patches) {
    field.patch = patch;
    held.sources.fields.push_back(field);
  }
}

/// Rows u, v and a size, two sizes and an angle in radians, or a metric.
void add_table(HeldSources& held, int patch, const Doubles& rows, bool is_metric,
               const std::optional<double>& precision) {
  TableSource table{.patch = patch, .precision = precision};
  const auto values = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    TableNode node;
    node.uv = {values(i, 0), values(i, 1)};
    if (is_metric) {
      node.metric = {values(i, 2), values(i, 3), values(i, 4)};
    } else {
      const bool is_one = values.shape(1) == 3;
      node.size = {Length::units(values(i, 2)), Length::units(values(i, is_one ? 2 : 3)),
                   is_one ? 0 : values(i, 4)};
    }
    table.nodes.push_back(node);
  }
  held.sources.tables.push_back(std::move(table));
}

/// Returns  the greatest relative error of the table, and its entries
std::pair<double, std::size_t> add_function(HeldSources& held, const HeldInput& input, int patch,
                                            const FieldFunction& function,
                                            const TableOptions& options) {
  TabulatedField field = tabulate(function, input.input.model.surface(patch), options);
  field.source.patch = patch;
  held.sources.fields.push_back(std::move(field.source));
  return held.tabulations.emplace_back(field.error, field.samples);
}

template <class Entry>
void add_all(const std::vector<Entry>& more, std::vector<Entry>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

void append_held(HeldSources& held, const HeldSources& more) {
  python::append(more.sources, held.sources);
  held.along.insert(more.along.begin(), more.along.end());
  add_all(more.tabulations, held.tabulations);
}

}  // namespace

void append(const Sources& more, Sources& all) {
  add_all(more.everywhere, all.everywhere);
  add_all(more.at, all.at);
  add_all(more.along, all.along);
  add_all(more.inside, all.inside);
  add_all(more.near, all.near);
  add_all(more.boxes, all.boxes);
  add_all(more.fields, all.fields);
  add_all(more.tables, all.tables);
}

void bind_sources(py::module_& module) {
  py::class_<HeldSources, std::shared_ptr<HeldSources>>(module, "HeldSources",
                                                        "Sizes that are asked for.")
      .def(py::init<>())
      .def("add_everywhere", &add_everywhere, py::arg("patches"), py::arg("size"),
           "One size in patches.")
      .def("add_at", &add_at, py::arg("patch"), py::arg("uv"), py::arg("wish"),
           "A size at a point of a patch.")
      .def("add_along", &add_along, py::arg("model"), py::arg("name"), py::arg("wish"),
           "A size along a contour or side.")
      .def("add_inside", &add_inside, py::arg("patch"), py::arg("polygon"), py::arg("wish"),
           "A size inside a polygon.")
      .def("add_near", &add_near, py::arg("patches"), py::arg("line"), py::arg("wish"),
           "A size near points in space.")
      .def("add_box", &add_box, py::arg("patches"), py::arg("corners"), py::arg("wish"),
           "A size inside a box.")
      .def("add_formula", &add_formula, py::arg("patches"), py::arg("formulas"),
           py::arg("constants"), py::arg("precision"), "A size or metric as formulas.")
      .def("add_table", &add_table, py::arg("patch"), py::arg("rows"), py::arg("is_metric"),
           py::arg("precision"), "Sizes or metrics at points.")
      .def(
          "add_function",
          [](HeldSources& held, const HeldInput& input, int patch, const py::object& function,
             bool is_metric, bool is_in_space, double precision, std::size_t max_samples) {
            return add_function(held, input, patch, {function, is_metric, is_in_space},
                                {precision, max_samples});
          },
          py::arg("model"), py::arg("patch"), py::arg("function"), py::arg("is_metric"),
          py::arg("is_in_space"), py::arg("precision"), py::arg("max_samples"),
          "A Python function, tabulated; its error and entries.")
      .def("append", &append_held, py::arg("more"), "Add sizes after those that are here.")
      .def(
          "tabulations", [](const HeldSources& held) { return held.tabulations; },
          "Errors and entries of the functions that became tables.");
}

}  // namespace surfmesh::python
