// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/set_option.hh"

#include <fmt/format.h>

#include "surfmesh/core/error.hh"
#include "surfmesh/pipeline/option_table.hh"

namespace surfmesh {
namespace {

void set(PipelineOptions& options, const NumberAccess& access, std::string_view text) {
  const std::optional<double> value = access.range->read(text);
  if (!value) fail_option(access.range->name, text, to_text(*access.range));
  access.set(options, *value);
}

/// Nothing for what is no length.
std::optional<Length> parsed(std::string_view text) {
  try {
    return parse_length(text);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A length that may be off is so by 0, too, and where it may be on, by false.
std::optional<Length> read_length(const LengthRange& range, std::string_view text) {
  if (range.can_be_off && (text == "off" || text == "0")) return std::nullopt;
  if (range.on > 0 && text == "false") return std::nullopt;
  if (range.on > 0 && (text == "on" || text == "true")) return Length::share(range.on);
  const std::optional<Length> length = parsed(text);
  if (!length) {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("{} = {} cannot be read, it is {}", range.name, text, to_text(range)));
  }
  if (!range.contains(length)) fail_option(range.name, text, to_text(range));
  return length;
}

void set(PipelineOptions& options, const LengthAccess& access, std::string_view text) {
  access.set(options, read_length(*access.range, text));
}

OptionValue get(const PipelineOptions& options, const NumberAccess& access) {
  const double value = access.get(options);
  if (access.range->is_switch()) return value != 0;
  if (const auto word = access.range->word_for(value)) return std::string(*word);
  if (access.range->is_whole) return static_cast<std::int64_t>(value);
  return value;
}

OptionValue get(const PipelineOptions& options, const LengthAccess& access) {
  return to_text(access.get(options));
}

}  // namespace

const std::vector<std::string_view>& option_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Option& option : option_table()) list.push_back(option.name());
    return list;
  }();
  return names;
}

void set_option(PipelineOptions& options, std::string_view name, std::string_view value) {
  std::visit([&](const auto& access) { set(options, access, value); }, find_option(name).access);
}

OptionValue get_option(const PipelineOptions& options, std::string_view name) {
  return std::visit([&](const auto& access) { return get(options, access); },
                    find_option(name).access);
}

std::string to_text(const OptionValue& value) {
  if (const bool* is_on = std::get_if<bool>(&value)) return *is_on ? "on" : "off";
  return std::visit([](const auto& x) { return fmt::format("{}", x); }, value);
}

}  // namespace surfmesh
