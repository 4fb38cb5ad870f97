// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// How a real number looks in a field of a fixed width.
enum class RealStyle {
  Plain,   ///< 12, .5, 1.5e-7
  Nastran  ///< always with a point, exponents without e: 12., .5, 1.5-7
};

/// A finite real number in few characters, for formats whose fields have a width.
class ShortReal {
 public:
  /// The digits that read back as the same number if they fit into `width` characters, else as many
  /// as fit, rounded.
  /// Pre      width is at least 10
  /// Cost     0.1 µs, 0.2 µs where it is rounded
  ShortReal(double value, std::size_t width, RealStyle style);

  std::string_view text() const { return {text_.data(), size_}; }

  /// The number that the text reads as.
  double value() const;

 private:
  void tidy(RealStyle style);
  void erase(std::size_t place, std::size_t count);

  std::array<char, 40> text_;
  std::size_t size_ = 0;
};

}  // namespace surfmesh
