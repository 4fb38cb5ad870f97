// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "surfmesh/quality/mesh_field.hh"

namespace surfmesh {

/// A colour as screens show it (sRGB), each from 0 to 1.
struct Rgb {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// "#1f9e89".
std::string hex(const Rgb& colour);

/// Colours from a least to a greatest value.
enum class ColourMap {
  Amounts,    ///< dark to light: more is no worse
  Goodness,   ///< red over yellow to green: more is better
  Deviations  ///< blue over grey to red: the middle is wanted
};

/// The colours of a map at even steps from 0 to 1, between which they are interpolated.
std::span<const Rgb> stops(ColourMap map);

/// The colour at a share from 0 to 1; others count as the nearest of these.
Rgb colour_at(ColourMap map, double share);

/// Colours of patches and groups: neighbouring indices differ clearly, none is dark.
Rgb category_colour(std::size_t index);

/// What has no value.
inline constexpr Rgb kNoValueColour = {0.8, 0.8, 0.8};

/// How values become colours.
struct ColourScale {
  ColourMap map = ColourMap::Amounts;
  double from = 0;
  double to = 1;
  bool is_log = false;  ///< shares are those of logarithms

  /// The share of a value, from 0 to 1.
  double share(double value) const;
};

/// The scale that suits a field: quality and shape from 0 to 1, lengths from ½ to 2, valences
/// around 6, or 4 where most faces are quads, the others over their finite values.
ColourScale scale_of(MeshField field, const std::vector<double>& values, bool is_of_quads);

}  // namespace surfmesh
