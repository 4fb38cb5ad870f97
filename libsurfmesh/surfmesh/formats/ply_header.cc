// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/ply_header.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/patch_numbers.hh"

namespace surfmesh::ply {
namespace {

struct TypeName {
  std::string_view name;
  Type type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", Type::Int8},
                                                  {"int8", Type::Int8},
                                                  {"uchar", Type::Uint8},
                                                  {"uint8", Type::Uint8},
                                                  {"short", Type::Int16},
                                                  {"int16", Type::Int16},
                                                  {"ushort", Type::Uint16},
                                                  {"uint16", Type::Uint16},
                                                  {"int", Type::Int32},
                                                  {"int32", Type::Int32},
                                                  {"uint", Type::Uint32},
                                                  {"uint32", Type::Uint32},
                                                  {"float", Type::Float32},
                                                  {"float32", Type::Float32},
                                                  {"double", Type::Float64},
                                                  {"float64", Type::Float64}}};

/// Numbers of patches and groups in comments above this are not believed.
constexpr int kMostNames = 1'000'000;

/// The entry of this index, in a list that grows to hold it.
template <class Value>
Value& entry(std::vector<Value>& list, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (list.size() <= i) list.resize(i + 1);
  return list[i];
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Header read();

 private:
  bool next_line();
  std::string_view next_word();
  void read_statement(std::string_view keyword);
  void read_format();
  void read_element();
  void read_property();
  void read_comment();
  std::optional<int> next_number(int least, int most);
  std::string_view rest_of_line() const;
  Type read_type();
  [[noreturn]] void fail(std::string_view reason) const {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", name_, header_.lines, reason));
  }

  std::string_view bytes_;
  const std::string& name_;
  std::string_view line_;
  bool has_format_ = false;
  Header header_;
};

Header HeaderReader::read() {
  if (bytes_.empty()) throw Error(ErrorCode::InvalidInput, name_ + ": the file is empty");
  if (!next_line() || next_word() != "ply")
    fail("this is not a PLY file, it does not begin with ply");
  for (;;) {
    if (!next_line()) fail("the file ends in its header");
    const std::string_view keyword = next_word();
    if (keyword == "end_header") break;
    read_statement(keyword);
  }
  if (!has_format_) fail("the header has no line with the format");
  return std::move(header_);
}

bool HeaderReader::next_line() {
  ++header_.lines;
  const std::string_view rest = bytes_.substr(header_.size);
  const std::size_t end = rest.find_first_of("\r\n");
  if (end == std::string_view::npos) return false;
  line_ = rest.substr(0, end);
  header_.size += end + (rest.substr(end).starts_with("\r\n") ? 2 : 1);
  return true;
}

std::string_view HeaderReader::next_word() {
  line_.remove_prefix(std::min(line_.find_first_not_of(" \t"), line_.size()));
  const std::string_view word = line_.substr(0, line_.find_first_of(" \t"));
  line_.remove_prefix(word.size());
  return word;
}

void HeaderReader::read_statement(std::string_view keyword) {
  if (keyword == "format") return read_format();
  if (keyword == "element") return read_element();
  if (keyword == "property") return read_property();
  if (keyword == "comment") return read_comment();
  if (keyword == "obj_info" || keyword.empty()) return;
  fail(fmt::format("unknown keyword {} in the header", quoted(keyword)));
}

void HeaderReader::read_format() {
  const std::string_view word = next_word();
  has_format_ = true;
  if (word == "ascii") {
    header_.format = Format::Ascii;
  } else if (word == "binary_little_endian") {
    header_.format = Format::Little;
  } else if (word == "binary_big_endian") {
    header_.format = Format::Big;
  } else {
    fail(fmt::format("the format {} is none of ascii, binary_little_endian, binary_big_endian",
                     quoted(word)));
  }
}

void HeaderReader::read_element() {
  Element element;
  element.name = next_word();
  const std::string_view word = next_word();
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), element.count);
  if (error != std::errc() || stop != word.data() + word.size()) {
    fail(fmt::format("the count of an element is {}", quoted(word)));
  }
  if (element.count > std::numeric_limits<int>::max()) {
    fail(fmt::format("{} elements are more than can be read", element.count));
  }
  header_.elements.push_back(std::move(element));
}

Type HeaderReader::read_type() {
  const std::string_view word = next_word();
  for (const auto& [name, type] : kTypeNames) {
    if (word == name) return type;
  }
  fail(fmt::format("{} is not a type of numbers", quoted(word)));
}

void HeaderReader::read_property() {
  if (header_.elements.empty()) fail("a property before any element");
  Property property;
  const std::string_view line = line_;
  if (next_word() == "list") {
    property.count_type = read_type();
    if (is_float(*property.count_type)) fail("the count of a list is not of an integer type");
  } else {
    line_ = line;
  }
  property.type = read_type();
  property.name = next_word();
  if (property.name.empty()) fail("a property without a name");
  header_.elements.back().properties.push_back(std::move(property));
}

std::optional<int> HeaderReader::next_number(int least, int most) {
  const std::string_view word = next_word();
  int number = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || stop != word.data() + word.size()) return std::nullopt;
  return number >= least && number <= most ? std::optional(number) : std::nullopt;
}

/// The rest of the line after one blank.
std::string_view HeaderReader::rest_of_line() const {
  return line_.substr(std::min<std::size_t>(1, line_.size()));
}

/// Ours are, with numbers from 0:
///   comment patch <patch> <name>              a name longer than a line goes on in the next one
///   comment group <group> <name>
///   comment patches <group> <patch>...
///   comment faces <count> <patch>             runs of faces; -1 for no patch
void HeaderReader::read_comment() {
  constexpr int most = std::numeric_limits<int>::max();
  const std::string_view keyword = next_word();
  MeshNames& names = header_.names;
  if (keyword == "patch") {
    if (const auto patch = next_number(0, kMostNames))
      entry(names.patches, *patch) += rest_of_line();
  } else if (keyword == "group") {
    if (const auto group = next_number(0, kMostNames))
      entry(names.groups, *group).name += rest_of_line();
  } else if (keyword == "patches") {
    const auto group = next_number(0, kMostNames);
    for (auto patch = next_number(0, most); group && patch; patch = next_number(0, most)) {
      entry(names.groups, *group).patches.push_back(*patch);
    }
  } else if (keyword == "faces") {
    const auto count = next_number(1, most);
    const auto patch = next_number(-1, kMostPatches);
    if (count && patch) header_.runs.push_back({static_cast<std::size_t>(*count), *patch});
  }
}

}  // namespace

Header read_header(std::string_view bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace surfmesh::ply
