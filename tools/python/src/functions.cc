// SPDX-License-Identifier: BSD-3-Clause
#include "functions.hh"

#include <algorithm>

#include "arrays.hh"

namespace surfmesh::python {
namespace {

py::tuple coordinates(std::span<const Uv> uvs) {
  py::array_t<double> u(static_cast<py::ssize_t>(uvs.size()));
  py::array_t<double> v(static_cast<py::ssize_t>(uvs.size()));
  double* const us = u.mutable_data();
  double* const vs = v.mutable_data();
  for (std::size_t i = 0; i < uvs.size(); ++i) {
    us[i] = uvs[i].u;
    vs[i] = uvs[i].v;
  }
  return py::make_tuple(u, v);
}

py::tuple coordinates(std::span<const Uv> uvs, const Surface& surface) {
  const auto count = static_cast<py::ssize_t>(uvs.size());
  py::array_t<double> x(count), y(count), z(count);
  double* const xs = x.mutable_data();
  double* const ys = y.mutable_data();
  double* const zs = z.mutable_data();
  for (std::size_t i = 0; i < uvs.size(); ++i) {
    const Vec3 point = surface.evaluate(uvs[i], Order::Position).point;
    xs[i] = point.x();
    ys[i] = point.y();
    zs[i] = point.z();
  }
  return py::make_tuple(x, y, z);
}

}  // namespace

BatchFunction surface_function(const py::object& function) {
  return [function](std::span<const Uv> uvs, std::span<Vec3> points) {
    const Doubles result = function(*coordinates(uvs)).cast<Doubles>();
    std::copy_n(result.data(), 3 * points.size(), points.front().data());
  };
}

std::vector<double> values_of(const py::object& function, std::span<const Uv> uvs,
                              const Surface* in_space, std::size_t width) {
  std::vector<double> values;
  values.reserve(width * uvs.size());
  for (std::size_t i = 0; i < uvs.size(); i += kBatchSize) {
    const auto batch = uvs.subspan(i, std::min(kBatchSize, uvs.size() - i));
    const auto arguments = in_space ? coordinates(batch, *in_space) : coordinates(batch);
    const Doubles result = function(*arguments).cast<Doubles>();
    values.insert(values.end(), result.data(), result.data() + width * batch.size());
  }
  return values;
}

}  // namespace surfmesh::python
