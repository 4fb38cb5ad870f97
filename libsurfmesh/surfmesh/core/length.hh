// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "surfmesh/core/language_standard.hh"

namespace surfmesh {

/// A length in model units, or a share of the diagonal of the model's bounding box.
///
/// Made by a named function, so that a number cannot be taken for the other kind.
struct Length {
  double value = 0;
  bool is_relative = false;

  Length() = default;
  static Length units(double value) { return {value, false}; }
  /// A share of the diagonal, 0 to 1.
  static Length share(double value) { return {value, true}; }
  /// A share of the diagonal, 0 to 100: the same as parse_length makes of it, to the last bit.
  static Length percent(double value);

  double in_units(double diagonal) const { return is_relative ? value * diagonal : value; }

  /// True for lengths from 0, and for shares up to 1: nothing in a model is longer than its
  /// diagonal, and a larger share is most likely a percentage.
  bool is_legal() const;

  friend bool operator==(const Length&, const Length&) = default;

 private:
  Length(double v, bool is_share) : value(v), is_relative(is_share) {}
};

/// Read a length: a plain number in model units, or a share of the diagonal with % ("0.1%").
///
/// The share is the double nearest to the decimal number: "0.1%" gives the same double as 0.001.
/// Throws   InvalidInput if it cannot be read or is not finite; the caller checks is_legal
Length parse_length(std::string_view text);

/// Write a length so that parse_length reads the same bits.
std::string to_text(const Length& length);

/// The legal values of an option that is a length: above 0, shares up to 100 %.
struct LengthRange {
  std::string_view name;
  bool can_be_off = false;
  double on = 0;  ///< the share of the diagonal that the word "on" stands for; 0: no such word

  bool contains(const std::optional<Length>& length) const;
};

/// "off, on (0.01%), a length above 0 in model units, or a share of the diagonal up to 100%".
std::string to_text(const LengthRange& range);

/// A length as it is shown; "off" for none.
std::string to_text(const std::optional<Length>& length);

/// Throws   InvalidOption naming the option, its value and its range if it is not legal
void check_option(const LengthRange& range, const std::optional<Length>& length);

}  // namespace surfmesh
