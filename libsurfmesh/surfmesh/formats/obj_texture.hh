// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "surfmesh/formats/cage_text.hh"
#include "surfmesh/formats/obj_tags.hh"

namespace surfmesh {

/// Reads the texture coordinates of an OBJ file, `vt` and the second index of corners, into the
/// cage. They do not matter for its surface: what is wrong with them gives a warning.
class ObjTexture {
 public:
  /// The text must outlive the object.
  explicit ObjTexture(CageText& text) : text_(text) {}

  /// Read the rest of a line that begins with vt.
  void read_point();

  void begin_face() { corners_.clear(); }

  /// Take the next corner of a face: what comes after its vertex index, "/vt", "//vn", "/vt/vn" or
  /// nothing.
  void add_corner(std::string_view indices);

  /// Keep the corners of the face for the last one of the cage.
  void end_face();

  /// Check that what the corners name is there; to be called at the end.
  void finish();

 private:
  Cage::Texture& texture() { return text_.cage.texture; }

  CageText& text_;
  std::vector<int> corners_;  ///< of the face that is being read, -1 for none
  std::vector<LaterReference> later_;
};

}  // namespace surfmesh
