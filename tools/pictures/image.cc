// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/image.hh"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pictures/stroke_font.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

/// Rows that one thread draws at a time.
constexpr std::size_t kBandRows = 32;

/// Samples along each side of a pixel, for polygons.
constexpr int kSamples = 4;

/// How far a line reaches beyond its rim, where it covers pixels in part.
constexpr double kRim = 0.5;

Rgb parse(const std::string& hex) {
  const auto part = [&](std::size_t at) {
    return std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
  };
  return {part(1), part(3), part(5)};
}

/// A band of rows of a picture.
struct Band {
  std::size_t first = 0, end = 0, width = 0;

  /// Pixels from `low` to `high`, cut to `count`.
  static std::pair<std::size_t, std::size_t> range(double low, double high, std::size_t from,
                                                   std::size_t to) {
    const double least = static_cast<double>(from), greatest = static_cast<double>(to);
    const double a = std::clamp(std::floor(low), least, greatest);
    const double b = std::clamp(std::ceil(high), least, greatest);
    return {static_cast<std::size_t>(a), static_cast<std::size_t>(b)};
  }
};

/// The share of each pixel that a segment covers, where it is more than before.
void cover_segment(const Band& band, PicturePoint a, PicturePoint b, double width,
                   std::vector<float>& coverage) {
  const double half = 0.5 * width, reach = half + kRim, most = std::min(width, 1.0);
  const auto [top, bottom] =
      Band::range(std::min(a.y, b.y) - reach, std::max(a.y, b.y) + reach, band.first, band.end);
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double length = std::sqrt(square);
  for (std::size_t row = top; row < bottom; ++row) {
    const double y = static_cast<double>(row) + 0.5;
    double low = std::min(a.x, b.x) - reach, high = std::max(a.x, b.x) + reach;
    if (std::abs(dy) > 0) {
      // Where the strip around the line crosses this row.
      const double middle = a.x + (y - a.y) * dx / dy, half_width = reach * length / std::abs(dy);
      low = std::max(low, middle - half_width);
      high = std::min(high, middle + half_width);
    }
    const auto [left, right] = Band::range(low, high, 0, band.width);
    for (std::size_t column = left; column < right; ++column) {
      const double x = static_cast<double>(column) + 0.5;
      const double t =
          square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
      const double distance = std::hypot(x - a.x - t * dx, y - a.y - t * dy);
      const auto share = static_cast<float>(std::clamp(half + kRim - distance, 0.0, most));
      float& old = coverage[(row - band.first) * band.width + column];
      old = std::max(old, share);
    }
  }
}

/// Where the sides of a polygon cross a horizontal line, from left to right.
std::vector<double> crossings(const PicturePoints& polygon, double y) {
  std::vector<double> found;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PicturePoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    found.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::sort(found.begin(), found.end());
  return found;
}

void cover_polygon(const Band& band, const PicturePoints& polygon, std::vector<float>& coverage) {
  const auto [low, high] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const auto [top, bottom] = Band::range(low->y, high->y, band.first, band.end);
  for (std::size_t row = top; row < bottom; ++row) {
    float* pixels = coverage.data() + (row - band.first) * band.width;
    for (int sample = 0; sample < kSamples; ++sample) {
      const std::vector<double> at =
          crossings(polygon, static_cast<double>(row) + (sample + 0.5) / kSamples);
      for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
        const auto [left, right] = Band::range(at[i], at[i + 1], 0, band.width);
        for (std::size_t column = left; column < right; ++column) {
          const double x = static_cast<double>(column);
          const double share = std::min(at[i + 1], x + 1) - std::max(at[i], x);
          pixels[column] = std::min(1.0F, pixels[column] + static_cast<float>(share / kSamples));
        }
      }
    }
  }
}

/// A byte of an 8-bit picture.
std::uint8_t byte(float part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
}

}  // namespace

void Image::put_behind(const Rgb& colour) {
  const std::array parts = {colour.red, colour.green, colour.blue};
  for (Pixel& pixel : pixels_) {
    const float share = 1 - pixel[3];
    for (std::size_t i = 0; i < 3; ++i) pixel[i] += share * static_cast<float>(parts[i]);
    pixel[3] = 1;
  }
}

void Image::mix(const std::vector<float>& coverage, std::size_t first_row, const Rgb& colour,
                double opacity) {
  const Pixel parts = {static_cast<float>(colour.red), static_cast<float>(colour.green),
                       static_cast<float>(colour.blue), 1};
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const float share = coverage[i] * static_cast<float>(opacity);
    if (share <= 0) continue;
    Pixel& pixel = pixels_[first_row * width_ + i];
    for (std::size_t part = 0; part < 4; ++part) {
      pixel[part] += share * (parts[part] - pixel[part]);
    }
  }
}

void Image::add_lines(const std::vector<PicturePoints>& lines, const PictureStyle& style) {
  const Rgb colour = parse(style.stroke);
  share_indices((height_ + kBandRows - 1) / kBandRows, [&](std::size_t i) {
    const Band band{i * kBandRows, std::min(height_, (i + 1) * kBandRows), width_};
    std::vector<float> coverage((band.end - band.first) * width_, 0);
    for (const PicturePoints& line : lines) {
      for (std::size_t p = 1; p < line.size(); ++p) {
        cover_segment(band, line[p - 1], line[p], style.width, coverage);
      }
    }
    mix(coverage, band.first, colour, style.opacity);
  });
}

void Image::add_closed_lines(const std::vector<PicturePoints>& polygons,
                             const PictureStyle& style) {
  std::vector<PicturePoints> lines = polygons;
  for (PicturePoints& line : lines) {
    if (!line.empty()) line.push_back(line.front());
  }
  add_lines(lines, style);
}

void Image::add_polygons(const std::vector<PicturePoints>& polygons, const PictureStyle& style) {
  if (style.fill != "none") {
    const Rgb colour = parse(style.fill);
    share_indices((height_ + kBandRows - 1) / kBandRows, [&](std::size_t i) {
      const Band band{i * kBandRows, std::min(height_, (i + 1) * kBandRows), width_};
      std::vector<float> coverage((band.end - band.first) * width_, 0);
      for (const PicturePoints& polygon : polygons) {
        if (!polygon.empty()) cover_polygon(band, polygon, coverage);
      }
      mix(coverage, band.first, colour, 1);
    });
  }
  if (style.stroke != "none") add_closed_lines(polygons, style);
}

void Image::add_text(PicturePoint at, std::string_view text, double height, TextAnchor anchor) {
  constexpr double kStrokeShare = 0.09;  // of the height
  const double width = text_width(text, height);
  const double left = anchor == TextAnchor::Start    ? at.x
                      : anchor == TextAnchor::Middle ? at.x - 0.5 * width
                                                     : at.x - width;
  std::vector<PicturePoints> lines = text_lines(text, height);
  for (PicturePoints& line : lines) {
    for (PicturePoint& point : line) point = {left + point.x, at.y + point.y};
  }
  add_lines(lines, {"none", "#000000", std::max(1.0, kStrokeShare * height)});
}

std::string Image::png() const {
  const bool is_opaque =
      std::all_of(pixels_.begin(), pixels_.end(), [](const Pixel& pixel) { return pixel[3] >= 1; });
  const std::size_t parts = is_opaque ? 3 : 4;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(parts * pixels_.size());
  for (const Pixel& pixel : pixels_) {
    const float opacity = pixel[3] > 0 ? pixel[3] : 1;
    for (std::size_t i = 0; i < 3; ++i) bytes.push_back(byte(pixel[i] / opacity));
    if (!is_opaque) bytes.push_back(byte(pixel[3]));
  }
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = is_opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if (png_image_write_to_memory(&image, file.data(), &size, 0, bytes.data(), 0, nullptr) == 0) {
    throw Error(ErrorCode::Io, fmt::format("cannot make the picture: {}", image.message));
  }
  file.resize(size);
  return file;
}

}  // namespace surfmesh
