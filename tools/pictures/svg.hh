// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pictures/canvas.hh"

namespace surfmesh {

/// A picture in Scalable Vector Graphics, drawn from back to front.
///
/// Coordinates are rounded to a tenth of a pixel, and given as steps, so that a mesh of 40,000
/// triangles takes less than a megabyte.
class Svg : public Canvas {
 public:
  /// A picture of so many pixels before a background: a colour, or "none".
  Svg(double width, double height, const std::string& background = "#ffffff");

  void add_rectangle(PicturePoint corner, double width, double height,
                     const PictureStyle& style) override;
  void add_circle(PicturePoint centre, double radius, const PictureStyle& style);
  void add_polygons(const std::vector<PicturePoints>& polygons, const PictureStyle& style) override;
  void add_lines(const std::vector<PicturePoints>& lines, const PictureStyle& style) override;
  void add_text(PicturePoint at, std::string_view text, double height,
                TextAnchor anchor = TextAnchor::Start) override;

  /// What is drawn until end_frame() is cut off at the frame.
  void begin_frame(const PictureFrame& frame);
  void end_frame();

  /// The faces that are added until end_faces() have lines of their own colour around them, a
  /// little wide, so that the background does not shine through between them.
  void begin_faces();
  void add_faces(const std::vector<PicturePoints>& polygons, const std::string& colour);
  void end_faces();

  /// The whole file.
  std::string text() const;

 private:
  void add_path(const std::vector<PicturePoints>& lines, bool is_closed, const std::string& style);

  double width_;
  double height_;
  std::string body_;
};

/// "#808080" for 0.5: from black (0) to white (1).
std::string grey(double brightness);

}  // namespace surfmesh
