// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace surfmesh::python {

/// Each adds its part to the module.
void bind_options(pybind11::module_& module);
void bind_input(pybind11::module_& module);
void bind_builder(pybind11::module_& module);
void bind_sources(pybind11::module_& module);
void bind_runs(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);

}  // namespace surfmesh::python
