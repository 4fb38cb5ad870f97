// SPDX-License-Identifier: BSD-3-Clause
#include "compare/triangle_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <unordered_map>

#include "surfmesh/core/error.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/output_file.hh"

namespace surfmesh::compare {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// The words of a text, with their lines. A comment from # to the end of a line is none.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// The next word, empty at the end of the text. A quoted string is one word.
  std::string_view next() {
    skip_blanks();
    const std::size_t begin = at_;
    if (at_ < text_.size() && text_[at_] == '"') {
      at_ = std::min(text_.size(), text_.find('"', at_ + 1));
      if (at_ < text_.size()) ++at_;
    } else {
      while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }

  double number() {
    const std::string_view word = next();
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    if (!is_number || !std::isfinite(value)) fail(fmt::format("{} is no number", told(word)));
    return value;
  }

  long integer() {
    const std::string_view word = next();
    long value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_integer = error == std::errc() && end == word.data() + word.size();
    if (!is_integer) fail(fmt::format("{} is no integer", told(word)));
    return value;
  }

  /// How many entries follow: no more than there are characters.
  std::size_t count() {
    const long value = integer();
    if (value < 0 || static_cast<std::size_t>(value) > text_.size()) {
      fail(fmt::format("{} is no count of what follows", value));
    }
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}:{}: {}", name_, line_, reason));
  }

 private:
  static std::string told(std::string_view word) {
    return word.empty() ? "the end of the file" : fmt::format("\"{}\"", word);
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.size(), text_.find('\n', at_));
      } else if (is_blank(text_[at_])) {
        if (text_[at_] == '\n') ++line_;
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

class MshReader {
 public:
  MshReader(std::string_view text, const std::string& name) : words_(text, name) {}

  TriangleMesh read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (word == "$MeshFormat") {
        read_format();
      } else if (word == "$Nodes") {
        read_nodes();
      } else if (word == "$Elements") {
        read_elements();
      }
    }
    if (mesh_.triangles.empty()) words_.fail("the file has no triangles");
    return std::move(mesh_);
  }

 private:
  void read_format() {
    const double version = words_.number();
    const long kind = words_.integer();
    if (version < 2 || version >= 3 || kind != 0) {
      words_.fail("only ASCII files of format 2 are read");
    }
  }

  void read_nodes() {
    const std::size_t count = words_.count();
    mesh_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const long number = words_.integer();
      index_[number] = static_cast<int>(i);
      const double x = words_.number(), y = words_.number(), z = words_.number();
      mesh_.points.emplace_back(x, y, z);
    }
  }

  void read_elements() {
    const std::size_t count = words_.count();
    for (std::size_t i = 0; i < count; ++i) {
      words_.integer();  // its number
      const int nodes = nodes_of_type(words_.integer());
      const std::size_t tags = words_.count();
      for (std::size_t t = 0; t < tags; ++t) words_.integer();
      std::array<int, 3> triangle = {};
      for (int n = 0; n < nodes; ++n) triangle[static_cast<std::size_t>(n)] = node();
      if (nodes == 3) mesh_.triangles.push_back(triangle);
    }
  }

  int nodes_of_type(long type) {
    constexpr long kLine = 1, kTriangle = 2, kPoint = 15;
    if (type == kPoint) return 1;
    if (type == kLine) return 2;
    if (type == kTriangle) return 3;
    words_.fail(fmt::format("element type {} is no point, line or triangle", type));
  }

  int node() {
    const long number = words_.integer();
    const auto found = index_.find(number);
    if (found == index_.end()) words_.fail(fmt::format("there is no node {}", number));
    return found->second;
  }

  Words words_;
  TriangleMesh mesh_;
  std::unordered_map<long, int> index_;  ///< of nodes, by their number in the file
};

class MeditReader {
 public:
  MeditReader(std::string_view text, const std::string& name) : words_(text, name) {}

  TriangleMesh read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (word == "Dimension") {
        dimension_ = words_.integer();
        if (dimension_ != 2 && dimension_ != 3) words_.fail("the dimension is neither 2 nor 3");
      } else if (word == "Vertices") {
        read_vertices();
      } else if (word == "Triangles") {
        read_triangles();
      }
    }
    if (mesh_.triangles.empty()) words_.fail("the file has no triangles");
    return std::move(mesh_);
  }

 private:
  void read_vertices() {
    const std::size_t count = words_.count();
    mesh_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = words_.number(), y = words_.number();
      mesh_.points.emplace_back(x, y, dimension_ == 3 ? words_.number() : 0);
      words_.integer();  // its label
    }
  }

  void read_triangles() {
    const std::size_t count = words_.count();
    mesh_.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<int, 3> triangle = {};
      for (int& vertex : triangle) {
        const long number = words_.integer();
        if (number < 1 || static_cast<std::size_t>(number) > mesh_.points.size()) {
          words_.fail(fmt::format("there is no vertex {}", number));
        }
        vertex = static_cast<int>(number - 1);
      }
      words_.integer();  // its label
      mesh_.triangles.push_back(triangle);
    }
  }

  Words words_;
  TriangleMesh mesh_;
  long dimension_ = 3;
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(ErrorCode::Io, fmt::format("cannot read {}", path.string()));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TriangleMesh read_by_library(const std::filesystem::path& path) {
  MeshArraysFile file = read_mesh_arrays(path);
  TriangleMesh mesh{std::move(file.mesh.points), {}};
  for (std::size_t f = 0; f < file.mesh.faces.size(); ++f) {
    const auto face = file.mesh.faces[f];
    if (face.size() != 3) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{}: not all faces are triangles", path.string()));
    }
    mesh.triangles.push_back({face[0], face[1], face[2]});
  }
  if (mesh.triangles.empty()) {
    throw Error(ErrorCode::InvalidInput, fmt::format("{}: there is no triangle", path.string()));
  }
  return mesh;
}

}  // namespace

TriangleMesh read_msh(std::string_view text, const std::string& name) {
  return MshReader(text, name).read();
}

TriangleMesh read_medit(std::string_view text, const std::string& name) {
  return MeditReader(text, name).read();
}

TriangleMesh read_triangles(const std::filesystem::path& path) {
  if (path.extension() == ".msh") return read_msh(text_of(path), path.string());
  if (path.extension() == ".mesh") return read_medit(text_of(path), path.string());
  return read_by_library(path);
}

void write_obj(const TriangleMesh& mesh, const std::filesystem::path& path) {
  fmt::memory_buffer text;
  const auto out = fmt::appender(text);
  for (const Vec3& p : mesh.points) fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : mesh.triangles) {
    fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  write_file(path, {text.data(), text.size()});
}

void write_medit(const TriangleMesh& mesh, const std::filesystem::path& path) {
  fmt::memory_buffer text;
  const auto out = fmt::appender(text);
  fmt::format_to(out, "MeshVersionFormatted 2\nDimension 3\nVertices\n{}\n", mesh.points.size());
  for (const Vec3& p : mesh.points) fmt::format_to(out, "{} {} {} 0\n", p.x(), p.y(), p.z());
  fmt::format_to(out, "Triangles\n{}\n", mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    fmt::format_to(out, "{} {} {} 1\n", a + 1, b + 1, c + 1);
  }
  fmt::format_to(out, "End\n");
  write_file(path, {text.data(), text.size()});
}

}  // namespace surfmesh::compare
