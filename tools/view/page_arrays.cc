// SPDX-License-Identifier: BSD-3-Clause
#include "view/page_arrays.hh"

#include <zlib.h>

#include <bit>
#include <string_view>
#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"

namespace surfmesh {
namespace {

constexpr unsigned kPlanes = 4;

/// zlib's fastest level: on planes of bytes the best one makes files 3 % smaller, in ten times the
/// time.
constexpr int kLevel = 1;

/// Planes that lose less than this share are kept as they are, which browsers read faster.
constexpr double kWorthwhile = 0.97;

std::vector<std::uint32_t> words_of(const std::vector<float>& numbers) {
  std::vector<std::uint32_t> words(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    words[i] = std::bit_cast<std::uint32_t>(numbers[i]);
  }
  return words;
}

/// Round to 16 bits of the mantissa, half away from zero. All bits of an exponent mean NaN or ∞,
/// which stay.
std::uint32_t rounded(std::uint32_t word) {
  constexpr std::uint32_t exponent = 0x7F800000, dropped = 0x7F, half = 0x40;
  if ((word & exponent) == exponent) return word & ~dropped;
  return (word + half) & ~dropped;
}

/// A difference as a number that is small where it is, of either sign.
std::uint32_t zigzag(std::uint32_t difference) {
  return (difference << 1U) ^ (difference >> 31U != 0 ? ~0U : 0U);
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kLevel);
  if (status != Z_OK) throw Error(ErrorCode::Limit, "memory runs out where a page is compressed");
  result.resize(size);
  return result;
}

}  // namespace

void PageArrays::add(const std::string& name, std::vector<float> numbers) {
  arrays_.push_back({.name = name, .is_float = true, .words = words_of(numbers)});
}

void PageArrays::add_shown(const std::string& name, std::vector<float> numbers) {
  add(name, std::move(numbers));
  for (std::uint32_t& word : arrays_.back().words) word = rounded(word);
}

void PageArrays::add(const std::string& name, std::vector<std::uint32_t> numbers) {
  arrays_.push_back({.name = name, .words = std::move(numbers)});
}

void PageArrays::add_steps(const std::string& name, std::vector<std::uint32_t> numbers) {
  std::uint32_t before = 0;
  for (std::uint32_t& number : numbers) {
    const std::uint32_t difference = number - before;
    before = number;
    number = zigzag(difference);
  }
  add(name, std::move(numbers));
  arrays_.back().is_steps = true;
}

PageArrays::Plane PageArrays::plane(const Array& array, unsigned byte) const {
  Plane plane{std::string(array.words.size(), '\0')};
  for (std::size_t i = 0; i < array.words.size(); ++i) {
    plane.bytes[i] = static_cast<char>(array.words[i] >> (8 * byte) & 0xFFU);
  }
  std::string smaller = deflated(plane.bytes);
  const double worthwhile = kWorthwhile * static_cast<double>(plane.bytes.size());
  if (static_cast<double>(smaller.size()) < worthwhile) return {std::move(smaller), true};
  return plane;
}

void PageArrays::compress() {
  planes_.assign(kPlanes * arrays_.size(), {});
  std::vector<std::size_t> sizes(planes_.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] = arrays_[i / kPlanes].words.size();
  share_indices(heaviest_first(sizes), [&](std::size_t i) {
    planes_[i] = plane(arrays_[i / kPlanes], static_cast<unsigned>(i % kPlanes));
  });
}

Json PageArrays::directory() const {
  Json json = Json::object();
  std::size_t at = 0;
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    const Array& array = arrays_[a];
    Json sizes = Json::array();
    const std::size_t begin = at;
    for (std::size_t p = kPlanes * a; p < kPlanes * (a + 1); ++p) {
      const auto size = static_cast<std::int64_t>(planes_[p].bytes.size());
      sizes.push_back(planes_[p].is_compressed ? size : -size);
      at += planes_[p].bytes.size();
    }
    json[array.name] = {{"type", array.is_float ? "f32" : "u32"},
                        {"count", array.words.size()},
                        {"steps", array.is_steps},
                        {"at", begin},
                        {"sizes", std::move(sizes)}};
  }
  return json;
}

std::string PageArrays::base64() const {
  std::string all;
  for (const Plane& plane : planes_) all += plane.bytes;
  return to_base64(all);
}

std::string to_base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  const auto byte = [&](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  for (std::size_t i = 0, t = 0; i < bytes.size(); i += 3, t += 4) {
    const std::uint32_t word = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    text[t] = digits[word >> 18U];
    text[t + 1] = digits[word >> 12U & 63U];
    if (i + 1 < bytes.size()) text[t + 2] = digits[word >> 6U & 63U];
    if (i + 2 < bytes.size()) text[t + 3] = digits[word & 63U];
  }
  return text;
}

}  // namespace surfmesh
