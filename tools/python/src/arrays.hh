// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh::python {

namespace py = pybind11;

/// Arrays as the package hands them over: it has checked their shapes and values.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;

std::vector<Vec3> points_from(const Doubles& array);
std::vector<Uv> uvs_from(const Doubles& array);
std::vector<int> ints_from(const Ints& array);

/// Hand a vector over to NumPy without a copy; a shape of one dimension is that of the vector.
template <class T>
py::array_t<T> to_array(std::vector<T> values) {
  auto held = std::make_unique<std::vector<T>>(std::move(values));
  const auto size = static_cast<py::ssize_t>(held->size());
  T* const first = held->data();
  const py::capsule owner(held.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>({size}, {static_cast<py::ssize_t>(sizeof(T))}, first, owner);
}

/// The same in rows of so many values.
template <class T>
py::array_t<T> to_array(std::vector<T> values, std::size_t width) {
  const auto rows = static_cast<py::ssize_t>(values.size() / width);
  return to_array(std::move(values)).reshape({rows, static_cast<py::ssize_t>(width)});
}

}  // namespace surfmesh::python
