// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "support/tensors.hh"
#include "surfmesh/control/control_mesh.hh"
#include "surfmesh/metric/size_tensor.hh"

/// Control nodes of a plane whose parameters are its coordinates.
namespace surfmesh::testing {

inline constexpr FirstFormFactor kFlat{1, 0, 1};

inline ControlNode node(Uv uv, const SizeTensor& size, const FirstFormFactor& form = kFlat) {
  return {uv, Vec3(uv.u, uv.v, 0), form, size};
}

/// The metric of a control space of the plane.
class PlaneField : public MetricField {
 public:
  explicit PlaneField(const ControlSpace& control) : control_(control) {}

  Metric at(Uv uv, QueryHint& hint) const override {
    return control_.metric({uv, Vec3(uv.u, uv.v, 0), kFlat}, hint);
  }

 private:
  const ControlSpace& control_;
};

/// n × n nodes of the plane, rows along u.
inline std::vector<ControlNode> grid(const Domain& domain, int n,
                                     const std::function<SizeTensor(Uv)>& size) {
  std::vector<ControlNode> nodes;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Uv uv = domain.at(double(i) / (n - 1), double(j) / (n - 1));
      nodes.push_back(node(uv, size(uv)));
    }
  }
  return nodes;
}

/// The four corners of a domain and what else is given.
inline std::vector<ControlNode> with_corners(const Domain& domain, const SizeTensor& size,
                                             const std::vector<ControlNode>& others) {
  std::vector<ControlNode> nodes = others;
  for (int i = 0; i < 4; ++i) nodes.push_back(node(domain.corner(i), size));
  return nodes;
}

inline std::vector<Uv> random_points(const Domain& domain, int count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Uv> points;
  for (int i = 0; i < count; ++i) {
    const double s = uniform(random);
    points.push_back(domain.at(s, uniform(random)));
  }
  return points;
}

/// Nodes at random places of the unit square with random sizes, and its corners.
inline std::vector<ControlNode> random_nodes(int count) {
  const auto sizes = random_sizes(count, 10);
  const auto points = random_points({}, count);
  std::vector<ControlNode> nodes = with_corners({}, isotropic(0.01), {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    nodes.push_back(node(points[i], scaled(sizes[i], 0.01)));
  }
  return nodes;
}

/// A point of that plane, seen through any first form.
inline SurfacePoint place(Uv uv, const FirstFormFactor& form = kFlat) {
  return {uv, Vec3(uv.u, uv.v, 0), form};
}

/// The sizes at a point, asked for by somebody who comes for the first time.
inline SizeTensor query(const ControlSpace& control, Uv uv, const FirstFormFactor& form = kFlat) {
  QueryHint hint;
  return control.size(place(uv, form), hint);
}

}  // namespace surfmesh::testing
