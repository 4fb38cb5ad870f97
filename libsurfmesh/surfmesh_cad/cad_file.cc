// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/cad_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "surfmesh/core/error.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh_cad/brep_text.hh"
#include "surfmesh_cad/iges_text.hh"
#include "surfmesh_cad/step_text.hh"

namespace surfmesh {
namespace {

/// Reading takes about 30 times as much memory.
constexpr std::uintmax_t kMostBytes = 512ull << 20;

/// What is looked at of the beginning and of the end of a file: comments may stand there.
constexpr std::size_t kLookedAt = 1 << 16;

[[noreturn]] void fail(const std::string& reason) { throw Error(ErrorCode::InvalidInput, reason); }

std::string read_part(std::ifstream& file, std::uintmax_t from, std::size_t count) {
  std::string text(count, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(from));
  file.read(text.data(), static_cast<std::streamsize>(count));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// The beginning and the end of a file.
struct Ends {
  std::string head;
  std::string tail;
};

Ends read_ends(const std::filesystem::path& path, std::uintmax_t size) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(ErrorCode::Io, "cannot be read");
  const auto count = static_cast<std::size_t>(std::min<std::uintmax_t>(size, kLookedAt));
  return {read_part(file, 0, count), read_part(file, size - count, count)};
}

/// Letters in upper case, without white space, that ends of lines may stand anywhere in.
std::string bare(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isspace(letter) == 0) result += static_cast<char>(std::toupper(letter));
  }
  return result;
}

void check_step(const Ends& ends) {
  const std::string head = bare(ends.head);
  if (head.find("ISO-10303-21;") == std::string::npos) {
    fail("this is no STEP file: it does not begin with ISO-10303-21");
  }
  if (bare(ends.tail).find("END-ISO-10303-21") == std::string::npos) {
    fail("the STEP file is cut off: it does not end with END-ISO-10303-21");
  }
}

std::string_view last_line(std::string_view text) {
  const std::size_t end = text.find_last_not_of(" \r\n\t\x1a");
  if (end == std::string_view::npos) return {};
  text = text.substr(0, end + 1);
  const std::size_t begin = text.find_last_of("\r\n");
  return begin == std::string_view::npos ? text : text.substr(begin + 1);
}

void check_iges(const Ends& ends) {
  const std::string_view first = std::string_view(ends.head).substr(0, ends.head.find('\n'));
  const char section = section_of(first);
  if (section == 'C' || section == 'B') {
    fail("compressed and binary IGES files are not read; save it as text of fixed length");
  }
  if (section != 'S') fail("this is no IGES file: its first line has no S in column 73");
  if (section_of(last_line(ends.tail)) != 'T') {
    fail("the IGES file is cut off: its last line has no T in column 73");
  }
}

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw Error(ErrorCode::Io, "it does not exist");
  if (std::filesystem::is_directory(status)) throw Error(ErrorCode::Io, "it is a folder");
  if (!std::filesystem::is_regular_file(status)) throw Error(ErrorCode::Io, "it is no file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw Error(ErrorCode::Io, error.message());
  if (size == 0) fail("it is empty");
  if (size > kMostBytes) {
    throw Error(ErrorCode::Limit,
                fmt::format("it has {} MB; files of CAD programs are read up to {} MB", size >> 20,
                            kMostBytes >> 20));
  }
  return size;
}

}  // namespace

CadFormat check_cad_file(const std::filesystem::path& path) {
  const std::uintmax_t size = size_of(path);
  const std::string ending = lower_case_ending(path);
  if (ending == ".brep") {
    check_brep_text(read_file(path));
    return CadFormat::Brep;
  }
  const Ends ends = read_ends(path, size);
  if (ending == ".igs" || ending == ".iges") {
    check_iges(ends);
    check_iges_text(read_file(path));
    return CadFormat::Iges;
  }
  if (ending != ".step" && ending != ".stp") {
    fail("its ending is none of .step, .stp, .iges, .igs and .brep");
  }
  check_step(ends);
  check_step_text(read_file(path));
  return CadFormat::Step;
}

}  // namespace surfmesh
