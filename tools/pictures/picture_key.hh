// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pictures/canvas.hh"
#include "pictures/colours.hh"

namespace surfmesh {

/// What the colours of a picture mean: a bar of amounts, or names. Of nothing, if both are empty.
struct PictureKey {
  std::string title;
  std::optional<ColourScale> scale = {};
  std::vector<std::pair<std::string, Rgb>> names = {};

  bool is_empty() const { return !scale && names.empty(); }
};

/// A value that is written at a bar, and its share of the bar.
struct ScaleTick {
  std::string text;
  double share = 0;
};

/// About five round numbers within a scale, ascending; of a scale of one value that value.
std::vector<ScaleTick> scale_ticks(const ColourScale& scale);

/// Pixels that a key takes beside a picture.
double key_width(const PictureKey& key, double text_height);

/// Draw a key in the middle of the left of a frame: as many names as fit, and how many more there
/// are.
void draw_key(Canvas& canvas, const PictureKey& key, const PictureFrame& frame, double text_height);

}  // namespace surfmesh
