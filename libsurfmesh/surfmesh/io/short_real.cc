// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/short_real.hh"

#include <algorithm>
#include <charconv>

namespace surfmesh {
namespace {

/// Digits behind the point of a number as text.
int decimals_of(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == text.npos) return 0;
  const std::size_t end = std::min(text.find_first_not_of("0123456789", point + 1), text.size());
  return static_cast<int>(end - point - 1);
}

}  // namespace

ShortReal::ShortReal(double value, std::size_t width, RealStyle style) {
  char* const begin = text_.data();
  char* const end = begin + text_.size();
  size_ = static_cast<std::size_t>(std::to_chars(begin, end, value).ptr - begin);
  const int decimals = decimals_of(text());
  const bool has_exponent = text().find('e') != std::string_view::npos;
  tidy(style);
  if (size_ <= width) return;
  const int excess = static_cast<int>(size_ - width);
  const bool is_fixed = !has_exponent && decimals >= excess;
  const auto form = is_fixed ? std::chars_format::fixed : std::chars_format::scientific;
  // Long whole numbers get an exponent, and then all the digits that fit.
  int precision = is_fixed || has_exponent ? decimals - excess : static_cast<int>(width);
  // Rounding up may lengthen a number: 9.99 becomes 10.0.
  for (; precision >= 0; --precision) {
    size_ = static_cast<std::size_t>(std::to_chars(begin, end, value, form, precision).ptr - begin);
    tidy(style);
    if (size_ <= width) return;
  }
}

double ShortReal::value() const {
  std::array<char, 48> plain;
  std::size_t size = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const bool is_sign = text_[i] == '-' || text_[i] == '+';
    if (is_sign && i > 0 && text_[i - 1] != 'e') plain[size++] = 'e';
    if (text_[i] != '+') plain[size++] = text_[i];
  }
  double result = 0;
  std::from_chars(plain.data(), plain.data() + size, result);
  return result;
}

/// Drop the zero in front of a point and those of an exponent, and bring the number into the style.
void ShortReal::tidy(RealStyle style) {
  const std::size_t first = text_[0] == '-' ? 1 : 0;
  if (size_ > first + 1 && text_[first] == '0' && text_[first + 1] == '.') erase(first, 1);
  std::size_t exponent = std::min(text().find('e'), size_);
  if (exponent < size_) {
    // "e-07" and "e+12" have a sign and two or three digits.
    if (text_[exponent + 2] == '0') erase(exponent + 2, 1);
    if (style == RealStyle::Nastran) {
      erase(exponent, 1);
    } else if (text_[exponent + 1] == '+') {
      erase(exponent + 1, 1);
    }
  }
  if (style == RealStyle::Plain || text().find('.') != std::string_view::npos) return;
  std::copy_backward(text_.data() + exponent, text_.data() + size_, text_.data() + size_ + 1);
  text_[exponent] = '.';
  ++size_;
}

void ShortReal::erase(std::size_t place, std::size_t count) {
  std::copy(text_.data() + place + count, text_.data() + size_, text_.data() + place);
  size_ -= count;
}

}  // namespace surfmesh
