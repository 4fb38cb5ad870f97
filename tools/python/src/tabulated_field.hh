// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>

#include "surfmesh/geometry/surface.hh"
#include "surfmesh/sizes/sizing.hh"

namespace surfmesh::python {

/// What a Python function gives, and of what.
struct FieldFunction {
  pybind11::object function;
  bool is_metric = false;    ///< (n, 3): m11, m12, m22 in (u,v); else sizes (n, 1)
  bool is_in_space = false;  ///< of x, y, z; else of u, v
};

/// When a table is fine enough, and when it must be.
struct TableOptions {
  double precision = 0;  ///< greatest relative error of sizes
  std::size_t max_samples = 0;
};

/// A field source between whose entries sizes are interpolated linearly.
struct TabulatedField {
  FieldSource source;
  double error = 0;         ///< greatest relative error of sizes, measured between entries
  std::size_t samples = 0;  ///< entries
};

/// Tabulate a function on finer and finer grids over the domain of a surface. Bounds of the source
/// are exact, so no small size of the table hides between samples of a run.
///
/// The table is as precise as max_samples allow; `error` tells how precise.
/// Error    measured in the middle of steps
TabulatedField tabulate(const FieldFunction& function, const Surface& surface,
                        const TableOptions& options);

}  // namespace surfmesh::python
