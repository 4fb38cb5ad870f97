// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "surfmesh/formats/cage_text.hh"

namespace surfmesh {

/// An index that is checked at the end, for what it names may come later.
struct LaterReference {
  int line = 0;
  int index = 0;    ///< from 0
  int written = 0;  ///< as it stands in the file
};

/// Reads the tags `t` of OpenSubdiv in an OBJ file into the cage.
class ObjTags {
 public:
  /// Vertices that tags name are added to `later_vertices`. All must outlive the object.
  ObjTags(CageText& text, std::vector<LaterReference>& later_vertices)
      : text_(text),
        scanner_(text.scanner),
        warnings_(text.warnings),
        cage_(text.cage),
        later_vertices_(later_vertices) {}

  /// Read the rest of a line that begins with t.
  /// Throws   InvalidInput
  void read();

  /// Give holes the numbers of their faces in the cage, which has not all faces of the file; to be
  /// called at the end.
  /// Throws   InvalidInput for holes in faces that are not there
  void number_holes();

  /// Leave out creases that name no edge of a face, with a warning that knows the line.
  void drop_creases_without_edge();

 private:
  using Reference = LaterReference;

  /// The two or three parts of a tag's values: `t name ints/reals/words ...`.
  struct Values {
    std::vector<int> ints;
    std::vector<double> reals;
    std::vector<std::string_view> words;
  };

  Values read_values();
  void read_crease(const Values& values);
  void read_corner(const Values& values);
  void read_boundary_rule(const Values& values);
  bool read_choice(const Values& values, std::string_view off, std::string_view on);
  int vertex_of_tag(int index);
  double sharpness_of(const Values& values, std::size_t i, std::size_t count) const;

  const CageText& text_;
  TextScanner& scanner_;
  WarningList& warnings_;
  Cage& cage_;
  std::vector<Reference>& later_vertices_;
  std::vector<Reference> hole_faces_;
  std::vector<int> crease_lines_;  ///< parallel to the creases of the cage
};

}  // namespace surfmesh
