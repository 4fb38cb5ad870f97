// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "compare/exact_metric.hh"

namespace surfmesh::compare {

/// The metric at the nodes of a regular grid of a rectangle, rows along u: what other programs get.
struct Background {
  Domain domain;
  int cells = 0;  ///< in each direction
  bool is_isotropic = false;
  std::vector<Metric> metrics;  ///< by node
};

Background sample_background(const ExactMetric& metric, int cells, bool is_isotropic);

/// Write a mesh of the grid for BAMG and Mmg2d, with its border and its corners, and the metric
/// next to it: <stem>.mesh, <stem>.mtr (BAMG) and <stem>.sol (Mmg2d).
///
/// Throws   Io
void write_background(const Background& background, const std::filesystem::path& stem);

/// Write the grid with its metric as a view of Gmsh: <stem>.msh.
///
/// Throws   Io
void write_gmsh_view(const Background& background, const std::filesystem::path& stem);

/// Write the rectangle as a geometry of Gmsh whose sizes come from the view alone.
///
/// Throws   Io
void write_gmsh_square(const Background& background, const std::filesystem::path& path);

}  // namespace surfmesh::compare
