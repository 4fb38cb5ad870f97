// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "surfmesh/io/json.hh"

namespace surfmesh {

/// Binary arrays in a page: numbers of 32 bits by name.
///
/// The bytes of an array are kept as four planes, one for each byte of a number, from the lowest.
/// Each plane is compressed by itself (zlib's format, RFC 1950), or kept as it is where that does
/// not make it smaller. The browser inflates them with its DecompressionStream.
class PageArrays {
 public:
  /// Add numbers as they are.
  void add(const std::string& name, std::vector<float> numbers);

  /// Add numbers with 16 bits of their mantissa, an error of 8e-6 of their value: for values that
  /// are shown, at three quarters of the size.
  void add_shown(const std::string& name, std::vector<float> numbers);

  /// Add numbers as they are.
  void add(const std::string& name, std::vector<std::uint32_t> numbers);

  /// Add numbers of which each is near the one before: their differences are kept.
  void add_steps(const std::string& name, std::vector<std::uint32_t> numbers);

  /// Compress all arrays, on all threads.
  ///
  /// Cost     about 15 ns a number and core
  void compress();

  /// What is where in bytes(): an object by name with `type` ("f32", "u32"), `count`, `steps`
  /// (true for differences), `at` and for each plane its `sizes`; a negative size is that of a
  /// plane that is not compressed.
  Json directory() const;

  /// All planes one after the other, in base64 (RFC 4648).
  std::string base64() const;

 private:
  struct Array {
    std::string name;
    bool is_float = false;
    bool is_steps = false;
    std::vector<std::uint32_t> words;
  };

  struct Plane {
    std::string bytes;
    bool is_compressed = false;
  };

  Plane plane(const Array& array, unsigned byte) const;

  std::vector<Array> arrays_;
  std::vector<Plane> planes_;  ///< four an array
};

/// Bytes in base64.
std::string to_base64(std::string_view bytes);

}  // namespace surfmesh
