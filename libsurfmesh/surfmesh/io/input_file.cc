// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/io/input_file.hh"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Pipes tell no size: they are read in pieces of this many bytes.
constexpr std::size_t kPiece = std::size_t{1} << 20;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorCode::Io, fmt::format("cannot read {}: {}", path.string(), reason));
}

void append_rest(std::ifstream& file, std::string& text) {
  while (file && file.peek() != std::ifstream::traits_type::eof()) {
    const std::size_t size = text.size();
    text.resize(size + kPiece);
    file.read(text.data() + size, static_cast<std::streamsize>(kPiece));
    text.resize(size + static_cast<std::size_t>(file.gcount()));
  }
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) fail(path, "it does not exist");
  if (!std::filesystem::exists(status)) fail(path, error.message());
  if (std::filesystem::is_directory(status)) fail(path, "it is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, std::strerror(errno));

  std::string text;
  if (std::filesystem::is_regular_file(status)) {
    const auto size = std::filesystem::file_size(path, error);
    if (!error) text.resize(size);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
  }
  append_rest(file, text);
  if (file.bad()) fail(path, std::strerror(errno));
  return text;
}

std::string lower_case_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace surfmesh
