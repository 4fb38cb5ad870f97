// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <string_view>

#include "bindings.hh"
#include "surfmesh/pipeline/option_table.hh"
#include "surfmesh/pipeline/set_option.hh"

namespace surfmesh::python {
namespace {

namespace py = pybind11;

const char* name_of(OptionGroup group) {
  switch (group) {
    case OptionGroup::Sizes:
      return "sizes";
    case OptionGroup::ControlSpace:
      return "control space";
    case OptionGroup::Meshing:
      return "meshing";
    case OptionGroup::Cages:
      return "model";
  }
  return "";
}

const char* kind_of(const Option& option) {
  const auto* number = std::get_if<NumberAccess>(&option.access);
  if (!number) return "length";
  if (number->range->is_switch()) return "switch";
  if (!number->range->has_numbers()) return "choice";
  return number->range->is_whole ? "whole number" : "number";
}

/// The option table.
py::list options() {
  const PipelineOptions defaults;
  py::list list;
  for (const Option& option : option_table()) {
    py::dict entry;
    entry["name"] = std::string(option.name());
    entry["group"] = name_of(option.group);
    entry["kind"] = kind_of(option);
    entry["unit"] = std::string(option.unit);
    entry["text"] = std::string(option.text);
    entry["range"] = option.range_text();
    entry["words"] = option.words();
    entry["default"] = option.value_text(defaults);
    list.append(entry);
  }
  return list;
}

/// Throws   InvalidOption for an unknown option or an illegal value
void check_option(const std::string& name, const std::string& value) {
  PipelineOptions scratch;
  set_option(scratch, name, value);
}

}  // namespace

void bind_options(py::module_& module) {
  module.def("options", &options, "The option table.");
  module.def("check_option", &check_option, py::arg("name"), py::arg("value"),
             "Raise InvalidOption for an unknown option or an illegal value.");
}

}  // namespace surfmesh::python
