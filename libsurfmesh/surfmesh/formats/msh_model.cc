// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/msh_model.hh"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace surfmesh::msh {
namespace {

/// By type, from 1: dimension, corners, nodes. Gmsh's manual, "MSH file format".
constexpr std::array<Shape, 31> kShapes = {
    {{1, 2, 2},  {2, 3, 3},  {2, 4, 4},  {3, 4, 4},  {3, 8, 8},  {3, 6, 6},  {3, 5, 5},  {1, 2, 3},
     {2, 3, 6},  {2, 4, 9},  {3, 4, 10}, {3, 8, 27}, {3, 6, 18}, {3, 5, 14}, {0, 1, 1},  {2, 4, 8},
     {3, 8, 20}, {3, 6, 15}, {3, 5, 13}, {2, 3, 9},  {2, 3, 10}, {2, 3, 12}, {2, 3, 15}, {2, 3, 15},
     {2, 3, 21}, {1, 2, 4},  {1, 2, 5},  {1, 2, 6},  {3, 4, 20}, {3, 4, 35}, {3, 4, 56}}};

/// Greatest number up to which nodes are looked up in an array, as a multiple of their number.
constexpr std::int64_t kDenseFactor = 4;

/// Numbers of groups are below 0 where Gmsh turned the entity.
std::int64_t magnitude(std::int64_t number) {
  return number < 0 ? -std::max(number, -std::numeric_limits<std::int64_t>::max()) : number;
}

/// No patch has this number in a file.
constexpr std::int64_t kNoPart = std::numeric_limits<std::int64_t>::min();

}  // namespace

std::optional<Shape> shape_of(std::int64_t type) {
  if (type < 1 || type > static_cast<std::int64_t>(kShapes.size())) return std::nullopt;
  return kShapes[static_cast<std::size_t>(type - 1)];
}

bool NodeNumbers::finish() {
  const auto count = static_cast<std::int64_t>(numbers_.size());
  const auto [least, greatest] = std::minmax_element(numbers_.begin(), numbers_.end());
  bool are_different = true;
  const bool is_dense = count > 0 && *least >= 0 && *greatest / kDenseFactor <= count;
  if (is_dense) dense_.assign(static_cast<std::size_t>(*greatest) + 1, -1);
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    int& index = is_dense ? dense_[static_cast<std::size_t>(numbers_[i])]
                          : sparse_.emplace(numbers_[i], -1).first->second;
    if (index < 0) {
      index = static_cast<int>(i);
    } else {
      are_different = false;
    }
  }
  return are_different;
}

int NodeNumbers::index(std::int64_t number) const {
  if (!dense_.empty()) {
    const bool is_inside = number >= 0 && number < static_cast<std::int64_t>(dense_.size());
    return is_inside ? dense_[static_cast<std::size_t>(number)] : -1;
  }
  const auto found = sparse_.find(number);
  return found == sparse_.end() ? -1 : found->second;
}

void Model::add_name(std::int64_t dimension, std::int64_t physical, std::string name) {
  names_[{dimension, physical}] = std::move(name);
}

void Model::add_entity(int dimension, std::int64_t tag, std::span<const std::int64_t> physicals) {
  std::set<std::int64_t>& groups = groups_[{dimension, tag}];
  for (const std::int64_t physical : physicals) groups.insert(magnitude(physical));
}

void Model::reserve_nodes(std::size_t count) {
  numbers_.reserve(count);
  builder_.grid.points.reserve(count);
}

void Model::add_node(std::int64_t number, const Vec3& point) {
  numbers_.add(number);
  builder_.grid.points.push_back(point);
}

void Model::add_element(std::int64_t number, const Shape& shape, std::span<const int> nodes,
                        std::int64_t entity, std::int64_t physical) {
  elements_.push_back({number, entity, magnitude(physical), nodes_.size(), shape});
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
}

std::span<const int> Model::nodes_of(std::int64_t number) {
  if (!is_numbered_) {
    is_numbered_ = true;
    for (const Element& element : elements_) element_numbers_.add(element.number);
    // Of two with the same number the first is found: its values are those of the nodes.
    element_numbers_.finish();
  }
  const int index = element_numbers_.index(number);
  if (index < 0) return {};
  const Element& element = elements_[static_cast<std::size_t>(index)];
  return {nodes_.data() + element.first, static_cast<std::size_t>(element.shape.nodes)};
}

Model::Part Model::part_of(const Element& element) const {
  Part part = {element.entity, {}};
  const auto found = groups_.find({element.shape.dimension, element.entity});
  if (found != groups_.end()) part.second = found->second;
  if (element.physical != 0) part.second.insert(element.physical);
  return part;
}

/// Faces of entities in several groups that are there once for each of these: the groups of the
/// first, and the others in `again`.
std::map<const Model::Element*, std::set<std::int64_t>> Model::join_repeated(
    std::set<const Element*>& again) {
  std::map<std::int64_t, std::set<std::int64_t>> physicals_of;
  for (const Element& element : elements_) {
    if (element.shape.dimension == 2) physicals_of[element.entity].insert(element.physical);
  }
  std::map<std::pair<std::int64_t, std::vector<int>>, const Element*> first_of;
  std::map<const Element*, std::set<std::int64_t>> groups;
  for (const Element& element : elements_) {
    if (element.shape.dimension != 2 || physicals_of[element.entity].size() < 2) continue;
    const std::span<const int> face = corners(element);
    const auto [entry, is_new] = first_of.emplace(
        std::pair(element.entity, std::vector(face.begin(), face.end())), &element);
    if (!is_new) again.insert(&element);
    if (element.physical != 0) groups[entry->second].insert(element.physical);
  }
  return groups;
}

void Model::build_faces() {
  std::set<const Element*> again;
  const auto groups = join_repeated(again);
  std::map<Part, std::int64_t> number_of;
  std::vector<const Element*> faces;
  std::vector<std::map<Part, std::int64_t>::iterator> part_of_face;
  for (const Element& element : elements_) {
    if (element.shape.dimension != 2 || again.contains(&element)) continue;
    const bool is_as_before = !faces.empty() && groups.empty() &&
                              faces.back()->entity == element.entity &&
                              faces.back()->physical == element.physical;
    faces.push_back(&element);
    if (is_as_before) {
      part_of_face.push_back(part_of_face.back());
      continue;
    }
    Part part = part_of(element);
    const auto known = groups.find(&element);
    if (known != groups.end()) part.second.insert(known->second.begin(), known->second.end());
    part_of_face.push_back(number_of.emplace(std::move(part), 0).first);
  }
  // The entity tells which patch it is, unless it is several.
  std::set<std::int64_t> entities;
  for (const auto& [part, number] : number_of) entities.insert(part.first);
  const bool is_by_entity = entities.size() == number_of.size();
  std::map<std::int64_t, Part> parts;
  for (auto& [part, number] : number_of) {
    number = is_by_entity ? part.first : static_cast<std::int64_t>(parts.size());
    parts.emplace(number, part);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    builder_.add_face(corners(*faces[f]), part_of_face[f]->second);
    if (faces[f]->shape.nodes > faces[f]->shape.corners) builder_.leave_out_middles();
  }
  const bool is_one_unnamed = parts.size() == 1 && parts.begin()->second == Part();
  name_groups(builder_.number_patches(is_one_unnamed ? parts.begin()->first : kNoPart), parts);
}

/// Physical groups are groups of the patches, whose numbers are those of parts. One that has the
/// number of its only surface is the patch itself, as write_mesh makes them.
void Model::name_groups(std::span<const std::int64_t> numbers,
                        const std::map<std::int64_t, Part>& parts) {
  std::map<std::int64_t, std::vector<int>> patches_of;
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    const auto part = parts.find(numbers[p]);
    if (part == parts.end()) continue;
    for (const std::int64_t physical : part->second.second) {
      patches_of[physical].push_back(static_cast<int>(p));
    }
  }
  MeshNames& names = builder_.grid.names;
  const auto is_patch = [&](std::int64_t physical, const std::vector<int>& patches) {
    const auto number = numbers[static_cast<std::size_t>(patches.front())];
    return patches.size() == 1 && parts.at(number).first == physical;
  };
  for (auto& [physical, patches] : patches_of) {
    if (!is_patch(physical, patches)) {
      names.groups.push_back({name_of_group(physical), std::move(patches)});
    } else if (const auto known = names_.find({2, physical}); known != names_.end()) {
      names.patches.resize(numbers.size());
      names.patches[static_cast<std::size_t>(patches.front())] = known->second;
    }
  }
  put_in_order(names.groups);
}

std::string Model::name_of_group(std::int64_t physical) const {
  const auto found = names_.find({2, physical});
  return found != names_.end() ? found->second : fmt::format("physical {}", physical);
}

/// Lines of one physical group are one contour, as are those of one entity without a group.
void Model::build_sides() {
  std::vector<std::pair<std::int64_t, std::int64_t>> parts;
  std::vector<const Element*> sides;
  for (const Element& element : elements_) {
    if (element.shape.dimension != 1) continue;
    const Part part = part_of(element);
    const std::int64_t physical = part.second.empty() ? 0 : *part.second.begin();
    sides.push_back(&element);
    parts.emplace_back(physical, physical == 0 ? element.entity : 0);
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> different = parts;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  // The group tells which contour it is, if all lines have one.
  const bool is_by_group = !different.empty() && different.front().first > 0;
  std::map<std::int64_t, std::int64_t> physical_of;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto found = std::lower_bound(different.begin(), different.end(), parts[i]);
    const std::int64_t number = is_by_group ? parts[i].first : found - different.begin();
    physical_of[number] = parts[i].first;
    const std::span<const int> ends = corners(*sides[i]);
    builder_.add_side(ends[0], ends[1], number);
  }
  for (const std::int64_t number : builder_.number_contours()) {
    const auto physical = physical_of.find(number);
    const auto known =
        physical == physical_of.end() ? names_.end() : names_.find({1, physical->second});
    builder_.grid.names.contours.push_back(known == names_.end() ? "" : known->second);
  }
}

void Model::build_others() {
  for (const Element& element : elements_) {
    if (element.shape.dimension == 0) builder_.leave_out("points that are elements");
    if (element.shape.dimension != 3) continue;
    if (element.shape.corners == 4) {
      const std::span<const int> c = corners(element);
      builder_.add_tetrahedron({c[0], c[1], c[2], c[3]});
    } else {
      builder_.leave_out("solid elements that are no tetrahedra");
    }
  }
}

GridFile Model::finish(const std::map<std::string, std::size_t>& left_out) {
  build_faces();
  build_sides();
  build_others();
  for (const auto& [what, count] : left_out) builder_.leave_out(what, count);
  return builder_.finish();
}

}  // namespace surfmesh::msh
