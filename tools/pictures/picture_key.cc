// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/picture_key.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "pictures/stroke_font.hh"

namespace surfmesh {
namespace {

/// In heights of text: width of the bar and of the squares at names, gaps, distance of lines.
constexpr double kBarWidth = 1.3, kSquare = 0.9, kGap = 0.45, kLine = 1.5;

/// Titles are broken, and names cut, at so many signs.
constexpr std::size_t kTitleSigns = 16, kNameSigns = 22;

/// Rectangles of one colour that make a bar.
constexpr int kBarSteps = 96;

/// Steps between ticks that are wanted at most, and signs of numbers.
constexpr double kKeySteps = 6;

std::string number_text(double value) { return fmt::format("{:.4g}", value + 0.0); }

/// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> even_values(double from, double to) {
  std::vector<double> values;
  const double step = round_step((to - from) / kKeySteps);
  const double first = std::ceil(from / step - 1e-6), last = std::floor(to / step + 1e-6);
  for (double i = first; i <= last && std::isfinite(step); ++i) values.push_back(i * step);
  return values;
}

/// Of so many decades all these multiples of powers of ten, or fewer.
std::vector<double> decade_values(double from, double to) {
  const double decades = std::log10(to / from);
  const double stride = std::max(1.0, std::ceil(decades / kKeySteps));
  std::vector<double> factors = {1};
  if (decades < 4) factors = {1, 3};
  if (decades < 2.2) factors = {1, 2, 5};
  std::vector<double> values;
  for (double power = std::floor(std::log10(from)); power <= std::log10(to); power += stride) {
    for (const double factor : factors) {
      const double value = factor * std::pow(10, power);
      if (value >= from * (1 - 1e-6) && value <= to * (1 + 1e-6)) values.push_back(value);
    }
  }
  return values;
}

/// Lines of at most so many signs, broken at blanks.
std::vector<std::string> broken(std::string_view text, std::size_t signs) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = text.size();
    if (end > signs) {
      end = text.rfind(' ', signs);
      if (end == text.npos) end = std::min(text.find(' '), text.size());
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return lines;
}

std::string cut(const std::string& name) {
  if (name.size() <= kNameSigns) return name;
  std::size_t end = kNameSigns - 3;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return name.substr(0, end) + "...";
}

void draw_bar(Canvas& canvas, const ColourScale& scale, const PictureFrame& bar,
              double text_height) {
  // On whole pixels, so that no background shines through between the steps.
  const double left = std::round(bar.corner.x), top = std::round(bar.corner.y);
  const double height = std::round(bar.height), width = std::round(bar.width);
  for (int i = 0; i < kBarSteps; ++i) {
    const double from = std::round(height * i / kBarSteps),
                 to = std::round(height * (i + 1) / kBarSteps);
    if (!(to > from)) continue;
    const Rgb colour = colour_at(scale.map, (i + 0.5) / kBarSteps);
    canvas.add_rectangle({left, top + height - to}, width, to - from, {hex(colour), "none", 0});
  }
  const double line = std::max(0.6, 0.06 * text_height);
  canvas.add_rectangle({left, top}, width, height, {"none", "#000000", line});
  std::vector<PicturePoints> marks;
  for (const ScaleTick& tick : scale_ticks(scale)) {
    const double y = top + height * (1 - tick.share);
    marks.push_back({{left + width, y}, {left + width + kGap * text_height, y}});
    canvas.add_text({left + width + 2 * kGap * text_height, y + 0.35 * text_height}, tick.text,
                    text_height);
  }
  canvas.add_lines(marks, {"none", "#000000", line});
}

}  // namespace

std::vector<ScaleTick> scale_ticks(const ColourScale& scale) {
  if (!(scale.to > scale.from)) return {{number_text(scale.from), 0.5}};
  std::vector<double> values;
  if (scale.is_log) values = decade_values(scale.from, scale.to);
  if (values.size() < 3) values = even_values(scale.from, scale.to);
  if (values.size() < 2) values = {scale.from, scale.to};
  std::vector<ScaleTick> ticks;
  for (const double value : values) ticks.push_back({number_text(value), scale.share(value)});
  return ticks;
}

double key_width(const PictureKey& key, double text_height) {
  if (key.is_empty()) return 0;
  double width = 0;
  for (const std::string& line : broken(key.title, kTitleSigns)) {
    width = std::max(width, text_width(line, text_height));
  }
  if (key.scale) {
    for (const ScaleTick& tick : scale_ticks(*key.scale)) {
      width = std::max(width,
                       (kBarWidth + 2 * kGap) * text_height + text_width(tick.text, text_height));
    }
  }
  for (const auto& [name, colour] : key.names) {
    width = std::max(width, (kSquare + kGap) * text_height + text_width(cut(name), text_height));
  }
  return width + 1.2 * text_height;
}

void draw_key(Canvas& canvas, const PictureKey& key, const PictureFrame& frame,
              double text_height) {
  if (key.is_empty()) return;
  const std::vector<std::string> title = broken(key.title, kTitleSigns);
  const double line = kLine * text_height, left = frame.corner.x;
  const double title_height = line * static_cast<double>(title.size());
  const double room = std::max(0.0, frame.height - title_height - 2 * line);
  const auto fitting = std::max(static_cast<std::size_t>(room / line), std::size_t{2});
  const bool has_more = key.names.size() > fitting;
  const std::size_t shown = has_more ? fitting - 1 : key.names.size();
  const double body =
      key.scale ? 0.8 * room : line * static_cast<double>(shown + (has_more ? 1 : 0));
  double y = frame.corner.y + 0.5 * std::max(0.0, frame.height - title_height - body);
  for (const std::string& words : title) {
    canvas.add_text({left, y + 0.8 * text_height}, words, text_height);
    y += line;
  }
  if (key.scale) {
    draw_bar(canvas, *key.scale, {{left, y}, kBarWidth * text_height, body}, text_height);
    return;
  }
  const double square = kSquare * text_height;
  for (std::size_t i = 0; i < shown; ++i, y += line) {
    const auto& [name, colour] = key.names[i];
    canvas.add_rectangle({left, y}, square, square, {hex(colour), "#000000", 0.5});
    canvas.add_text({left + square + kGap * text_height, y + 0.8 * text_height}, cut(name),
                    text_height);
  }
  if (has_more) {
    canvas.add_text({left, y + 0.8 * text_height},
                    fmt::format("and {} more", key.names.size() - shown), text_height);
  }
}

}  // namespace surfmesh
