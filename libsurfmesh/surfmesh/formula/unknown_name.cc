// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formula/unknown_name.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "surfmesh/formula/formula.hh"
#include "surfmesh/formula/formula_functions.hh"
#include "surfmesh/io/nearest_word.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kMaxQuoted = 80;
/// More names than this are not listed.
constexpr std::size_t kMaxListed = 20;

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names;
  for (const FormulaFunction& function : all_formula_functions()) names.push_back(function.name);
  return names;
}

/// ", did you mean <word>?", or the end of the sentence. Capitals count least.
std::string suggestion(std::string_view name, const std::vector<std::string_view>& known) {
  const auto is_same = [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
  };
  const auto same = std::ranges::find_if(
      known, [&](std::string_view x) { return std::ranges::equal(name, x, is_same); });
  const auto meant = same != known.end() ? *same : nearest_word(name, known);
  return meant ? fmt::format(", did you mean {}?", *meant) : ".";
}

}  // namespace

std::string shortened(std::string_view text) {
  if (text.size() <= kMaxQuoted) return std::string(text);
  std::size_t end = kMaxQuoted;
  const auto continues = [&] { return (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80; };
  while (end > 0 && continues()) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string unknown_function(std::string_view name) {
  return fmt::format("unknown function '{}'{} Functions: {}", shortened(name),
                     suggestion(name, function_names()), formula_functions());
}

std::string unknown_name(std::string_view name, const std::vector<std::string_view>& known) {
  std::vector<std::string_view> words = known;
  for (const std::string_view function : function_names()) words.push_back(function);
  std::vector<std::string> listed;
  for (const std::string_view word : std::span(known).first(std::min(known.size(), kMaxListed))) {
    listed.push_back(shortened(word));
  }
  if (known.size() > kMaxListed) listed.push_back("...");
  return fmt::format("unknown name '{}'{} Names: {}", shortened(name), suggestion(name, words),
                     fmt::join(listed, " "));
}

}  // namespace surfmesh
