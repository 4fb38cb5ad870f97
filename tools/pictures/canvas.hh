// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surfmesh {

/// A point of a picture: pixels, y downwards.
struct PicturePoint {
  double x = 0;
  double y = 0;
};

/// Points of a line, or corners of a polygon.
using PicturePoints = std::vector<PicturePoint>;

/// A part of a picture, pixels.
struct PictureFrame {
  PicturePoint corner;  ///< upper left
  double width = 0;
  double height = 0;
};

/// How a shape is drawn; "none" leaves out its lines, or its inside.
struct PictureStyle {
  std::string fill = "none";
  std::string stroke = "none";
  double width = 1;    ///< of lines, pixels
  double opacity = 1;  ///< of lines
};

enum class TextAnchor { Start, Middle, End };

/// What pictures are drawn on, from back to front. Colours are those of PictureStyle.
class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// Polygons of one style, each closed, that do not overlap.
  virtual void add_polygons(const std::vector<PicturePoints>& polygons,
                            const PictureStyle& style) = 0;

  /// Open lines of one style; where they overlap they are no darker.
  virtual void add_lines(const std::vector<PicturePoints>& lines, const PictureStyle& style) = 0;

  /// A line of text of a height in pixels; `at` lies on its base line.
  virtual void add_text(PicturePoint at, std::string_view text, double height,
                        TextAnchor anchor = TextAnchor::Start) = 0;

  virtual void add_rectangle(PicturePoint corner, double width, double height,
                             const PictureStyle& style) {
    const double right = corner.x + width, bottom = corner.y + height;
    add_polygons({{corner, {right, corner.y}, {right, bottom}, {corner.x, bottom}}}, style);
  }
};

}  // namespace surfmesh
