// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/text_scanner.hh"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/out_of_range.hh"

namespace surfmesh {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kLongestQuote = 40;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// from_chars knows no plus sign.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string name, Joining joining)
    : position_(text.data()),
      end_(text.data() + text.size()),
      name_(std::move(name)),
      joining_(joining) {
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos) {
    const auto lines = std::count(text.begin(), text.begin() + static_cast<long>(nul), '\n');
    fail_at(static_cast<int>(lines) + 1, "a NUL byte, this is not a text file");
  }
  if (text.starts_with(kByteOrderMark)) position_ += kByteOrderMark.size();
}

bool TextScanner::is_at_join() const {
  if (*position_ != '\\' || joining_ == Joining::Off) return false;
  return position_ + 1 == end_ || is_line_end(position_[1]);
}

void TextScanner::skip_line_end() {
  position_ += *position_ == '\r' && position_ + 1 != end_ && position_[1] == '\n' ? 2 : 1;
  ++line_;
}

void TextScanner::skip_blanks() {
  while (position_ != end_) {
    if (is_blank(*position_)) {
      ++position_;
    } else if (*position_ == '#') {
      while (position_ != end_ && !is_line_end(*position_)) ++position_;
    } else if (is_at_join()) {
      ++position_;
      if (position_ != end_) skip_line_end();
    } else {
      return;
    }
  }
}

std::string_view TextScanner::next_word() {
  skip_blanks();
  const char* begin = position_;
  while (position_ != end_ && !is_blank(*position_) && !is_line_end(*position_) && !is_at_join()) {
    ++position_;
  }
  return {begin, static_cast<std::size_t>(position_ - begin)};
}

bool TextScanner::next_line() {
  if (is_inside_line_) {
    while (!next_word().empty()) {
    }
  }
  is_inside_line_ = true;
  for (;;) {
    skip_blanks();
    if (position_ == end_) return false;
    if (!is_line_end(*position_)) return true;
    skip_line_end();
  }
}

double TextScanner::to_number(std::string_view word, std::string_view what) const {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || stop != digits.data() + digits.size()) {
    fail(fmt::format("{} is {}, which is not a number", what, quoted(word)));
  }
  if (error == std::errc::result_out_of_range) {
    if (is_too_near_to_zero(digits)) return 0;
    fail(fmt::format("{} is {}, which is too large", what, quoted(word)));
  }
  if (!std::isfinite(value)) fail(fmt::format("{} is {}, which is not finite", what, quoted(word)));
  return value;
}

int TextScanner::to_integer(std::string_view word, std::string_view what) const {
  const std::string_view digits = without_plus(word);
  int value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || stop != digits.data() + digits.size()) {
    fail(fmt::format("{} is {}, which is not an integer", what, quoted(word)));
  }
  if (error != std::errc()) {
    fail(fmt::format("{} is {}, which is too large", what, quoted(word)));
  }
  return value;
}

Vec3 TextScanner::next_point() {
  Vec3 point;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = next_word();
    if (word.empty()) fail("a vertex needs three coordinates");
    point[k] = to_number(word, "a coordinate");
  }
  return point;
}

void TextScanner::fail_at(int line, std::string_view reason) const {
  throw Error(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", name_, line, reason));
}

void TextScanner::fail_whole(std::string_view reason) const {
  throw Error(ErrorCode::InvalidInput, fmt::format("{}: {}", name_, reason));
}

std::string quoted(std::string_view word) {
  std::string text(word.substr(0, kLongestQuote));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return fmt::format("'{}{}'", text, word.size() > kLongestQuote ? "..." : "");
}

void WarningList::add(int line, std::string text, std::string_view kind) {
  const auto same = std::find_if(entries_.begin(), entries_.end(),
                                 [kind](const Entry& entry) { return entry.kind == kind; });
  if (same != entries_.end()) {
    ++same->more;
  } else {
    entries_.push_back({std::string(kind), std::move(text), line, 0});
  }
}

Notices WarningList::notices() const {
  std::vector<Entry> sorted = entries_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Entry& a, const Entry& b) { return a.line < b.line; });
  Notices notices;
  for (const Entry& entry : sorted) {
    notices.push_back(
        warning_at(fmt::format("{}:{}", name_, entry.line), NoticeKind::IgnoredInput, entry.text));
    notices.back().count += static_cast<std::size_t>(entry.more);
  }
  return notices;
}

}  // namespace surfmesh
