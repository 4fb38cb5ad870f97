// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/number_scanner.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/out_of_range.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

std::optional<std::int64_t> integer_of(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<double> real_of(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || stop != word.data() + word.size()) {
    return std::nullopt;
  }
  if (error == std::errc()) return value;
  if (is_too_near_to_zero(word)) return 0;
  return word[0] == '-' ? -std::numeric_limits<double>::infinity()
                        : std::numeric_limits<double>::infinity();
}

void NumberScanner::fail_at(std::size_t offset, std::string_view reason) const {
  if (is_binary_) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: byte {}: {}", name_, offset, reason));
  }
  const std::string_view before = bytes_.substr(0, offset);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  throw Error(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", name_, lines + 1, reason));
}

template <class Number>
Number NumberScanner::take() {
  last_ = offset_;
  if (rest() < sizeof(Number)) fail("the file ends here, it is cut short");
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes_.data() + offset_, raw.size());
  if (is_swapped_) std::reverse(raw.begin(), raw.end());
  offset_ += raw.size();
  return std::bit_cast<Number>(raw);
}

void NumberScanner::skip_blanks() {
  while (offset_ < bytes_.size()) {
    const char c = bytes_[offset_];
    if (is_blank(c)) {
      ++offset_;
    } else if (has_comments_ && c == '#') {
      offset_ = std::min(bytes_.find('\n', offset_), bytes_.size());
    } else {
      return;
    }
  }
}

std::string_view NumberScanner::word() {
  skip_blanks();
  last_ = offset_;
  while (offset_ < bytes_.size() && !is_blank(bytes_[offset_])) ++offset_;
  return bytes_.substr(last_, offset_ - last_);
}

std::string_view NumberScanner::line() {
  last_ = offset_;
  const std::size_t end = std::min(bytes_.find('\n', offset_), bytes_.size());
  offset_ = std::min(end + 1, bytes_.size());
  std::string_view line = bytes_.substr(last_, end - last_);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

std::string_view NumberScanner::number_word(std::string_view what) {
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("the file ends before {}, it is cut short", what));
  return text;
}

std::int64_t NumberScanner::integer(int size, std::string_view what) {
  if (is_binary_) return size == 4 ? take<std::int32_t>() : take<std::int64_t>();
  const std::string_view text = number_word(what);
  const auto value = integer_of(text);
  if (!value) fail(fmt::format("{} is {}, which is no integer", what, quoted(text)));
  return *value;
}

double NumberScanner::number(int size, std::string_view what) {
  if (is_binary_) return size == 4 ? static_cast<double>(take<float>()) : take<double>();
  const std::string_view text = number_word(what);
  const auto value = real_of(text);
  if (!value) fail(fmt::format("{} is {}, which is not a number", what, quoted(text)));
  return *value;
}

double NumberScanner::finite(int size, std::string_view what) {
  const double value = number(size, what);
  if (!std::isfinite(value)) fail(fmt::format("{} is {}, which is not finite", what, value));
  return value;
}

std::size_t NumberScanner::count(int size, std::size_t least, std::string_view what) {
  const std::int64_t value = integer(size, what);
  if (value < 0) fail(fmt::format("{} is {}, below 0", what, value));
  const auto count = static_cast<std::size_t>(value);
  if (count > rest() / least) {
    fail(fmt::format("{} is {}, but the file has only {} bytes after it", what, value, rest()));
  }
  return count;
}

void NumberScanner::skip(std::size_t count) {
  last_ = offset_;
  if (rest() < count) fail("the file ends too early, it is cut short");
  offset_ += count;
}

}  // namespace surfmesh
