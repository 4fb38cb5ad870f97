// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/IO/StoreRestore.hh>
#include <array>
#include <bit>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <type_traits>

#include "surfmesh/core/values.hh"

namespace surfmesh::detail {

/// Names of our value types in .om files; nullptr for all other types.
template <class T>
inline constexpr const char* stored_name = nullptr;
template <>
inline constexpr const char* stored_name<Uv> = "surfmesh::Uv";
template <>
inline constexpr const char* stored_name<Metric> = "surfmesh::Metric";
template <>
inline constexpr const char* stored_name<SizeTensor> = "surfmesh::SizeTensor";
template <>
inline constexpr const char* stored_name<Normal> = "surfmesh::Normal";

}  // namespace surfmesh::detail

namespace OpenMesh::IO {

/// Stores our value types in .om files, as their doubles one after the other.
///
/// Without it OpenMesh prints a warning for every persistent property of these types and leaves
/// them out of the file. Must be included before any property of these types is made.
template <class T>
struct binary<T, std::enable_if_t<surfmesh::detail::stored_name<T> != nullptr>> {
  using value_type = T;
  using Doubles = std::array<double, sizeof(T) / sizeof(double)>;
  static_assert(std::is_trivially_copyable_v<T> && sizeof(Doubles) == sizeof(T));

  static const bool is_streamable = true;
  static std::size_t size_of() { return sizeof(T); }
  static std::size_t size_of(const T&) { return sizeof(T); }
  static std::string type_identifier() { return surfmesh::detail::stored_name<T>; }

  static std::size_t store(std::ostream& out, const T& value, bool swap = false) {
    std::size_t bytes = 0;
    for (const double x : std::bit_cast<Doubles>(value)) bytes += IO::store(out, x, swap);
    return bytes;
  }

  static std::size_t restore(std::istream& in, T& value, bool swap = false) {
    Doubles doubles{};
    std::size_t bytes = 0;
    for (double& x : doubles) bytes += IO::restore(in, x, swap);
    value = std::bit_cast<T>(doubles);
    return bytes;
  }
};

}  // namespace OpenMesh::IO
