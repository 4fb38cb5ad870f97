// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/inp_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/mesh_elements.hh"
#include "surfmesh/io/file_writer.hh"
#include "surfmesh/io/short_real.hh"

namespace surfmesh {
namespace {

/// CalculiX reads so many characters of a number.
constexpr std::size_t kRealWidth = 20;

/// Names have up to 80 characters; numbers that make them differ come behind.
constexpr std::size_t kLongestInpName = 70;

/// Numbers in a line of a set; up to 16 are read.
constexpr std::size_t kPerLine = 10;

/// Names begin with a letter and have no other characters than these.
std::string inp_word(std::string_view name) {
  std::string word;
  bool is_first = true;
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_digit = c >= '0' && c <= '9';
    if (is_first && !is_letter) word += 'N';
    is_first = false;
    // Of a character of several bytes, one stands for all.
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;
    word += is_letter || is_digit || c == '_' || c == '-' ? c : '_';
  }
  return shortened(word, kLongestInpName);
}

/// The sets of all elements and of all nodes.
constexpr std::array<std::string_view, 2> kTaken = {"SURFACE", "NODES"};

constexpr WordRule kInpWords = {inp_word, false, kTaken};

class InpWriter {
 public:
  InpWriter(const PolyMesh& mesh, const MeshNames& names, OutputFile& file)
      : elements_(mesh_elements(mesh, ".inp")),
        has_patches_(find(mesh, keys::face_patch).is_valid()),
        names_(names_with_defaults(names)),
        words_(file_words(names_, kInpWords)),
        writer_(file) {}

  void write() {
    writer_.text("*HEADING\nsurfmesh\n*NODE, NSET=NODES");
    for (std::size_t v = 0; v < elements_.points.size(); ++v) {
      writer_.number('\n', v + 1);
      for (const double x : elements_.points[v]) {
        writer_.text(", ");
        writer_.text(ShortReal(x, kRealWidth, RealStyle::Plain).text());
      }
    }
    writer_.text("\n");
    write_elements("S3", elements_.triangles, &PatchElements::triangles);
    write_elements("S4", elements_.quads, &PatchElements::quads);
    if (elements_.element_count() > 0) write_range("SURFACE", 0, elements_.element_count());
    write_patches();
    write_groups();
    write_contours();
    writer_.flush();
  }

 private:
  /// All patches with elements have names here.
  MeshNames names_with_defaults(const MeshNames& names) const {
    MeshNames result = names;
    if (!has_patches_) return {{}, {}, names.contours};
    for (const PatchElements& patch : elements_.patches) {
      if (patch.patch < 0) continue;
      const auto p = static_cast<std::size_t>(patch.patch);
      if (p >= result.patches.size()) result.patches.resize(p + 1);
      if (result.patches[p].empty()) result.patches[p] = fmt::format("PATCH_{}", p + 1);
    }
    return result;
  }

  /// Numbers go on through the patches, with triangles before quads in each.
  template <class Elements>
  void write_elements(std::string_view type, const Elements& elements,
                      IndexRange PatchElements::*range) {
    if (elements.empty()) return;
    writer_.text(fmt::format("*ELEMENT, TYPE={}", type));
    for (const PatchElements& patch : elements_.patches) {
      const bool is_quad = range == &PatchElements::quads;
      std::size_t number = patch.first() + (is_quad ? patch.triangles.size() : 0);
      for (std::size_t i = (patch.*range).first; i < (patch.*range).end; ++i) {
        writer_.number('\n', ++number);
        for (const int vertex : elements[i]) writer_.number(',', vertex + 1);
      }
    }
    writer_.text("\n");
  }

  void write_range(std::string_view name, std::size_t first, std::size_t count) {
    writer_.text(
        fmt::format("*ELSET, ELSET={}, GENERATE\n{},{},1\n", name, first + 1, first + count));
  }

  void write_title(std::string_view kind, const std::string& name, const std::string& word) {
    writer_.text(fmt::format("** {} {}: {}\n", kind, word, one_line(name)));
  }

  void write_patches() {
    for (const PatchElements& patch : elements_.patches) {
      if (patch.patch < 0) continue;
      const auto p = static_cast<std::size_t>(patch.patch);
      write_title("patch", names_.patches[p], words_.patches[p]);
      write_range(words_.patches[p], patch.first(), patch.size());
    }
  }

  void write_groups() {
    for (std::size_t g = 0; g < names_.groups.size(); ++g) {
      std::vector<std::string_view> sets;
      for (const PatchElements& patch : elements_.patches) {
        const std::vector<int>& members = names_.groups[g].patches;
        if (!std::binary_search(members.begin(), members.end(), patch.patch)) continue;
        sets.push_back(words_.patches[static_cast<std::size_t>(patch.patch)]);
      }
      if (sets.empty()) continue;
      write_title("group", names_.groups[g].name, words_.groups[g]);
      writer_.text(fmt::format("*ELSET, ELSET={}\n", words_.groups[g]));
      for (const std::string_view set : sets) writer_.text(fmt::format("{}\n", set));
    }
  }

  void write_contours() {
    for (const ContourElements& contour : elements_.contours) {
      const auto c = static_cast<std::size_t>(contour.contour);
      if (c >= words_.contours.size() || words_.contours[c].empty()) continue;
      write_title("contour", names_.contours[c], words_.contours[c]);
      writer_.text(fmt::format("*NSET, NSET={}", words_.contours[c]));
      const std::vector<int> nodes = nodes_of(elements_, contour);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        writer_.number(i % kPerLine == 0 ? '\n' : ',', nodes[i] + 1);
      }
      writer_.text("\n");
    }
  }

  MeshElements elements_;
  bool has_patches_;
  MeshNames names_;
  FileWords words_;
  FileWriter writer_;
};

void write_inp(const PolyMesh& mesh, const MeshNames& names, const OutputOptions&,
               OutputFile& file) {
  InpWriter(mesh, names, file).write();
}

std::vector<ChangedName> changed_in_inp(const PolyMesh& mesh, const MeshNames& names) {
  return changed_words(mesh, names, kInpWords);
}

std::vector<std::string> lost_in_inp(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions&) {
  std::vector<std::string> lost = lost_properties(mesh, {.contours = true});
  add_lost_sets(mesh, names, lost);
  add_lost_digits(mesh, kRealWidth, RealStyle::Plain, lost);
  add_split_faces(mesh, 4, lost);
  add_changed_words(mesh, names, kInpWords, lost);
  return lost;
}

}  // namespace

MeshFormat inp_format() {
  return {.ending = ".inp",
          .write = write_inp,
          .what_is_lost = lost_in_inp,
          .changed_names = changed_in_inp};
}

}  // namespace surfmesh
