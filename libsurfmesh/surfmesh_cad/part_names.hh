// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <TDocStd_Document.hxx>
#include <string>
#include <string_view>
#include <unordered_set>

#include "surfmesh/model/model.hh"
#include "surfmesh_cad/cad_shape.hh"

namespace surfmesh {

/// The shape of a document: a compound of the leaves of its assembly where they are placed, with
/// the names and colours of parts, bodies and faces.
CadShape named_shape(const Handle(TDocStd_Document) & document);

/// Names patches and groups by the facts of their faces.
class PartNames {
 public:
  /// Parts of the same name get a number behind it: "bolt.1", "bolt.2".
  explicit PartNames(const CadShape& cad);

  /// A name for the next patch, different from all before: that of the face, or "face12"; after
  /// that of its part, if there are several.
  std::string next_patch(const FaceFacts& facts);

  /// Add a patch to the groups of its part, its body and its colour.
  void add_to_groups(int patch, const FaceFacts& facts, std::vector<Group>& groups) const;

 private:
  std::string part_of(const FaceFacts& facts) const;

  std::vector<std::string> shared_;  ///< the names of the parts
  std::vector<std::string> unique_;  ///< the same with numbers
  std::vector<int> next_;            ///< the number of the next face of each part, and of none
  bool has_several_ = false;
  std::unordered_set<std::string> taken_;
};

/// Add a patch to the group of a name, which is made if it is not there.
void add_to_group(const std::string& name, int patch, std::vector<Group>& groups);

}  // namespace surfmesh
