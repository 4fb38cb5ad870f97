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

/// How a shape is drawn; "none" leaves out its lines, or its inside.
struct PictureStyle {
  std::string fill = "none";
  std::string stroke = "none";
  double width = 1;  ///< of lines, pixels
};

enum class TextAnchor { Start, Middle, End };

/// A picture in Scalable Vector Graphics, drawn from back to front.
///
/// Coordinates are rounded to a tenth of a pixel, and given as steps, so that a mesh of 40,000
/// triangles takes less than a megabyte.
class Svg {
 public:
  /// A white picture of so many pixels.
  Svg(double width, double height);

  void add_rectangle(PicturePoint corner, double width, double height, const PictureStyle& style);
  void add_circle(PicturePoint centre, double radius, const PictureStyle& style);

  /// Polygons of one style, each closed.
  void add_polygons(const std::vector<std::vector<PicturePoint>>& polygons,
                    const PictureStyle& style);

  /// Open lines of one style.
  void add_lines(const std::vector<std::vector<PicturePoint>>& lines, const PictureStyle& style);

  /// A line of text of a height in pixels; `at` lies on its base line.
  void add_text(PicturePoint at, std::string_view text, double height,
                TextAnchor anchor = TextAnchor::Start);

  /// The whole file.
  std::string text() const;

 private:
  void add_path(const std::vector<std::vector<PicturePoint>>& lines, bool is_closed,
                const PictureStyle& style);

  double width_;
  double height_;
  std::string body_;
};

/// "#808080" for 0.5: from black (0) to white (1).
std::string grey(double brightness);

}  // namespace surfmesh
