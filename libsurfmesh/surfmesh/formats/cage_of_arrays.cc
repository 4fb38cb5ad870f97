// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/cage_of_arrays.hh"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "surfmesh/core/mesh_arrays.hh"

namespace surfmesh {
namespace {

/// The faces of each patch that has any: numbers may be far apart.
std::unordered_map<int, std::vector<int>> faces_of_patches(const MeshArrays& mesh) {
  std::unordered_map<int, std::vector<int>> faces;
  for (std::size_t f = 0; f < mesh.patches.size(); ++f) {
    const int patch = mesh.patches[f];
    if (patch >= 0) faces[patch].push_back(static_cast<int>(f));
  }
  return faces;
}

/// Collects groups of faces by their names.
class FaceGroups {
 public:
  void add(const std::string& name, const std::vector<int>& faces) {
    if (name.empty() || faces.empty()) return;
    const auto [entry, is_new] = number_of_.try_emplace(name, groups_.size());
    if (is_new) groups_.push_back({name, {}});
    std::vector<int>& all = groups_[entry->second].faces;
    all.insert(all.end(), faces.begin(), faces.end());
  }

  /// In the order of their first face.
  std::vector<Cage::FaceGroup> finish() {
    for (Cage::FaceGroup& group : groups_) {
      std::sort(group.faces.begin(), group.faces.end());
      group.faces.erase(std::unique(group.faces.begin(), group.faces.end()), group.faces.end());
    }
    std::stable_sort(groups_.begin(), groups_.end(),
                     [](const auto& a, const auto& b) { return a.faces[0] < b.faces[0]; });
    return std::move(groups_);
  }

 private:
  std::unordered_map<std::string, std::size_t> number_of_;
  std::vector<Cage::FaceGroup> groups_;
};

std::vector<Cage::FaceGroup> groups_of(const MeshArrays& mesh) {
  const auto faces = faces_of_patches(mesh);
  FaceGroups groups;
  const auto add = [&](const std::string& name, int patch) {
    const auto found = faces.find(patch);
    if (found != faces.end()) groups.add(name, found->second);
  };
  for (std::size_t p = 0; p < mesh.names.patches.size(); ++p) {
    add(mesh.names.patches[p], static_cast<int>(p));
  }
  for (const Group& group : mesh.names.groups) {
    for (const int patch : group.patches) add(group.name, patch);
  }
  return groups.finish();
}

}  // namespace

Cage cage_of(MeshArraysFile file) {
  Cage cage;
  cage.groups = groups_of(file.mesh);
  cage.faces.reserve(file.mesh.faces.size());
  for (std::size_t f = 0; f < file.mesh.faces.size(); ++f) {
    const auto vertices = file.mesh.faces[f];
    cage.faces.emplace_back(vertices.begin(), vertices.end());
  }
  cage.points = std::move(file.mesh.points);
  cage.notices = std::move(file.notices);
  return cage;
}

}  // namespace surfmesh
