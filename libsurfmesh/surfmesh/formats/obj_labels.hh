// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "surfmesh/cage/cage.hh"
#include "surfmesh/core/mesh_names.hh"

namespace surfmesh {

/// The group of faces that no `g` names, and of a `g` without a name.
inline constexpr const char* kNoGroup = "default";

/// What the lines `g`, `o` and `usemtl` of an OBJ file say of the faces after them.
struct ObjLabel {
  std::vector<std::string> groups;  ///< words of the last `g`
  std::string object;
  std::string material;

  friend auto operator<=>(const ObjLabel&, const ObjLabel&) = default;
};

/// The labels of the faces of an OBJ file. One that comes again is the same label.
class ObjLabels {
 public:
  void set_groups(std::vector<std::string> words);
  void set_object(std::string name);
  void set_material(std::string name);

  void add_face();

  /// The groups of a cage: all names, in the order of their first face.
  std::vector<Cage::FaceGroup> cage_groups() const;

  /// The patches of a mesh. Faces of one label are one patch; it is named after the last word of
  /// its `g`, else its material, else its object. The other names, and those that several patches
  /// would have, are groups. Patches are in the order in which the file names them.
  ///
  /// Returns  by face, -1 for none; nothing where no face has a name
  std::vector<int> patches(MeshNames& names) const;

 private:
  int number_of_label();
  std::vector<char> have_faces() const;

  ObjLabel label_;
  bool is_number_current_ = false;
  int number_ = 0;
  std::map<ObjLabel, int> number_of_;
  std::vector<ObjLabel> labels_;
  std::vector<int> label_of_face_;
};

/// Makes names differ: one that was there already gets a number, "wing_2".
class DifferentNames {
 public:
  std::string add(const std::string& name);

 private:
  std::unordered_map<std::string, int> last_number_;
};

}  // namespace surfmesh
