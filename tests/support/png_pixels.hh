// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace surfmesh::testing {

/// Red, green, blue and opacity, from 0 to 255.
using PngPixel = std::array<int, 4>;

/// What a PNG file shows, read by libpng.
class PngPixels {
 public:
  explicit PngPixels(const std::string& file) {
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) {
      ADD_FAILURE() << image.message;
      return;
    }
    image.format = PNG_FORMAT_RGBA;
    width_ = image.width;
    height_ = image.height;
    bytes_.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, bytes_.data(), 0, nullptr) == 0) {
      ADD_FAILURE() << image.message;
    }
  }

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  PngPixel at(std::size_t x, std::size_t y) const {
    const std::uint8_t* bytes = bytes_.data() + 4 * (y * width_ + x);
    return {bytes[0], bytes[1], bytes[2], bytes[3]};
  }

  /// Mean difference of all parts of all pixels, from 0 to 255.
  double mean_difference(const PngPixels& other) const {
    EXPECT_EQ(bytes_.size(), other.bytes_.size());
    if (bytes_.empty() || bytes_.size() != other.bytes_.size()) return 255;
    double sum = 0;
    for (std::size_t i = 0; i < bytes_.size(); ++i) sum += std::abs(bytes_[i] - other.bytes_[i]);
    return sum / static_cast<double>(bytes_.size());
  }

 private:
  std::size_t width_ = 0;
  std::size_t height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace surfmesh::testing
