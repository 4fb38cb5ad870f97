// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "surfmesh/cage/cage.hh"

namespace surfmesh {

/// Edges between faces that meet at more than this are features of a mesh, degrees.
inline constexpr double kFeatureAngle = 40;

/// What tag_features has found.
struct SharpFeatures {
  std::size_t creases = 0;  ///< edges that became creases
  std::size_t corners = 0;  ///< vertices that became corners
};

/// Tag the features of a mesh that a surface is to pass through, which otherwise get round.
///
/// Edges between faces that meet at more than an angle become creases if other creases or borders
/// go on at one of their ends, and vertices where a line of creases or the border turns by more
/// than kCornerAngle become corners. Where three lines meet there is a corner anyway. Units
/// degrees; an angle of 0 makes no creases, and corners at borders and tagged creases only Cost O(n
/// log n) for n face corners
SharpFeatures tag_features(double degrees, Cage& cage);

/// A line of creases, or a border, has a corner where it turns by more than this, degrees.
inline constexpr double kCornerAngle = 50;

}  // namespace surfmesh
