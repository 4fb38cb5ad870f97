// SPDX-License-Identifier: BSD-3-Clause
#include "view/page_arrays.hh"

#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace surfmesh {
namespace {

std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& bytes, std::size_t size) {
  std::string result(size, '\0');
  uLongf length = size;
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  EXPECT_EQ(length, size);
  return result;
}

/// The words of an array as a browser reads them, without undoing steps.
std::vector<std::uint32_t> words(const PageArrays& arrays, const std::string& name) {
  const auto entry = arrays.directory().at(name);
  const std::string bytes = from_base64(arrays.base64());
  std::vector<std::uint32_t> result(entry.at("count").get<std::size_t>(), 0);
  std::size_t at = entry.at("at").get<std::size_t>();
  unsigned shift = 0;
  for (const auto& size_json : entry.at("sizes")) {
    const int size = size_json.get<int>();
    std::string plane = bytes.substr(at, static_cast<std::size_t>(std::abs(size)));
    at += plane.size();
    if (size > 0) plane = inflated(plane, result.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] |= static_cast<std::uint32_t>(static_cast<unsigned char>(plane[i])) << shift;
    }
    shift += 8;
  }
  return result;
}

TEST(PageArrays, KeepNumbersToTheBit) {
  std::vector<std::uint32_t> whole;
  std::vector<float> numbers;
  for (unsigned i = 0; i < 1000; ++i) {
    whole.push_back(i * 2654435761U);  // bytes that hardly get smaller
    numbers.push_back(std::ldexp(1.0F / static_cast<float>(i + 3), static_cast<int>(i % 90) - 45));
  }
  PageArrays arrays;
  arrays.add("whole", whole);
  arrays.add("numbers", numbers);
  arrays.compress();
  EXPECT_EQ(words(arrays, "whole"), whole);
  const auto back = words(arrays, "numbers");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(std::bit_cast<float>(back[i]), numbers[i]);
  }
}

TEST(PageArrays, KeepShownNumbersTo16Bits) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> numbers = {0, 1, -1, 0.1F, 3.14159265F, 1e30F, infinity, 0.99999F};
  PageArrays arrays;
  arrays.add_shown("shown", numbers);
  arrays.add_shown("unset", {std::numeric_limits<float>::quiet_NaN()});
  arrays.compress();
  const auto back = words(arrays, "shown");
  EXPECT_EQ(std::bit_cast<float>(back[1]), 1);
  EXPECT_EQ(std::bit_cast<float>(back[6]), infinity);
  for (std::size_t i = 0; i < 6; ++i) {
    const double number = numbers[i];
    EXPECT_NEAR(static_cast<double>(std::bit_cast<float>(back[i])), number,
                8e-6 * std::abs(number));
    EXPECT_EQ(back[i] & 0x7FU, 0U);
  }
  EXPECT_TRUE(std::isnan(std::bit_cast<float>(words(arrays, "unset")[0])));
}

TEST(PageArrays, KeepSteps) {
  PageArrays arrays;
  arrays.add_steps("steps", {7, 8, 6, 0xFFFFFFFF, 0});
  arrays.compress();
  EXPECT_EQ(words(arrays, "steps"), (std::vector<std::uint32_t>{14, 2, 3, 13, 2}));
  EXPECT_TRUE(arrays.directory().at("steps").at("steps").get<bool>());
}

TEST(PageArrays, MayBeEmpty) {
  PageArrays arrays;
  arrays.add("none", std::vector<float>());
  arrays.compress();
  EXPECT_TRUE(words(arrays, "none").empty());
}

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(to_base64(""), "");
  EXPECT_EQ(to_base64("f"), "Zg==");
  EXPECT_EQ(to_base64("fo"), "Zm8=");
  EXPECT_EQ(to_base64("foo"), "Zm9v");
  EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(to_base64("\xfb\xff"), "+/8=");
}

}  // namespace
}  // namespace surfmesh
