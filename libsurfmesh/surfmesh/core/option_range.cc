// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/option_range.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

const OptionWord* find_word(const OptionRange& range, std::string_view text) {
  const auto found = std::find_if(range.words.begin(), range.words.end(),
                                  [text](const OptionWord& word) { return word.word == text; });
  return found == range.words.end() ? nullptr : &*found;
}

bool has_word_for(const OptionRange& range, double value) {
  return std::any_of(range.words.begin(), range.words.end(),
                     [value](const OptionWord& word) { return word.value == value; });
}

bool is_number(const OptionRange& range, double value) {
  if (!(value >= range.least && value <= range.most)) return false;
  if (range.is_open && value == range.least) return false;
  return !range.is_whole || value == std::floor(value);
}

std::string numbers_text(const OptionRange& range) {
  const char* kind = range.is_whole ? "a whole number" : "a number";
  if (range.is_open) return fmt::format("{} above {}, up to {}", kind, range.least, range.most);
  return fmt::format("{} from {} to {}", kind, range.least, range.most);
}

std::vector<std::string_view> shown_words(const OptionRange& range) {
  std::vector<std::string_view> shown;
  for (const OptionWord& word : range.words) {
    if (word.use == WordUse::Shown) shown.push_back(word.word);
  }
  return shown;
}

}  // namespace

bool OptionRange::is_switch() const { return !has_numbers() && find_word(*this, "off"); }

bool OptionRange::contains(double value) const {
  return has_word_for(*this, value) || is_number(*this, value);
}

std::optional<std::string_view> OptionRange::word_for(double value) const {
  for (const OptionWord& word : words) {
    if (word.use == WordUse::Shown && word.value == value) return word.word;
  }
  return std::nullopt;
}

std::optional<double> OptionRange::read(std::string_view text) const {
  if (const OptionWord* word = find_word(*this, text)) return word->value;
  if (!has_numbers()) return std::nullopt;
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  const bool is_off = value == 0 && find_word(*this, "off");
  return is_off || is_number(*this, value) ? std::optional(value) : std::nullopt;
}

std::string to_text(const OptionRange& range) {
  const std::vector<std::string_view> shown = shown_words(range);
  if (shown.empty()) return numbers_text(range);
  if (range.has_numbers())
    return fmt::format("{}, or {}", fmt::join(shown, ", "), numbers_text(range));
  const std::vector<std::string_view> first(shown.begin(), shown.end() - 1);
  if (first.empty()) return std::string(shown.back());
  return fmt::format("{} or {}", fmt::join(first, ", "), shown.back());
}

std::string to_text(const OptionRange& range, double value) {
  const auto word = range.word_for(value);
  return word ? std::string(*word) : fmt::format("{}", value);
}

void fail_option(std::string_view name, std::string_view value, std::string_view range) {
  throw Error(ErrorCode::InvalidOption, fmt::format("{} = {} is outside its range: {}", name,
                                                    value.substr(0, kLongestQuote), range));
}

void check_option(const OptionRange& range, double value) {
  if (!range.contains(value)) fail_option(range.name, to_text(range, value), to_text(range));
}

}  // namespace surfmesh
