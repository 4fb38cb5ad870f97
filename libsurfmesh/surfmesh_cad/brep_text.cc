// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh_cad/brep_text.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

#include "surfmesh/core/error.hh"
#include "surfmesh_cad/brep_geometry.hh"
#include "surfmesh_cad/brep_words.hh"

namespace surfmesh {
namespace {

/// The first line that tells the format, and the sections that shapes refer to.
constexpr std::string_view kHeader = "CASCADE Topology V";
constexpr std::array<std::string_view, 7> kSections = {
    "Locations", "Curve2ds",      "Curves", "Polygon3D", "PolygonOnTriangulations",
    "Surfaces",  "Triangulations"};
enum Section { Locations, Curve2ds, Curves, Polygons, PolygonsOnTriangulations, Surfaces, Meshes };

struct SectionStart {
  int count = 0;
  std::size_t end = 0;  ///< behind the count
};

/// The number behind the name of a section.
SectionStart section_start(std::string_view text, std::string_view name) {
  const std::string start = fmt::format("\n{} ", name);
  const std::size_t at = text.find(start);
  if (at == std::string_view::npos) fail_brep(fmt::format("it has no section {}", name));
  SectionStart section;
  const char* last = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + at + start.size(), last, section.count);
  if (error != std::errc() || section.count < 0) {
    fail_brep(fmt::format("the number of {} is none", name));
  }
  section.end = static_cast<std::size_t>(stop - text.data());
  return section;
}

int version_of(std::string_view text) {
  const std::size_t at = text.find(kHeader);
  if (at == std::string_view::npos || at + kHeader.size() >= text.size()) {
    throw Error(ErrorCode::InvalidInput,
                "this is no BREP file as text: it has no line CASCADE Topology V1, V2 or V3");
  }
  return text[at + kHeader.size()] - '0';
}

/// The section ends where the next one begins.
void check_next(BrepWords& words, Section next) {
  const std::string_view name = kSections[next];
  if (const std::string_view word = words.word(); word != name) {
    fail_brep(fmt::format("{} stands where {} ought to begin", word, name));
  }
}

/// A location is a matrix of three rows and four columns, or powers of those before it.
void check_locations(BrepWords& words, int count) {
  for (int l = 0; l < count; ++l) {
    if (words.count(1, 2) == 1) {
      words.reals(12);
      continue;
    }
    while (words.integer() != 0) words.integer();
  }
}

/// Check the sections of locations, curves and surfaces.
void check_geometry(std::string_view text) {
  const SectionStart locations = section_start(text, kSections[Locations]);
  BrepWords places(text, locations.end);
  check_locations(places, locations.count);
  const SectionStart curve2ds = section_start(text, kSections[Curve2ds]);
  BrepWords words(text, curve2ds.end);
  check_brep_curves(words, curve2ds.count, 2);
  check_next(words, Curves);
  check_brep_curves(words, words.integer(), 3);
  check_next(words, Polygons);
  const SectionStart surfaces = section_start(text, kSections[Surfaces]);
  words = BrepWords(text, surfaces.end);
  check_brep_surfaces(words, surfaces.count);
  check_next(words, Meshes);
}

/// Reads the section of shapes word by word. Their numbers run down: the first has the greatest.
class ShapeWords {
 public:
  explicit ShapeWords(std::string_view text) : version_(version_of(text)), words_(text) {
    for (std::size_t s = 0; s < kSections.size(); ++s) {
      counts_[s] = section_start(text, kSections[s]).count;
    }
    const SectionStart shapes = section_start(text, "TShapes");
    shapes_ = shapes.count;
    words_ = BrepWords(text, shapes.end);
  }

  void check() {
    for (number_ = shapes_; number_ > 0; --number_) check_shape();
    number_ = -1;
    check_reference(word());
  }

 private:
  [[noreturn]] void fail_here(const std::string& reason) const {
    fail_brep(number_ < 0 ? reason : fmt::format("shape {}: {}", number_, reason));
  }

  std::string_view word() { return words_.word(); }
  void skip(int words) { words_.skip(words); }
  int integer() { return words_.integer(); }

  /// An index of a section. 0 stands for none where that is possible.
  void index(Section section, int least = 1) {
    const int value = integer();
    const int count = counts_[section];
    if (value >= least && value <= count) return;
    fail_here(fmt::format("it refers to number {} of {} {}", value, count, kSections[section]));
  }

  void location() { index(Locations, 0); }

  /// "+13 0": the shape 13, at the location 0. Shapes are made of those before them.
  void check_reference(std::string_view first) {
    if (first.empty() || std::string_view("+-ie").find(first.front()) == std::string_view::npos) {
      fail_here(fmt::format("{} is no reference to a shape", first));
    }
    const int number = BrepWords::integer(first.substr(1));
    if (number < 1 || number > shapes_ || number <= number_) {
      fail_here(fmt::format("it refers to shape {} of {}", number, shapes_));
    }
    location();
  }

  void check_shape() {
    const std::string_view kind = word();
    if (kind == "Ve") {
      check_vertex();
    } else if (kind == "Ed") {
      check_edge();
    } else if (kind == "Fa") {
      check_face();
    } else if (kind != "Wi" && kind != "Sh" && kind != "So" && kind != "CS" && kind != "Co") {
      fail_here(fmt::format("{} is no kind of shape", kind));
    }
    if (kind != "Fa") word();  // the flags
    for (std::string_view next = word(); next != "*"; next = word()) check_reference(next);
  }

  void check_vertex() {
    words_.reals(4);
    for (;;) {
      words_.reals(1);
      switch (integer()) {
        case 0:
          return;
        case 1:
          index(Curves);
          break;
        case 2:
          index(Curve2ds);
          index(Surfaces);
          break;
        case 3:
          words_.reals(1);
          index(Surfaces);
          break;
        default:
          fail_here("a point is given on something unknown");
      }
      location();
    }
  }

  /// A tolerance and three flags, then its curves.
  void check_edge() {
    words_.reals(1);
    for (int flag = 0; flag < 3; ++flag) integer();
    for (int kind = integer(); kind != 0; kind = integer()) check_curve(kind);
  }

  void check_curve(int kind) {
    switch (kind) {
      case 1:
        index(Curves, 0);
        location();
        return words_.reals(2);
      case 2:
      case 3:
        return check_curve_on_surface(kind == 3);
      case 4:
        skip(1);
        index(Surfaces);
        location();
        index(Surfaces);
        return location();
      case 5:
        index(Polygons);
        return location();
      case 6:
      case 7:
        index(PolygonsOnTriangulations);
        if (kind == 7) index(PolygonsOnTriangulations);
        index(Meshes);
        return location();
      default:
        fail_here(fmt::format("{} is no kind of curve", kind));
    }
  }

  void check_curve_on_surface(bool is_seam) {
    index(Curve2ds);
    // The number and the continuity may stand together: "4CN".
    if (is_seam) check_second_curve();
    index(Surfaces);
    location();
    words_.reals(2);
    if (version_ == 2) words_.reals(4);  // its ends
  }

  void check_second_curve() {
    const std::string_view both = word();
    const std::size_t digits = std::min(both.find_first_not_of("0123456789"), both.size());
    const int value = BrepWords::integer(both.substr(0, digits));
    if (value < 1 || value > counts_[Curve2ds]) {
      fail_here(fmt::format("it refers to curve {} of {}", value, counts_[Curve2ds]));
    }
    if (digits == both.size()) skip(1);
  }

  /// A face may have a triangulation: "2" and its index, before the flags of seven digits.
  void check_face() {
    integer();  // a flag
    words_.reals(1);
    index(Surfaces, 0);
    location();
    constexpr std::size_t kFlags = 7;
    if (word().size() == kFlags) return;
    index(Meshes);
    skip(1);
  }

  int version_;
  BrepWords words_;
  int shapes_ = 0;
  int number_ = -1;
  std::array<int, kSections.size()> counts_ = {};
};

}  // namespace

void check_brep_text(std::string_view text) {
  ShapeWords shapes(text);  // which tells first what is no BREP file at all
  check_geometry(text);
  shapes.check();
}

}  // namespace surfmesh
