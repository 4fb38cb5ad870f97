// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/text_scanner.hh"

namespace surfmesh {

/// What is wrong with the vertices of a face.
enum class CornerFault { None, TwiceInARow, TooFew, Twice };

/// Drop all but one of equal vertices in a row, also across the end, and tell what was or is wrong.
/// TooFew is also for a border that runs along each edge there and back. Readers leave such faces
/// out, as others do.
CornerFault mend_corners(std::vector<int>& corners);

/// The fault as it stands in messages.
const char* text_of(CornerFault fault);

/// What faces are read for.
///
/// Cage     a vertex that comes several times in a row stays so, for a scheme has its own surface
///          for such a face
/// Mesh     of equal vertices in a row one is taken, with a warning
enum class ReadFor { Cage, Mesh };

/// What the readers of OBJ and OFF share: the text, the cage that is made of it, the warnings.
class CageText {
 public:
  CageText(std::string_view text, const std::string& name, TextScanner::Joining joining,
           ReadFor purpose)
      : scanner(text, name, joining), warnings(name), purpose_(purpose) {}

  /// Go to the first line.
  /// Throws   InvalidInput if there is none
  void begin();

  /// Check the vertices of a face just read from the current line and add it to the cage as the
  /// purpose asks for. One with TooFew is left out, with a warning.
  ///
  /// Returns  false if it was left out
  /// Throws   InvalidInput for a vertex that comes twice but not in a row
  bool add_face(const std::vector<int>& corners);

  /// A point given by homogeneous coordinates: divided by its weight, with a warning unless that
  /// is 1.
  ///
  /// Throws   InvalidInput for weight 0
  Vec3 divided(const Vec3& point, double weight);

  /// The faces that were left out, as the file counts them from 0.
  const std::vector<int>& left_out() const { return left_out_; }
  std::vector<std::size_t> left_out_of_mesh() const { return {left_out_.begin(), left_out_.end()}; }

  /// Throws   InvalidInput if the cage has no vertices or no faces
  void check_not_empty() const;

  /// The cage with its warnings.
  Cage finish();

  TextScanner scanner;
  WarningList warnings;
  Cage cage;

 private:
  ReadFor purpose_;
  std::vector<int> left_out_;
};

/// The faces of a cage, without its groups, as those of a mesh.
MeshArraysFile arrays_of(Cage cage);

}  // namespace surfmesh
