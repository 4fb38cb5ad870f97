// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/bdf_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/mesh_elements.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/short_real.hh"

namespace surfmesh {
namespace {

/// Fields of 8 and of 16 columns.
constexpr std::size_t kField = 8, kLargeField = 16;

/// Numbers of nodes and elements must fit into a field.
constexpr std::size_t kMostNumbers = 99'999'999;

/// Lines have up to 72 columns.
constexpr std::size_t kLineLength = 72;

/// Names stand in quotes.
std::string word_of(std::string_view name) {
  std::string word = one_line(name);
  std::replace(word.begin(), word.end(), '"', '\'');
  return word;
}

constexpr WordRule kWords = {word_of};

/// Writes fields of fixed widths.
class Fields {
 public:
  explicit Fields(OutputFile& file) : writer_(file) {}

  void text(std::string_view text) { writer_.text(text); }

  /// The name of a card, left-aligned.
  void name(std::string_view name) {
    writer_.text("\n");
    writer_.text(name);
    blanks(kField - name.size());
  }

  void number(std::size_t number, std::size_t width) {
    std::array<char, 24> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
    right({text.data(), static_cast<std::size_t>(end.ptr - text.data())}, width);
  }

  void real(double value) {
    right(ShortReal(value, kLargeField, RealStyle::Nastran).text(), kLargeField);
  }

  void blanks(std::size_t count) { writer_.text(kBlanks.substr(0, count)); }

  void flush() { writer_.flush(); }

 private:
  static constexpr std::string_view kBlanks = "                ";

  void right(std::string_view text, std::size_t width) {
    blanks(width - std::min(width, text.size()));
    writer_.text(text);
  }

  FileWriter writer_;
};

class BdfWriter {
 public:
  BdfWriter(const PolyMesh& mesh, const MeshNames& names, OutputFile& file)
      : elements_(mesh_elements(mesh, ".bdf")),
        has_patches_(find(mesh, keys::face_patch).is_valid()),
        names_(names),
        words_(file_words(names, kWords)),
        fields_(file) {
    if (std::max(elements_.points.size(), elements_.element_count()) > kMostNumbers) {
      throw Error(ErrorCode::InvalidInput, ".bdf files hold up to 99999999 nodes and elements");
    }
  }

  void write() {
    fields_.text("$ surfmesh\nSOL 101\nCEND");
    if (has_patches_) write_groups();
    write_contours();
    fields_.text("\nBEGIN BULK");
    if (has_patches_) write_patch_names();
    for (std::size_t v = 0; v < elements_.points.size(); ++v) write_point(v);
    for (const PatchElements& patch : elements_.patches) write_elements(patch);
    fields_.text("\nENDDATA\n");
    fields_.flush();
  }

 private:
  /// Number and words of a set: its name as a comment, then the numbers of its members.
  void write_set(int kind, const std::string& name, const std::vector<std::string>& members) {
    ++sets_;
    fields_.text(fmt::format("\n$HMSET {:8} {:8} \"{}\"", sets_, kind, name));
    std::string line = fmt::format("SET {} = ", sets_);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::string word = members[i] + (i + 1 < members.size() ? "," : "");
      if (line.size() + word.size() > kLineLength) {
        fields_.text("\n" + line);
        line = "  ";
      }
      line += word;
    }
    fields_.text("\n" + line);
  }

  void write_groups() {
    constexpr int kElementSet = 2;
    for (std::size_t g = 0; g < names_.groups.size(); ++g) {
      std::vector<std::string> ranges;
      const std::vector<int>& patches = names_.groups[g].patches;
      for (const PatchElements& patch : elements_.patches) {
        if (!std::binary_search(patches.begin(), patches.end(), patch.patch)) continue;
        const std::size_t first = patch.first() + 1, last = patch.first() + patch.size();
        ranges.push_back(first == last ? fmt::format("{}", first)
                                       : fmt::format("{} THRU {}", first, last));
      }
      if (!ranges.empty()) write_set(kElementSet, words_.groups[g], ranges);
    }
  }

  void write_contours() {
    constexpr int kNodeSet = 1;
    for (const ContourElements& contour : elements_.contours) {
      const auto c = static_cast<std::size_t>(contour.contour);
      if (c >= words_.contours.size() || words_.contours[c].empty()) continue;
      std::vector<std::string> nodes;
      for (const int node : nodes_of(elements_, contour)) {
        nodes.push_back(fmt::format("{}", node + 1));
      }
      write_set(kNodeSet, words_.contours[c], nodes);
    }
  }

  void write_patch_names() {
    for (const PatchElements& patch : elements_.patches) {
      if (patch.patch < 0) continue;
      const auto p = static_cast<std::size_t>(patch.patch);
      if (p >= words_.patches.size() || words_.patches[p].empty()) continue;
      fields_.text(fmt::format("\n$HMNAME COMP {:19}\"{}\"", p + 1, words_.patches[p]));
    }
  }

  /// Large fields: two lines.
  void write_point(std::size_t v) {
    const Vec3& point = elements_.points[v];
    fields_.name("GRID*");
    fields_.number(v + 1, kLargeField);
    fields_.blanks(kLargeField);  // the basic coordinate system
    fields_.real(point.x());
    fields_.real(point.y());
    fields_.name("*");
    fields_.real(point.z());
  }

  void write_elements(const PatchElements& patch) {
    const std::size_t property =
        static_cast<std::size_t>(patch.patch >= 0               ? patch.patch + 1
                                 : elements_.patches.size() > 1 ? greatest_patch() + 2
                                                                : 1);
    std::size_t number = patch.first();
    const auto write_all = [&](std::string_view name, const auto& elements, IndexRange range) {
      for (std::size_t i = range.first; i < range.end; ++i) {
        fields_.name(name);
        fields_.number(++number, kField);
        fields_.number(property, kField);
        for (const int vertex : elements[i]) {
          fields_.number(static_cast<std::size_t>(vertex) + 1, kField);
        }
      }
    };
    write_all("CTRIA3", elements_.triangles, patch.triangles);
    write_all("CQUAD4", elements_.quads, patch.quads);
  }

  int greatest_patch() const {
    int greatest = static_cast<int>(names_.patches.size()) - 1;
    for (const PatchElements& patch : elements_.patches) {
      greatest = std::max(greatest, patch.patch);
    }
    return greatest;
  }

  MeshElements elements_;
  bool has_patches_;
  const MeshNames& names_;
  FileWords words_;
  Fields fields_;
  int sets_ = 0;
};

void write_bdf(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
               OutputFile& file) {
  BdfWriter(mesh, names, file).write();
}

std::vector<ChangedName> changed_in_bdf(const PolyMesh& mesh, const MeshNames& names) {
  return changed_words(mesh, names, kWords);
}

std::vector<std::string> lost_in_bdf(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost = lost_properties(mesh, {.contours = true});
  add_lost_sets(mesh, names, lost);
  add_lost_digits(mesh, kLargeField, RealStyle::Nastran, lost);
  add_split_faces(mesh, 4, lost);
  add_changed_words(mesh, names, kWords, lost);
  return lost;
}

}  // namespace

MeshFormat bdf_format() {
  return {.ending = ".bdf",
          .write = write_bdf,
          .what_is_lost = lost_in_bdf,
          .changed_names = changed_in_bdf};
}

}  // namespace surfmesh
