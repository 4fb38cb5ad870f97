// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pictures/canvas.hh"
#include "pictures/colours.hh"

namespace surfmesh {

/// A picture of pixels, in red, green, blue and opacity from 0 to 1. Colours are mixed as screens
/// show them, which is how viewers draw SVG.
class Image : public Canvas {
 public:
  using Pixel = std::array<float, 4>;  ///< red, green and blue are multiplied by the opacity

  /// Of no opacity.
  Image(std::size_t width, std::size_t height)
      : width_(width), height_(height), pixels_(width * height, Pixel{}) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  Pixel& at(std::size_t column, std::size_t row) { return pixels_[row * width_ + column]; }
  const Pixel& at(std::size_t column, std::size_t row) const {
    return pixels_[row * width_ + column];
  }

  /// Put a colour behind all.
  void put_behind(const Rgb& colour);

  void add_polygons(const std::vector<PicturePoints>& polygons, const PictureStyle& style) override;
  void add_lines(const std::vector<PicturePoints>& lines, const PictureStyle& style) override;
  void add_text(PicturePoint at, std::string_view text, double height,
                TextAnchor anchor = TextAnchor::Start) override;

  /// The file, in Portable Network Graphics: with an opacity only where it is not 1 everywhere.
  std::string png() const;

 private:
  void mix(const std::vector<float>& coverage, std::size_t first_row, const Rgb& colour,
           double opacity);
  void add_closed_lines(const std::vector<PicturePoints>& polygons, const PictureStyle& style);

  std::size_t width_;
  std::size_t height_;
  std::vector<Pixel> pixels_;
};

}  // namespace surfmesh
