// SPDX-License-Identifier: BSD-3-Clause
#include "laws/sources.hh"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace surfmesh::testing {
namespace {

const std::filesystem::path kProject = SURFMESH_SOURCE_DIR;

/// A piece of a source text: code, a comment, or a literal with its quotes.
enum class Kind { Code, Comment, Literal };

struct Piece {
  Kind kind;
  std::string_view text;
};

std::size_t end_of_literal(std::string_view text, std::size_t begin) {
  std::size_t i = begin + 1;
  while (i < text.size() && text[i] != text[begin] && text[i] != '\n') i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

std::size_t end_of_raw_string(std::string_view text, std::size_t begin) {
  const std::size_t open = text.find('(', begin);
  if (open == std::string_view::npos) return text.size();
  std::string close(text.substr(begin, open - begin + 1));  // "tag( becomes )tag"
  close.front() = ')';
  close.back() = '"';
  const std::size_t end = text.find(close, open);
  return end == std::string_view::npos ? text.size() : end + close.size();
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// True for the quote of a character or string, not for the separator in 1'000.
bool is_quote(std::string_view text, std::size_t i) {
  return text[i] == '"' || (text[i] == '\'' && (i == 0 || !is_word(text[i - 1])));
}

Piece piece_at(std::string_view text, std::size_t i) {
  const std::string_view rest = text.substr(i);
  if (rest.starts_with("//")) return {Kind::Comment, rest.substr(0, rest.find('\n'))};
  if (rest.starts_with("/*")) {
    const std::size_t end = rest.find("*/", 2);
    return {Kind::Comment, rest.substr(0, end == std::string_view::npos ? end : end + 2)};
  }
  if (is_quote(text, i)) {
    const bool is_raw = text[i] == '"' && i > 0 && text[i - 1] == 'R';
    const std::size_t end = is_raw ? end_of_raw_string(text, i) : end_of_literal(text, i);
    return {Kind::Literal, text.substr(i, end - i)};
  }
  return {Kind::Code, rest.substr(0, 1)};
}

/// The text without the pieces of one kind; their line ends stay.
std::string without(std::string_view text, Kind kind) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const Piece piece = piece_at(text, i);
    if (piece.kind == kind) {
      const auto newlines = std::count(piece.text.begin(), piece.text.end(), '\n');
      result.append(static_cast<std::size_t>(newlines), '\n').append(1, ' ');
    } else {
      result.append(piece.text);
    }
    i += piece.text.size();
  }
  return result;
}

SourceFile read(const std::filesystem::path& root, const std::filesystem::path& path) {
  std::ifstream stream(path);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const std::filesystem::path relative = path.lexically_relative(root);
  const std::string folder = relative.has_parent_path() ? relative.begin()->string() : "";
  return {relative.generic_string(), folder, lines_of(text), lines_of(without_comments(text))};
}

/// True for sources, and for headers that CMake fills in ("version.hh.in").
bool is_source(const std::filesystem::path& path) {
  const auto ending = (path.extension() == ".in" ? path.stem() : path).extension();
  return ending == ".hh" || ending == ".cc";
}

/// The sources in some folders of a root.
std::vector<SourceFile> sources_in(const std::filesystem::path& root,
                                   const std::vector<std::string>& folders) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (is_source(entry.path())) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<SourceFile> files;
  for (const std::filesystem::path& path : paths) files.push_back(read(root, path));
  return files;
}

}  // namespace

std::string text_of_file(const std::string& path) {
  std::ifstream stream(kProject / path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> lines_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string without_comments(std::string_view text) { return without(text, Kind::Comment); }

std::string without_strings(std::string_view text) { return without(text, Kind::Literal); }

std::vector<SourceFile> library_sources() {
  return sources_in(kProject / "libsurfmesh" / "surfmesh", {""});
}

std::vector<SourceFile> library_sources_with_parts() {
  return sources_in(kProject / "libsurfmesh",
                    {"surfmesh", "surfmesh_cad", "surfmesh_mpi", "surfmesh_metis"});
}

std::vector<SourceFile> project_sources() {
  return sources_in(kProject, {"libsurfmesh", "tests", "tools"});
}

std::string place(const SourceFile& file, std::size_t line_index) {
  return file.path + ":" + std::to_string(line_index + 1) + ": " + file.lines[line_index];
}

}  // namespace surfmesh::testing
