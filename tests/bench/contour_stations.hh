// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bench/graded_sizes.hh"
#include "bench/size_graph.hh"

namespace surfmesh::judge {

/// The first form at a point of the bounding rectangle of the domain, as SizeField::at.
FirstFormFactor form_at(const Surface& surface, Uv uv);

/// The exact size at a point, in the tangent frame there. Where there is none, at a pole, those
/// beside it.
SizedPoint sized_point(const SizeField& field, Uv uv);

/// A point of a contour as one of its patches sees it.
struct StationSide {
  Uv uv;
  SizedPoint point;
  double cos = 1;  ///< of the angle from the first tangent axis to the contour's direction
  double sin = 0;
};

/// The same as all its patches see it, by use.
using Station = std::vector<StationSide>;

/// Points along a contour, about two in each step of the finest grid that it passes. None at poles
/// and where a patch has no tangent plane.
std::vector<Station> make_stations(const Model& model, const Contour& contour,
                                   const SizeFields& fields, const std::vector<PatchGrid>& grids);

}  // namespace surfmesh::judge
