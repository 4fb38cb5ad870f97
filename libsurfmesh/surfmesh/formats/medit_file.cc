// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/medit_file.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/medit_reader.hh"
#include "surfmesh/formats/mesh_elements.hh"
#include "surfmesh/formats/vertex_metric.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

constexpr int kDimension = 3;
/// A symmetric tensor, among the kinds of solutions.
constexpr int kSymmetricTensor = 3;

/// A section by its name in text and its number in binary files.
struct Keyword {
  std::string_view name;
  int code;
};

constexpr Keyword kVertices = {"Vertices", 4}, kEdges = {"Edges", 5}, kTriangles = {"Triangles", 6},
                  kQuads = {"Quadrilaterals", 7}, kCorners = {"Corners", 13},
                  kRidges = {"Ridges", 14}, kSolution = {"SolAtVertices", 62};
constexpr int kDimensionCode = 3, kEndCode = 54;

/// Version 2 has double precision and positions in the file of 32 bits, version 3 of 64.
constexpr int kShortVersion = 2, kLongVersion = 3;

/// The lines of sections, as text or binary. Sections of binary files begin with their number and
/// the place of the next one.
class MeditSink {
 public:
  /// `most_bytes` is a bound of the size of the file.
  MeditSink(OutputFile& file, bool is_binary, std::uint64_t most_bytes)
      : writer_(file),
        is_binary_(is_binary),
        is_long_(most_bytes > std::uint64_t{std::numeric_limits<std::int32_t>::max()}) {
    if (is_binary_) {
      put(int{1});  // tells the order of bytes
      put(is_long_ ? kLongVersion : kShortVersion);
      put(kDimensionCode);
      put_place(place_ + place_size() + sizeof(int));
      put(kDimension);
    } else {
      writer_.text("MeshVersionFormatted 2\n\nDimension 3\n");
    }
  }

  /// Text only.
  void comment(std::string_view text) {
    if (!is_binary_) writer_.text(fmt::format("# {}\n", text));
  }

  /// Begin a section of `count` lines of `bytes` each, after `head` words.
  void begin(Keyword keyword, std::size_t count, std::size_t bytes,
             std::initializer_list<int> head) {
    if (is_binary_) {
      put(keyword.code);
      put_place(place_ + place_size() + sizeof(int) * (1 + head.size()) + count * bytes);
      put(static_cast<int>(count));
      for (const int word : head) put(word);
      return;
    }
    writer_.text(fmt::format("\n{}\n{}\n", keyword.name, count));
    if (head.size() > 0) writer_.text(fmt::format("{}\n", fmt::join(head, " ")));
  }

  template <class Number>
  void number(Number number) {
    if (is_binary_) {
      put(number);
    } else {
      writer_.number(' ', number);
    }
  }

  void end_line() {
    if (!is_binary_) writer_.text("\n");
  }

  void finish() {
    if (is_binary_) {
      put(kEndCode);
      put_place(0);
    } else {
      writer_.text("\nEnd\n");
    }
    writer_.flush();
  }

 private:
  std::size_t place_size() const { return is_long_ ? sizeof(std::int64_t) : sizeof(std::int32_t); }

  template <class Number>
  void put(Number number) {
    writer_.bytes(number);
    place_ += sizeof(Number);
  }

  void put_place(std::uint64_t place) {
    if (is_long_) {
      put(static_cast<std::int64_t>(place));
    } else {
      put(static_cast<std::int32_t>(place));
    }
  }

  FileWriter writer_;
  bool is_binary_;
  bool is_long_;
  std::uint64_t place_ = 0;
};

std::string medit_word(std::string_view name) { return one_line(name); }

constexpr WordRule kMeditWords = {medit_word};

/// The numbers of a line: an element with its reference, a corner, a ridge.
constexpr std::size_t bytes_of(std::size_t integers) { return integers * sizeof(int); }

class MeditWriter {
 public:
  MeditWriter(const PolyMesh& mesh, const MeshNames& names, bool is_binary, OutputFile& file)
      : elements_(mesh_elements(mesh, ".mesh")),
        names_(names),
        has_patches_(find(mesh, keys::face_patch).is_valid()),
        out_(file, is_binary, most_bytes(elements_)) {}

  void write() {
    write_names();
    write_points();
    write_elements(kTriangles, elements_.triangles, &PatchElements::triangles);
    write_elements(kQuads, elements_.quads, &PatchElements::quads);
    write_segments();
    write_corners();
    write_ridges();
    out_.finish();
  }

 private:
  static std::uint64_t most_bytes(const MeshElements& elements) {
    constexpr std::uint64_t kSections = 1000;
    return kSections + elements.points.size() * (kPointBytes + bytes_of(1)) +
           elements.element_count() * bytes_of(5) + elements.segments.size() * bytes_of(4);
  }

  void write_names() {
    const FileWords words = file_words(names_, kMeditWords);
    const auto write_all = [&](std::string_view kind, const std::vector<std::string>& all) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].empty()) out_.comment(fmt::format("{} {} {}", kind, i + 1, all[i]));
      }
    };
    if (has_patches_) {
      write_all("patch", words.patches);
      for (std::size_t g = 0; g < names_.groups.size(); ++g) {
        std::string line = "group";
        for (const int patch : names_.groups[g].patches) line += fmt::format(" {}", patch + 1);
        out_.comment(fmt::format("{}: {}", line, words.groups[g]));
      }
    }
    write_all("contour", words.contours);
  }

  void write_points() {
    out_.begin(kVertices, elements_.points.size(), kPointBytes + bytes_of(1), {});
    for (const Vec3& point : elements_.points) {
      for (const double x : point) out_.number(x);
      out_.number(int{0});
      out_.end_line();
    }
  }

  template <class Elements>
  void write_elements(Keyword keyword, const Elements& elements, IndexRange PatchElements::*range) {
    if (elements.empty()) return;
    out_.begin(keyword, elements.size(), bytes_of(elements.front().size() + 1), {});
    for (const PatchElements& patch : elements_.patches) {
      for (std::size_t i = (patch.*range).first; i < (patch.*range).end; ++i) {
        for (const int vertex : elements[i]) out_.number(vertex + 1);
        out_.number(patch.patch + 1);
        out_.end_line();
      }
    }
  }

  void write_segments() {
    if (elements_.segments.empty()) return;
    out_.begin(kEdges, elements_.segments.size(), bytes_of(3), {});
    for (const ContourSegment& segment : elements_.segments) {
      for (const int number : {segment.from, segment.to, segment.contour}) out_.number(number + 1);
      out_.end_line();
    }
  }

  void write_numbers(Keyword keyword, const std::vector<int>& numbers) {
    if (numbers.empty()) return;
    out_.begin(keyword, numbers.size(), bytes_of(1), {});
    for (const int number : numbers) {
      out_.number(number);
      out_.end_line();
    }
  }

  void write_corners() {
    std::vector<int> corners;
    const std::vector<char> is_end = contour_ends(elements_);
    for (std::size_t v = 0; v < is_end.size(); ++v) {
      if (is_end[v] != 0) corners.push_back(static_cast<int>(v) + 1);
    }
    write_numbers(kCorners, corners);
  }

  void write_ridges() {
    std::vector<int> ridges;
    for (std::size_t s = 0; s < elements_.segments.size(); ++s) {
      if (!elements_.segments[s].is_smooth) ridges.push_back(static_cast<int>(s) + 1);
    }
    write_numbers(kRidges, ridges);
  }

  static constexpr std::size_t kPointBytes = kDimension * sizeof(double);

  MeshElements elements_;
  const MeshNames& names_;
  bool has_patches_;
  MeditSink out_;
};

void write_metrics(const PolyMesh& mesh, bool is_binary, OutputFile& file) {
  const std::vector<SpaceMetric> metrics = vertex_metrics(mesh);
  constexpr std::uint64_t kSections = 100;
  MeditSink out(file, is_binary, kSections + metrics.size() * sizeof(SpaceMetric));
  out.begin(kSolution, metrics.size(), sizeof(SpaceMetric), {1, kSymmetricTensor});
  for (const auto& [xx, yy, zz, xy, yz, xz] : metrics) {
    for (const double x : {xx, xy, yy, xz, yz, zz}) out.number(x);  // the lower half, row by row
    out.end_line();
  }
  out.finish();
}

template <bool is_binary>
void write_medit(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
                 OutputFile& file) {
  MeditWriter(mesh, names, is_binary, file).write();
}

template <bool is_binary>
void write_companion_of_medit(const PolyMesh& mesh, OutputFile& file) {
  write_metrics(mesh, is_binary, file);
}

std::vector<ChangedName> changed_in_medit(const PolyMesh& mesh, const MeshNames& names) {
  return changed_words(mesh, names, kMeditWords);
}

std::vector<std::string> lost_in_medit(const PolyMesh& mesh, const MeshNames& names,
                                       const OutputOptions&) {
  const bool has_metrics = has_vertex_metrics(mesh);
  std::vector<std::string> lost = lost_properties(mesh, {.metric = has_metrics, .contours = true});
  if (has_metrics) lost.push_back("the metric of corners where those at a vertex differ");
  add_split_faces(mesh, 4, lost);
  add_changed_words(mesh, names, kMeditWords, lost);
  return lost;
}

/// Binary files have no comments.
std::vector<std::string> lost_in_meditb(const PolyMesh& mesh, const MeshNames& names,
                                        const OutputOptions& options) {
  std::vector<std::string> lost = lost_in_medit(mesh, {}, options);
  const bool has_names = !names.groups.empty() || !names.patches.empty() || !names.contours.empty();
  if (has_names) lost.push_back("the names of patches, groups and contours");
  return lost;
}

}  // namespace

MeshFormat medit_format() {
  return {.ending = ".mesh",
          .parse = parse_medit,
          .write = write_medit<false>,
          .what_is_lost = lost_in_medit,
          .changed_names = changed_in_medit,
          .companion_ending = ".sol",
          .has_companion = has_vertex_metrics,
          .write_companion = write_companion_of_medit<false>};
}

MeshFormat meditb_format() {
  return {.ending = ".meshb",
          .parse = parse_medit,
          .write = write_medit<true>,
          .what_is_lost = lost_in_meditb,
          .companion_ending = ".solb",
          .has_companion = has_vertex_metrics,
          .write_companion = write_companion_of_medit<true>};
}

}  // namespace surfmesh
