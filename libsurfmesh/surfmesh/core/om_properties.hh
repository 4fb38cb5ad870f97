// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/IO/SR_binary.hh>
#include <OpenMesh/Core/IO/SR_rbo.hh>
#include <cstddef>
#include <istream>
#include <ostream>
#include <string>

#include "surfmesh/core/values.hh"

/// How OpenMesh stores the value types in .om files.
///
/// OpenMesh instantiates this with each property of such a type, so mesh.hh includes it: where it
/// were missing, properties could not be made persistent, and two parts of one program would
/// disagree on what a property is.

namespace surfmesh::detail {

/// Stores a struct of doubles as these doubles, in the order of its members.
template <class T>
struct DoublesBinary {
  using value_type = T;
  static constexpr bool is_streamable = true;

  static std::size_t size_of() { return sizeof(T); }
  static std::size_t size_of(const T&) { return sizeof(T); }

  static std::size_t store(std::ostream& stream, const T& value, bool swap = false, bool = true) {
    T copy = value;
    if (swap) reverse_bytes(copy);
    stream.write(reinterpret_cast<const char*>(&copy), sizeof(T));
    return stream.good() ? sizeof(T) : 0;
  }

  static std::size_t restore(std::istream& stream, T& value, bool swap = false, bool = true) {
    stream.read(reinterpret_cast<char*>(&value), sizeof(T));
    if (swap) reverse_bytes(value);
    return stream.good() ? sizeof(T) : 0;
  }

 private:
  static void reverse_bytes(T& value) {
    static_assert(sizeof(T) % sizeof(double) == 0);
    auto* doubles = reinterpret_cast<double*>(&value);
    for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) {
      OpenMesh::IO::reverse_byte_order(doubles[i]);
    }
  }
};

}  // namespace surfmesh::detail

namespace OpenMesh::IO {

template <>
struct binary<surfmesh::Uv> : surfmesh::detail::DoublesBinary<surfmesh::Uv> {
  static std::string type_identifier() { return "surfmesh::Uv"; }
};

template <>
struct binary<surfmesh::Metric> : surfmesh::detail::DoublesBinary<surfmesh::Metric> {
  static std::string type_identifier() { return "surfmesh::Metric"; }
};

template <>
struct binary<surfmesh::SizeTensor> : surfmesh::detail::DoublesBinary<surfmesh::SizeTensor> {
  static std::string type_identifier() { return "surfmesh::SizeTensor"; }
};

}  // namespace OpenMesh::IO
