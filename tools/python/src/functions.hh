// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <span>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/nurbs/sampled_surface.hh"

namespace surfmesh::python {

/// A Python function that the package has wrapped: it takes arrays u, v and returns points (n, 3)
/// that are checked. It is called with the GIL held, by the calling thread.
BatchFunction surface_function(const pybind11::object& function);

/// Values (n, width) of such a function at points: of (u, v), or of (x, y, z) on a surface.
std::vector<double> values_of(const pybind11::object& function, std::span<const Uv> uvs,
                              const Surface* in_space, std::size_t width);

}  // namespace surfmesh::python
