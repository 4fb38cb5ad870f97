// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "bindings.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/notice.hh"
#include "surfmesh/core/version.hh"
#include "surfmesh/formula/formula.hh"
#include "surfmesh/io/clean_text.hh"

namespace surfmesh::python {
namespace {

namespace py = pybind11;

/// Raise the exception that the package has for the code.
void raise(const Error& error) {
  const py::object type =
      py::module_::import("surfmesh._errors").attr("error_type")(name(error.code()));
  PyErr_SetString(type.ptr(), clean_text(error.what()).c_str());
}

void bind_notices(py::module_& module) {
  py::class_<Notice>(module, "Notice", "Something to tell of a model, a run or a file.")
      .def_property_readonly(
          "kind", [](const Notice& notice) { return std::string(name(notice.kind)); },
          "What it is about: \"ignored_input\", \"turned_triangles\", ...")
      .def_property_readonly(
          "severity", [](const Notice& notice) { return std::string(name(notice.severity)); },
          "\"warning\", or \"shortfall\" where something asked for was not reached.")
      .def_property_readonly(
          "text", [](const Notice& notice) { return clean_text(notice.text); }, "Plain English.")
      .def_property_readonly(
          "patch", [](const Notice& notice) { return notice.patch; },
          "Index of the patch it is about, or the first of several; -1 for none.")
      .def_property_readonly(
          "contour", [](const Notice& notice) { return notice.contour; },
          "Index of the contour likewise; -1 for none.")
      .def_property_readonly(
          "point",
          [](const Notice& notice) -> py::object {
            if (!notice.point) return py::none();
            return py::make_tuple(notice.point->x(), notice.point->y(), notice.point->z());
          },
          "Where it is in space (x, y, z), or None.")
      .def_property_readonly(
          "count", [](const Notice& notice) { return notice.count; }, "How often it came.")
      .def("__str__", [](const Notice& notice) { return clean_text(notice.text); })
      .def("__repr__", [](const Notice& notice) {
        return "<surfmesh.Notice " + std::string(name(notice.kind)) + ": " +
               clean_text(notice.text) + ">";
      });
}

}  // namespace
}  // namespace surfmesh::python

PYBIND11_MODULE(_surfmesh, module) {
  using namespace surfmesh::python;
  module.doc() = "The C++ side of the package surfmesh.";
  module.attr("version") = SURFMESH_VERSION;
  pybind11::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const surfmesh::Error& error) {
      raise(error);
    }
  });
  bind_notices(module);
  module.def("formula_functions", &surfmesh::formula_functions, "All functions of formulas.");
  bind_options(module);
  bind_input(module);
  bind_builder(module);
  bind_sources(module);
  bind_runs(module);
  bind_mesh(module);
}
