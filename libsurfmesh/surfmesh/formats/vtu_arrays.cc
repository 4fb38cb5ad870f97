// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/vtu_arrays.hh"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <optional>
#include <type_traits>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/number_scanner.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh::vtu {
namespace {

/// zlib makes no more bytes of one than this, so a block that is said to be larger is none.
constexpr std::size_t kGreatestRatio = 1040;

/// Says where an array stands.
class Place {
 public:
  Place(const DataArray& array, const ArrayForm& form) : array_(array), form_(form) {}

  [[noreturn]] void fail(std::string_view reason) const {
    const std::string what = fmt::format("array {}: {}", surfmesh::quoted(array_.name), reason);
    throw Error(
        ErrorCode::InvalidInput,
        array_.encoding == Encoding::Appended
            ? fmt::format("{}: byte {}: {}", form_.name, form_.appended_start + array_.offset, what)
            : fmt::format("{}:{}: {}", form_.name, array_.line, what));
  }

 private:
  const DataArray& array_;
  const ArrayForm& form_;
};

constexpr std::array<signed char, 256> base64_digits() {
  std::array<signed char, 256> digits{};
  for (auto& digit : digits) digit = -1;
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < letters.size(); ++i) {
    digits[static_cast<unsigned char>(letters[i])] = static_cast<signed char>(i);
  }
  return digits;
}

/// The bytes of base64, up to what is none. Streams that end with = may follow each other: headers
/// of compressed data are one of their own.
std::string from_base64(std::string_view text, const Place& place) {
  static constexpr auto digits = base64_digits();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  int count = 0, padding = 0;
  for (const char c : text) {
    if (is_blank(c)) continue;
    const int digit = c == '=' ? 0 : digits[static_cast<unsigned char>(c)];
    if (digit < 0) break;
    if (c == '=') ++padding;
    if (c != '=' && padding > 0) place.fail("= inside a group of base64");
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++count < 4) continue;
    if (padding > 2) place.fail("three = in a group of base64");
    for (int k = 0; k < 3 - padding; ++k) {
      bytes.push_back(static_cast<char>(group >> (16 - 8 * k) & 0xFF));
    }
    group = 0;
    count = padding = 0;
  }
  return bytes;
}

template <class Number>
Number number_at(std::string_view bytes, std::size_t offset, std::endian order) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes.data() + offset, raw.size());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Takes the numbers before binary data.
class HeaderNumbers {
 public:
  HeaderNumbers(std::string_view bytes, const ArrayForm& form, const Place& place)
      : bytes_(bytes), form_(form), place_(place) {}

  std::size_t take() {
    const auto size = static_cast<std::size_t>(form_.header_size);
    if (bytes_.size() - offset_ < size) place_.fail("it is cut short");
    const std::size_t at = offset_;
    offset_ += size;
    return size == 4 ? number_at<std::uint32_t>(bytes_, at, form_.order)
                     : number_at<std::uint64_t>(bytes_, at, form_.order);
  }

  std::string_view rest() const { return bytes_.substr(offset_); }

 private:
  std::string_view bytes_;
  const ArrayForm& form_;
  const Place& place_;
  std::size_t offset_ = 0;
};

void append_block(std::string_view compressed, std::size_t size, const Place& place,
                  std::string& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + size);
  auto written = static_cast<uLongf>(size);
  const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &written,
                                reinterpret_cast<const Bytef*>(compressed.data()),
                                static_cast<uLong>(compressed.size()));
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  if (result != Z_OK || written != size) place.fail("its compressed data are broken");
}

/// The blocks of compressed data: their number, the size of all but the last, that of the last or 0
/// if it is whole, the compressed size of each; then the blocks.
std::string uncompressed(std::string_view data, const ArrayForm& form, const Place& place) {
  HeaderNumbers header(data, form, place);
  const std::size_t count = header.take(), size = header.take(), last = header.take();
  if (count > header.rest().size() / static_cast<std::size_t>(form.header_size)) {
    place.fail(fmt::format("{} compressed blocks, for which it is too short", count));
  }
  std::vector<std::size_t> sizes(count);
  for (std::size_t& compressed : sizes) compressed = header.take();
  std::string_view rest = header.rest();
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t whole = i + 1 == count && last > 0 ? last : size;
    if (sizes[i] > rest.size()) place.fail("its compressed data are cut short");
    if (whole / kGreatestRatio > sizes[i]) place.fail("a compressed block cannot be so large");
    append_block(rest.substr(0, sizes[i]), whole, place, bytes);
    rest.remove_prefix(sizes[i]);
  }
  return bytes;
}

/// The plain bytes of binary data.
std::string plain_bytes(const DataArray& array, const ArrayForm& form, const Place& place) {
  std::string decoded;
  std::string_view data;
  if (array.encoding == Encoding::Appended) {
    if (array.offset > form.appended.size()) place.fail("it begins beyond the appended data");
    data = form.appended.substr(array.offset, array.end - array.offset);
  } else {
    data = array.content;
  }
  if (array.encoding == Encoding::Inline || form.is_base64) {
    decoded = from_base64(data, place);
    data = decoded;
  }
  if (form.is_compressed) return uncompressed(data, form, place);
  HeaderNumbers header(data, form, place);
  const std::size_t size = header.take();
  if (size > header.rest().size()) place.fail("it is cut short");
  return std::string(header.rest().substr(0, size));
}

template <class From, class To>
std::vector<To> converted(std::string_view bytes, std::endian order) {
  std::vector<To> numbers;
  numbers.reserve(bytes.size() / sizeof(From));
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(From)) {
    numbers.push_back(static_cast<To>(number_at<From>(bytes, at, order)));
  }
  return numbers;
}

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

template <class To>
std::vector<To> from_bytes(std::string_view bytes, Type type, std::endian order) {
  switch (type) {
    case Type::Int8:
      return converted<std::int8_t, To>(bytes, order);
    case Type::UInt8:
      return converted<std::uint8_t, To>(bytes, order);
    case Type::Int16:
      return converted<std::int16_t, To>(bytes, order);
    case Type::UInt16:
      return converted<std::uint16_t, To>(bytes, order);
    case Type::Int32:
      return converted<std::int32_t, To>(bytes, order);
    case Type::UInt32:
      return converted<std::uint32_t, To>(bytes, order);
    case Type::Int64:
      return converted<std::int64_t, To>(bytes, order);
    case Type::UInt64:
      return converted<std::uint64_t, To>(bytes, order);
    case Type::Float32:
      if constexpr (std::is_same_v<To, double>) return converted<float, To>(bytes, order);
      break;
    case Type::Float64:
      if constexpr (std::is_same_v<To, double>) return converted<double, To>(bytes, order);
      break;
  }
  return {};
}

template <class To>
std::optional<To> number_of(std::string_view word) {
  if constexpr (std::is_same_v<To, double>) {
    return real_of(word);
  } else {
    return integer_of(word);
  }
}

template <class To>
std::vector<To> from_text(const DataArray& array, const ArrayForm& form) {
  std::vector<To> numbers;
  const char* const begin = array.content.data();
  const char* const end = begin + array.content.size();
  for (const char* at = begin; at != end;) {
    if (is_blank(*at)) {
      ++at;
      continue;
    }
    const char* const word = at;
    while (at != end && !is_blank(*at)) ++at;
    const std::optional<To> value = number_of<To>({word, static_cast<std::size_t>(at - word)});
    if (!value) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{}:{}: array {}: {} is not a number", form.name,
                              array.line + static_cast<std::size_t>(std::count(begin, word, '\n')),
                              surfmesh::quoted(array.name),
                              surfmesh::quoted({word, static_cast<std::size_t>(at - word)})));
    }
    numbers.push_back(*value);
  }
  return numbers;
}

template <class To>
std::vector<To> values_of(const DataArray& array, const ArrayForm& form) {
  if (array.encoding == Encoding::Text) return from_text<To>(array, form);
  const Place place(array, form);
  const std::string bytes = plain_bytes(array, form, place);
  if (bytes.size() % size_of(array.type) != 0) place.fail("it ends inside a number");
  return from_bytes<To>(bytes, array.type, form.order);
}

}  // namespace

bool is_integer(Type type) { return type != Type::Float32 && type != Type::Float64; }

std::vector<double> numbers_of(const DataArray& array, const ArrayForm& form) {
  return values_of<double>(array, form);
}

std::vector<std::int64_t> integers_of(const DataArray& array, const ArrayForm& form) {
  if (!is_integer(array.type)) Place(array, form).fail("it must have integers");
  return values_of<std::int64_t>(array, form);
}

}  // namespace surfmesh::vtu
