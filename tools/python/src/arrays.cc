// SPDX-License-Identifier: BSD-3-Clause
#include "arrays.hh"

namespace surfmesh::python {

std::vector<Vec3> points_from(const Doubles& array) {
  const auto rows = array.unchecked<2>();
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    points.emplace_back(rows(i, 0), rows(i, 1), rows(i, 2));
  }
  return points;
}

std::vector<Uv> uvs_from(const Doubles& array) {
  const auto rows = array.unchecked<2>();
  std::vector<Uv> uvs;
  uvs.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) uvs.push_back({rows(i, 0), rows(i, 1)});
  return uvs;
}

std::vector<int> ints_from(const Ints& array) {
  return {array.data(), array.data() + array.size()};
}

}  // namespace surfmesh::python
