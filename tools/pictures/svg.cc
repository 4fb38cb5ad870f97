// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/svg.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "surfmesh/io/clean_text.hh"

namespace surfmesh {
namespace {

constexpr double kUnitsPerPixel = 10;

long units(double pixels) { return std::lround(kUnitsPerPixel * pixels); }

/// A number of tenths as short as it can be: "-.5", "12", "3.4".
std::string shortest(long tenths) {
  const long whole = std::abs(tenths) / 10, rest = std::abs(tenths) % 10;
  const char* sign = tenths < 0 ? "-" : "";
  if (rest == 0) return fmt::format("{}{}", sign, whole);
  if (whole == 0) return fmt::format("{}.{}", sign, rest);
  return fmt::format("{}{}.{}", sign, whole, rest);
}

/// Two numbers; a sign or a point separates them as well as a blank.
std::string pair(long x, long y) {
  const std::string first = shortest(x), second = shortest(y);
  const bool is_apart =
      second.front() == '-' || (second.front() == '.' && first.find('.') != std::string::npos);
  return fmt::format("{}{}{}", first, is_apart ? "" : " ", second);
}

std::string style_text(const PictureStyle& style) {
  std::string text = fmt::format("fill=\"{}\"", style.fill);
  if (style.stroke != "none") {
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{:.3g}\" stroke-linejoin=\"round\"",
                        style.stroke, style.width);
    if (style.opacity < 1) text += fmt::format(" stroke-opacity=\"{:.3g}\"", style.opacity);
  }
  return text;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : clean_text(text)) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

Svg::Svg(double width, double height, const std::string& background)
    : width_(width), height_(height) {
  if (background != "none") add_rectangle({0, 0}, width, height, {background, "none", 0});
}

void Svg::add_rectangle(PicturePoint corner, double width, double height,
                        const PictureStyle& style) {
  body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n",
                       corner.x, corner.y, width, height, style_text(style));
}

void Svg::add_circle(PicturePoint centre, double radius, const PictureStyle& style) {
  body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", centre.x,
                       centre.y, radius, style_text(style));
}

void Svg::add_polygons(const std::vector<PicturePoints>& polygons, const PictureStyle& style) {
  add_path(polygons, true, style_text(style));
}

void Svg::add_lines(const std::vector<PicturePoints>& lines, const PictureStyle& style) {
  add_path(lines, false, style_text(style));
}

void Svg::begin_frame(const PictureFrame& frame) {
  body_ += fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
      "viewBox=\"{0:.1f} {1:.1f} {2:.1f} {3:.1f}\">\n",
      frame.corner.x, frame.corner.y, frame.width, frame.height);
}

void Svg::end_frame() { body_ += "</svg>\n"; }

void Svg::begin_faces() {
  body_ +=
      "<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\".4\" "
      "stroke-linejoin=\"round\">\n";
}

void Svg::add_faces(const std::vector<PicturePoints>& polygons, const std::string& colour) {
  add_path(polygons, true, fmt::format("color=\"{}\"", colour));
}

void Svg::end_faces() { body_ += "</g>\n"; }

void Svg::add_path(const std::vector<PicturePoints>& lines, bool is_closed,
                   const std::string& style) {
  body_ += fmt::format("<path {} d=\"", style);
  long x = 0, y = 0;  // where the pen is
  for (const std::vector<PicturePoint>& line : lines) {
    if (line.empty()) continue;
    long first_x = 0, first_y = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const long to_x = units(line[i].x), to_y = units(line[i].y);
      const std::string step = pair(to_x - x, to_y - y);
      if (i < 2) body_ += i == 0 ? "m" : "l";
      if (i > 1 && step.front() != '-') body_ += ' ';
      body_ += step;
      x = to_x;
      y = to_y;
      if (i == 0) {
        first_x = x;
        first_y = y;
      }
    }
    if (!is_closed) continue;
    body_ += 'z';  // back to where it began
    x = first_x;
    y = first_y;
  }
  body_ += "\"/>\n";
}

void Svg::add_text(PicturePoint at, std::string_view text, double height, TextAnchor anchor) {
  const char* where = anchor == TextAnchor::Start    ? "start"
                      : anchor == TextAnchor::Middle ? "middle"
                                                     : "end";
  body_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.3g}\" font-family=\"sans-serif\" "
      "text-anchor=\"{}\">{}</text>\n",
      at.x, at.y, height, where, escaped(text));
}

std::string Svg::text() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\">\n{2}</svg>\n",
      width_, height_, body_);
}

std::string grey(double brightness) {
  const int level = static_cast<int>(std::lround(255 * std::clamp(brightness, 0.0, 1.0)));
  return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

}  // namespace surfmesh
