// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/stroke_font.hh"

#include <algorithm>
#include <array>
#include <cstddef>

namespace surfmesh {
namespace {

/// A sign as strokes, with blanks between. A point is a digit for x and a letter for y: e lies on
/// the base line, m at the top of small letters, q at that of capitals, a below. Strokes that begin
/// with ~ are smooth.
struct Glyph {
  std::string_view strokes;
  double width = 0;
};

constexpr double kCapitalHeight = 12, kCapitalShare = 0.72, kGlyphGap = 3;
constexpr char kFirst = ' ', kLast = '~';

constexpr std::array<Glyph, kLast - kFirst + 1> kGlyphs = {{
    {"", 3},
    {"0q0h 0f0e", 0},
    {"0q0n 2q2n", 2},
    {"2e3q 5e6q 0l7l 0i7i", 7},
    {"~6n5p3p1p0n1l3k5j6h5f3f1f0g 3r3d", 6},
    {"0e7q ~1q2p2n1m0n0p1q ~6i7h7f6e5f5h6i", 7},
    {"7e1n ~1n1p2q4p4n2k0i0g1e3e5f7j", 7},
    {"0q0n", 0},
    {"~2q0m0g2c", 2},
    {"~0q2m2g0c", 2},
    {"3n3h 0m6i 6m0i", 6},
    {"0j6j 3m3g", 6},
    {"1f1e0c", 1},
    {"0j4j", 4},
    {"0e0f", 0},
    {"0d5q", 5},
    {"~3q5p6m6i5f3e1f0i0m1p3q", 6},
    {"1o3q3e", 4},
    {"~0n1p3q5p6n5k0e 0e6e", 6},
    {"~0o1p3q5p6n5l3k ~3k5j6h5f3e1f0g", 6},
    {"5e5q0h7h", 7},
    {"6q1q0k ~0k2l4l6j6h5f3e1f0g", 6},
    {"~5p3q1o0k0h1f3e5f6h5k3l1k0i", 6},
    {"0q6q2e", 6},
    {"~3q5p5m3k1m1p3q ~3k5j6h5f3e1f0h1j3k", 6},
    {"~6m5j3i1j0m1p3q5p6m ~6m6i5f3e1f", 6},
    {"0k0j 0f0e", 0},
    {"1k1j 1f1e0c", 1},
    {"6n0j6f", 6},
    {"0l6l 0h6h", 6},
    {"0n6j0f", 6},
    {"~0n1p3q5p6n5l3j3h 3f3e", 6},
    {"~5j4k3k2j2h3g4g5h 5k5g ~5g7g7j6m4n2n0l0h1f3e5e", 7},
    {"0e4q8e 1i7i", 8},
    {"0e0q4q ~4q6p6l4k 0k4k ~4k7j7f4e 4e0e", 7},
    {"~7o5q3q1o0l0h1f3e5e7g", 7},
    {"0e0q3q ~3q6o7l7h6f3e 3e0e", 7},
    {"6q0q0e6e 0k5k", 6},
    {"6q0q0e 0k5k", 6},
    {"~7o5q3q1o0l0h1f3e5e7g 7g7j4j", 7},
    {"0e0q 7e7q 0k7k", 7},
    {"0e0q", 0},
    {"4q4h ~4h3e1e0g", 4},
    {"0e0q 6q0i 2k6e", 6},
    {"0q0e5e", 5},
    {"0e0q4h8q8e", 8},
    {"0e0q7e7q", 7},
    {"~4q6p8m8i6f4e2f0i0m2p4q", 8},
    {"0e0q4q ~4q6p7n6l4k 4k0k", 7},
    {"~4q6p8m8i6f4e2f0i0m2p4q 5h8d", 8},
    {"0e0q4q ~4q6p7n6l4k 4k0k 4k7e", 7},
    {"~6o5p3q1p0n1l3k5j6h5f3e1f0g", 6},
    {"0q8q 4q4e", 8},
    {"0q0i ~0i1f3e4e6f7i 7i7q", 7},
    {"0q4e8q", 8},
    {"0q2e4n6e8q", 8},
    {"0q7e 7q0e", 7},
    {"0q4j8q 4j4e", 8},
    {"0q7q0e7e", 7},
    {"2q0q0c2c", 2},
    {"0q5d", 5},
    {"0q2q2c0c", 2},
    {"0m3q6m", 6},
    {"0c6c", 6},
    {"0q2n", 2},
    {"6m6e ~6j5l3m1l0j0h1f3e5f6h", 6},
    {"0q0e ~0j1l3m5l6j6h5f3e1f0h", 6},
    {"~6k5l3m1l0j0h1f3e5f6g", 6},
    {"6q6e ~6j5l3m1l0j0h1f3e5f6h", 6},
    {"0i6i ~6i6k5l3m1l0j0h1f3e5f6g", 6},
    {"~4q3q2o2m 2m2e 0m4m", 4},
    {"6m6d ~6d5b3a1b ~6j5l3m1l0j0h1f3e5f6h", 6},
    {"0q0e ~0j1l3m5l6j 6j6e", 6},
    {"0m0e 0p0q", 0},
    {"2m2c ~2c1a0a 2p2q", 2},
    {"0q0e 5m0h 2j5e", 5},
    {"0q0e", 0},
    {"0m0e ~0j1l2m4l4j 4j4e ~4j5l6m8l8j 8j8e", 8},
    {"0m0e ~0j1l3m5l6j 6j6e", 6},
    {"~3m5l6j6h5f3e1f0h0j1l3m", 6},
    {"0m0a ~0j1l3m5l6j6h5f3e1f0h", 6},
    {"6m6a ~6j5l3m1l0j0h1f3e5f6h", 6},
    {"0m0e ~0j1l2m4m", 4},
    {"~5k4l3m1l0k1j3i5h5g4e2e0g", 5},
    {"2p2g ~2g3e5e 0m5m", 5},
    {"0m0h ~0h1f3e5f6h 6m6e", 6},
    {"0m3e6m", 6},
    {"0m2e4l6e8m", 8},
    {"0m6e 6m0e", 6},
    {"0m3e 6m2b0a", 6},
    {"0m6m0e6e", 6},
    {"~3q2p2l1j0j ~0j1j2h2d3c", 3},
    {"0q0c", 0},
    {"~0q1p1l2j3j ~3j2j1h1d0c", 3},
    {"~0j2k4i6j", 6},
}};

/// Pieces of a smooth line between two of its points.
constexpr int kPieces = 5;

const Glyph& glyph_of(char sign) {
  const bool is_known = sign >= kFirst && sign <= kLast;
  return kGlyphs[static_cast<std::size_t>((is_known ? sign : '?') - kFirst)];
}

/// True for the bytes that go on with a sign in UTF-8.
bool is_continued(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

PicturePoints points_of(std::string_view stroke) {
  PicturePoints points;
  for (std::size_t i = 0; i + 1 < stroke.size(); i += 2) {
    points.push_back({double(stroke[i] - '0'), double(stroke[i + 1] - 'e')});
  }
  return points;
}

/// A Catmull-Rom spline through the points, closed if they end where they begin.
PicturePoints smoothed(const PicturePoints& points) {
  const std::size_t n = points.size();
  const bool is_closed = points.front().x == points.back().x && points.front().y == points.back().y;
  PicturePoints line = {points.front()};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const PicturePoint &b = points[i], &c = points[i + 1];
    const PicturePoint& a = i > 0 ? points[i - 1] : is_closed ? points[n - 2] : b;
    const PicturePoint& d = i + 2 < n ? points[i + 2] : is_closed ? points[1] : c;
    for (int step = 1; step <= kPieces; ++step) {
      const double t = double(step) / kPieces, t2 = t * t, t3 = t2 * t;
      const auto at = [&](double p, double q, double r, double s) {
        return 0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t2 +
                      (3 * q - p - 3 * r + s) * t3);
      };
      line.push_back({at(a.x, b.x, c.x, d.x), at(a.y, b.y, c.y, d.y)});
    }
  }
  return line;
}

void add_glyph(const Glyph& glyph, double left, double scale, std::vector<PicturePoints>& lines) {
  std::string_view rest = glyph.strokes;
  while (!rest.empty()) {
    std::string_view stroke = rest.substr(0, rest.find(' '));
    rest.remove_prefix(std::min(rest.size(), stroke.size() + 1));
    const bool is_smooth = stroke.front() == '~';
    if (is_smooth) stroke.remove_prefix(1);
    PicturePoints line = points_of(stroke);
    if (is_smooth) line = smoothed(line);
    for (PicturePoint& point : line) point = {scale * (left + point.x), -scale * point.y};
    lines.push_back(std::move(line));
  }
}

double scale_of(double height) { return kCapitalShare * height / kCapitalHeight; }

}  // namespace

std::vector<PicturePoints> text_lines(std::string_view text, double height) {
  std::vector<PicturePoints> lines;
  double left = 0;
  for (const char sign : text) {
    if (is_continued(sign)) continue;
    add_glyph(glyph_of(sign), left, scale_of(height), lines);
    left += glyph_of(sign).width + kGlyphGap;
  }
  return lines;
}

double text_width(std::string_view text, double height) {
  double width = 0;
  for (const char sign : text) {
    if (!is_continued(sign)) width += glyph_of(sign).width + kGlyphGap;
  }
  return scale_of(height) * std::max(0.0, width - kGlyphGap);
}

}  // namespace surfmesh
