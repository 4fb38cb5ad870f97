// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "compare/triangle_file.hh"

namespace surfmesh::compare {

using MetricFunction = std::function<Metric(Uv)>;

/// A mesh of a plane domain against a metric.
struct Judgement {
  std::size_t triangles = 0;
  double mean = 0;           ///< of the metric lengths of the edges
  double stddev = 0;         ///< of the same, the whole population
  double unit_fraction = 0;  ///< share of them in [1/√2, √2]
  double least_quality = 0;
  double mean_quality = 0;
  double area = 0;  ///< in (u,v), of all triangles

  friend bool operator==(const Judgement&, const Judgement&) = default;
};

/// Judge a mesh by its x and y.
///
/// The length of an edge is the integral of √(eᵀMe) along it, by five points of Gauss; the quality
/// of a triangle is 4√3 A_M / Σl² in the metric at its barycentre. A mesh that is turned over as a
/// whole is turned back first.
/// Pre      there is a triangle
Judgement judge_plane(const TriangleMesh& mesh, const MetricFunction& metric);

}  // namespace surfmesh::compare
