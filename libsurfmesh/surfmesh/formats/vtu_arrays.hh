// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The arrays of VTK's XML files.
namespace surfmesh::vtu {

enum class Type { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };
enum class Encoding { Text, Inline, Appended };

/// An array as the file has it.
struct DataArray {
  std::string name;
  Type type = Type::Float64;
  int components = 1;
  Encoding encoding = Encoding::Text;
  std::size_t offset = 0;  ///< in the appended data
  std::size_t end = 0;     ///< where another array begins there, or the end of the file
  std::string content;     ///< text, or base64
  std::size_t line = 0;    ///< where its content begins
};

/// What holds for all arrays of a file.
struct ArrayForm {
  std::string name;  ///< of the file, for messages
  std::endian order = std::endian::little;
  int header_size = 4;             ///< bytes of the numbers before binary data
  bool is_compressed = false;      ///< by zlib
  std::string_view appended;       ///< from the _ on, without it
  std::size_t appended_start = 0;  ///< where that begins in the file
  bool is_base64 = false;          ///< the appended data
};

/// The numbers of an array.
///
/// Throws   InvalidInput with "name:line: reason" for one in the XML, "name: byte N: reason" for
/// one
///          of the appended data
std::vector<double> numbers_of(const DataArray& array, const ArrayForm& form);
/// The same as integers. Throws for a type that is none, too.
std::vector<std::int64_t> integers_of(const DataArray& array, const ArrayForm& form);

bool is_integer(Type type);

}  // namespace surfmesh::vtu
