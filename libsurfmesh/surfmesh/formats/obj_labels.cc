// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/obj_labels.hh"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace surfmesh {
namespace {

/// All names of a label, each once.
std::vector<std::string> names_of(const ObjLabel& label) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
    }
  };
  for (const std::string& group : label.groups) add(group);
  add(label.object);
  add(label.material);
  return names;
}

/// A label as the patch of its faces and the groups of that patch.
struct LabelRoles {
  std::string patch;
  std::vector<std::string> groups;
};

LabelRoles roles_of(const ObjLabel& label) {
  LabelRoles roles;
  if (!label.groups.empty() && label.groups != std::vector<std::string>{kNoGroup}) {
    roles.patch = label.groups.back();
    roles.groups.assign(label.groups.begin(), label.groups.end() - 1);
  }
  if (!label.object.empty()) roles.groups.push_back(label.object);
  if (!label.material.empty()) roles.groups.push_back(label.material);
  if (roles.patch.empty() && !roles.groups.empty()) {
    roles.patch = std::move(roles.groups.back());
    roles.groups.pop_back();
  }
  return roles;
}

/// Collects groups by their names.
class GroupCollector {
 public:
  void add(const std::string& name, int patch, bool is_material = false) {
    const auto [entry, is_new] = number_of_.try_emplace(name, groups_.size());
    if (is_new) groups_.push_back({name, {}});
    groups_[entry->second].patches.push_back(patch);
    groups_[entry->second].is_material |= is_material;
  }

  std::vector<Group> finish() {
    put_in_order(groups_);
    return std::move(groups_);
  }

 private:
  std::unordered_map<std::string, std::size_t> number_of_;
  std::vector<Group> groups_;
};

}  // namespace

void ObjLabels::set_groups(std::vector<std::string> words) {
  label_.groups = std::move(words);
  if (label_.groups.empty()) label_.groups.emplace_back(kNoGroup);
  is_number_current_ = false;
  number_of_label();  // groups are named in the order of their patches, before they have faces
}

void ObjLabels::set_object(std::string name) {
  label_.object = std::move(name);
  is_number_current_ = false;
}

void ObjLabels::set_material(std::string name) {
  label_.material = std::move(name);
  is_number_current_ = false;
}

int ObjLabels::number_of_label() {
  if (!is_number_current_) {
    const auto [entry, is_new] = number_of_.try_emplace(label_, static_cast<int>(labels_.size()));
    if (is_new) labels_.push_back(label_);
    number_ = entry->second;
    is_number_current_ = true;
  }
  return number_;
}

void ObjLabels::add_face() { label_of_face_.push_back(number_of_label()); }

std::vector<Cage::FaceGroup> ObjLabels::cage_groups() const {
  std::vector<Cage::FaceGroup> groups;
  std::unordered_map<std::string, std::size_t> number_of_name;
  std::vector<std::vector<std::size_t>> groups_of(labels_.size());
  std::vector<char> is_known(labels_.size(), 0);
  for (std::size_t f = 0; f < label_of_face_.size(); ++f) {
    const auto label = static_cast<std::size_t>(label_of_face_[f]);
    if (!std::exchange(is_known[label], char{1})) {
      for (const std::string& name : names_of(labels_[label])) {
        const auto [entry, is_new] = number_of_name.try_emplace(name, groups.size());
        if (is_new) groups.push_back({name, {}});
        groups[entry->second].is_material |= name == labels_[label].material;
        groups_of[label].push_back(entry->second);
      }
    }
    for (const std::size_t group : groups_of[label]) {
      groups[group].faces.push_back(static_cast<int>(f));
    }
  }
  return groups;
}

std::vector<char> ObjLabels::have_faces() const {
  std::vector<char> have_faces(labels_.size(), 0);
  for (const int label : label_of_face_) have_faces[static_cast<std::size_t>(label)] = 1;
  return have_faces;
}

std::vector<int> ObjLabels::patches(MeshNames& names) const {
  std::vector<LabelRoles> roles;
  for (const ObjLabel& label : labels_) roles.push_back(roles_of(label));
  // A name without faces is a patch only where no label of this name has any.
  const std::vector<char> is_used = have_faces();
  std::unordered_set<std::string> used_names;
  for (std::size_t l = 0; l < roles.size(); ++l) {
    if (is_used[l] != 0) used_names.insert(roles[l].patch);
  }
  std::vector<int> patch_of(labels_.size(), -1);
  std::map<std::string, std::vector<int>> patches_of_name;
  DifferentNames different;
  GroupCollector groups;
  for (std::size_t l = 0; l < roles.size(); ++l) {
    const std::string& name = roles[l].patch;
    if (name.empty() || (is_used[l] == 0 && !used_names.insert(name).second)) continue;
    patch_of[l] = static_cast<int>(names.patches.size());
    names.patches.push_back(different.add(name));
    patches_of_name[name].push_back(patch_of[l]);
    for (const std::string& group : roles[l].groups) {
      groups.add(group, patch_of[l], group == labels_[l].material);
    }
  }
  for (const auto& [name, patches] : patches_of_name) {
    if (patches.size() < 2) continue;
    for (const int patch : patches) groups.add(name, patch);
  }
  names.groups = groups.finish();
  std::vector<int> result;
  if (names.patches.empty()) return result;
  for (const int label : label_of_face_) {
    result.push_back(patch_of[static_cast<std::size_t>(label)]);
  }
  return result;
}

std::string DifferentNames::add(const std::string& name) {
  int& number = last_number_[name];
  if (++number == 1) return name;
  std::string numbered = fmt::format("{}_{}", name, number);
  while (!last_number_.try_emplace(numbered, 1).second) {
    numbered = fmt::format("{}_{}", name, ++number);
  }
  return numbered;
}

}  // namespace surfmesh
