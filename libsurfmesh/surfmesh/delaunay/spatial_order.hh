// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "surfmesh/core/values.hh"

namespace surfmesh {

/// An order of insertion in which neighbours in the list are neighbours in the plane.
///
/// Biased randomised insertion order: rounds each eight times as large as the one before, along a
/// Hilbert curve. Random order makes insertion 40 times slower, one Hilbert curve 10 to 15 %.
/// Deterministic.
///
/// Returns  indices into `points`
/// Cost     O(n log n), about 100 ns a point
/// Source   Amenta, Choi, Rote, Incremental constructions con BRIO (2003)
std::vector<int> spatial_order(const std::vector<Uv>& points);

/// The order of points along one Hilbert curve, for data that is read again and again: points near
/// in the plane are near in memory. Deterministic.
///
/// Returns  indices into `points`
/// Cost     O(n log n), about 100 ns a point
std::vector<int> hilbert_order(const std::vector<Uv>& points);

/// The order of points by cells along one Hilbert curve, about four points per cell if they are
/// spread evenly. Within a cell, points keep their order. Deterministic.
///
/// Returns  indices into `points`
/// Cost     O(n)
std::vector<int> cell_order(std::span<const Uv> points);

}  // namespace surfmesh
