// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/formats/msh_file.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/file_words.hh"
#include "surfmesh/formats/mesh_elements.hh"
#include "surfmesh/formats/msh_reader.hh"
#include "surfmesh/formats/vertex_metric.hh"
#include "surfmesh/io/file_writer.hh"

namespace surfmesh {
namespace {

/// Gmsh takes lines of 128 bytes for a name with its quotes.
constexpr std::size_t kLongestMshName = 120;

/// What Gmsh calls elements of two, three and four nodes.
constexpr int kLine = 1, kTriangle = 2, kQuad = 3;

/// Nothing escapes a quote, and other readers take a backslash for an escape.
std::string msh_word(std::string_view name) {
  std::string word = shortened(one_line(name), kLongestMshName);
  std::replace(word.begin(), word.end(), '"', '\'');
  std::replace(word.begin(), word.end(), '\\', '/');
  return word;
}

constexpr WordRule kMshWords = {msh_word};

bool is_binary(MshVersion version) {
  return version == MshVersion::Binary41 || version == MshVersion::Binary22;
}

bool is_version_2(MshVersion version) {
  return version == MshVersion::Binary22 || version == MshVersion::Text22;
}

/// Sections of numbers, binary or as text.
class Sections {
 public:
  Sections(OutputFile& file, bool is_binary) : writer_(file), is_binary_(is_binary) {}

  bool is_binary() const { return is_binary_; }

  /// Titles and lines that are text in binary files, too.
  void begin(std::string_view title) { writer_.text(title); }
  void line(std::string_view text) {
    writer_.text("\n");
    writer_.text(text);
  }
  void end(std::string_view title) {
    writer_.text("\n");
    writer_.text(title);
    writer_.text("\n");
  }
  void begin_numbers() {
    if (is_binary_) writer_.text("\n");
  }

  /// A number, in text the first of a line.
  template <class Number>
  void first(Number number) {
    put('\n', number);
  }
  template <class Number>
  void next(Number number) {
    put(' ', number);
  }

  void flush() { writer_.flush(); }

 private:
  template <class Number>
  void put(char before, Number number) {
    if (is_binary_) {
      writer_.bytes(number);
    } else {
      writer_.number(before, number);
    }
  }

  FileWriter writer_;
  bool is_binary_;
};

/// A curve or a surface with its elements.
struct Entity {
  int dimension = 2;
  int tag = 0;
  std::vector<int> physical = {};  ///< tags of its physical groups; the first is its own
  IndexRange segments = {};
  IndexRange triangles = {};
  IndexRange quads = {};

  /// The first group of a patch, else the entity itself.
  int single_physical() const { return physical.size() > 1 ? physical[1] : physical.front(); }
};

/// Box of the points of an entity; that of no points is at the origin.
class Box {
 public:
  void add(const Vec3& point) {
    least_ = is_empty_ ? point : Vec3(least_.cwiseMin(point));
    greatest_ = is_empty_ ? point : Vec3(greatest_.cwiseMax(point));
    is_empty_ = false;
  }

  const Vec3& least() const { return least_; }
  const Vec3& greatest() const { return greatest_; }

 private:
  Vec3 least_ = Vec3::Zero();
  Vec3 greatest_ = Vec3::Zero();
  bool is_empty_ = true;
};

struct PhysicalName {
  int dimension;
  int tag;
  std::string name;
};

/// The entities of a mesh and their names.
class Entities {
 public:
  Entities(const PolyMesh& mesh, const MeshElements& elements, const MeshNames& names) {
    const FileWords words = file_words(names, kMshWords);
    add_curves(elements, words);
    const bool has_patches = find(mesh, keys::face_patch).is_valid();
    add_surfaces(elements, has_patches ? names.patches.size() : 0);
    if (has_patches) add_patch_names(names, words);
  }

  const std::vector<Entity>& all() const { return all_; }
  std::size_t curve_count() const { return curve_count_; }
  const std::vector<PhysicalName>& names() const { return names_; }

  /// The names that are left where an element has one physical group only.
  std::vector<PhysicalName> used_names() const {
    std::vector<PhysicalName> used;
    for (const PhysicalName& name : names_) {
      const bool is_used = std::any_of(all_.begin(), all_.end(), [&](const Entity& entity) {
        return entity.dimension == name.dimension && entity.single_physical() == name.tag;
      });
      if (is_used) used.push_back(name);
    }
    return used;
  }

 private:
  void add_curves(const MeshElements& elements, const FileWords& words) {
    for (const ContourElements& contour : elements.contours) {
      const int tag = contour.contour + 1;
      Entity curve{.dimension = 1, .tag = tag, .physical = {tag}, .segments = contour.segments};
      const auto c = static_cast<std::size_t>(contour.contour);
      if (c < words.contours.size() && !words.contours[c].empty()) {
        names_.push_back({1, curve.tag, words.contours[c]});
      }
      all_.push_back(std::move(curve));
    }
    curve_count_ = all_.size();
  }

  /// All patches up to the greatest, so that they keep their numbers.
  void add_surfaces(const MeshElements& elements, std::size_t count) {
    for (const PatchElements& patch : elements.patches) {
      count = std::max(count, static_cast<std::size_t>(patch.patch + 1));
    }
    for (std::size_t p = 0; p < count; ++p) add_surface(p);
    patch_count_ = count;
    for (const PatchElements& patch : elements.patches) {
      if (patch.patch < 0) add_surface(count);
      const std::size_t slot = patch.patch < 0 ? count : static_cast<std::size_t>(patch.patch);
      all_[curve_count_ + slot].triangles = patch.triangles;
      all_[curve_count_ + slot].quads = patch.quads;
    }
    if (all_.empty()) add_surface(0);
  }

  void add_surface(std::size_t number) {
    const int tag = static_cast<int>(number) + 1;
    all_.push_back({.tag = tag, .physical = {tag}});
  }

  void add_patch_names(const MeshNames& names, const FileWords& words) {
    for (std::size_t p = 0; p < words.patches.size(); ++p) {
      if (words.patches[p].empty()) continue;
      const Entity& surface = all_[curve_count_ + p];
      names_.push_back({2, surface.tag, words.patches[p]});
    }
    for (std::size_t g = 0; g < names.groups.size(); ++g) {
      const int tag = static_cast<int>(patch_count_ + 2 + g);
      names_.push_back({2, tag, words.groups[g]});
      for (const int patch : names.groups[g].patches) {
        if (patch < 0 || static_cast<std::size_t>(patch) >= patch_count_) continue;
        all_[curve_count_ + static_cast<std::size_t>(patch)].physical.push_back(tag);
      }
    }
  }

  std::vector<Entity> all_;  ///< curves, then surfaces
  std::size_t curve_count_ = 0;
  std::size_t patch_count_ = 0;
  std::vector<PhysicalName> names_;
};

/// The nodes in the order of the file: entity by entity, where a node of several belongs to the
/// first, so that curves have theirs.
struct NodeOrder {
  std::vector<std::size_t> node;   ///< by place in the file
  std::vector<std::size_t> place;  ///< by node
  std::vector<std::size_t> first;  ///< by entity, the place of its first node, and the end
};

NodeOrder node_order(const MeshElements& elements, const std::vector<Entity>& entities) {
  const std::size_t count = elements.points.size(), none = entities.size();
  std::vector<std::size_t> owner(count, none);
  const auto claim = [&](int vertex, std::size_t entity) {
    std::size_t& known = owner[static_cast<std::size_t>(vertex)];
    if (known == none) known = entity;
  };
  for (std::size_t e = 0; e < none; ++e) {
    const auto& [dimension, tag, physical, segments, triangles, quads] = entities[e];
    for (std::size_t i = segments.first; i < segments.end; ++i) {
      claim(elements.segments[i].from, e);
      claim(elements.segments[i].to, e);
    }
    for (std::size_t i = triangles.first; i < triangles.end; ++i) {
      for (const int vertex : elements.triangles[i]) claim(vertex, e);
    }
    for (std::size_t i = quads.first; i < quads.end; ++i) {
      for (const int vertex : elements.quads[i]) claim(vertex, e);
    }
  }
  NodeOrder order{std::vector<std::size_t>(count), std::vector<std::size_t>(count),
                  std::vector<std::size_t>(none + 1, 0)};
  // A node without elements belongs to the last entity.
  for (std::size_t& entity : owner) entity = std::min(entity, none - 1);
  for (const std::size_t entity : owner) ++order.first[entity + 1];
  for (std::size_t e = 0; e < none; ++e) order.first[e + 1] += order.first[e];
  std::vector<std::size_t> next = order.first;
  for (std::size_t v = 0; v < count; ++v) {
    order.place[v] = next[owner[v]]++;
    order.node[order.place[v]] = v;
  }
  return order;
}

/// Calls `visit(type, range)` with each kind of elements of an entity.
template <class Visit>
void for_each_kind(const Entity& entity, Visit visit) {
  if (entity.segments.size() > 0) visit(kLine, entity.segments);
  if (entity.triangles.size() > 0) visit(kTriangle, entity.triangles);
  if (entity.quads.size() > 0) visit(kQuad, entity.quads);
}

class MshWriter {
 public:
  MshWriter(const PolyMesh& mesh, const MeshNames& names, MshVersion version, OutputFile& file)
      : mesh_(mesh),
        elements_(mesh_elements(mesh, ".msh")),
        entities_(mesh, elements_, names),
        order_(node_order(elements_, entities_.all())),
        is_version_2_(is_version_2(version)),
        out_(file, is_binary(version)) {}

  void write() {
    write_format();
    write_names();
    if (is_version_2_) {
      write_nodes_2();
      write_elements_2();
    } else {
      write_entities();
      write_nodes_4();
      write_elements_4();
    }
    if (has_vertex_metrics(mesh_)) write_sizes();
    out_.flush();
  }

 private:
  using Count = std::uint64_t;

  void write_format() {
    out_.begin("$MeshFormat");
    out_.line(fmt::format("{} {} 8", is_version_2_ ? "2.2" : "4.1", out_.is_binary() ? 1 : 0));
    if (out_.is_binary()) {
      out_.begin_numbers();
      out_.first(int{1});  // tells the order of bytes
    }
    out_.end("$EndMeshFormat");
  }

  void write_names() {
    const auto names = is_version_2_ ? entities_.used_names() : entities_.names();
    if (names.empty()) return;
    out_.begin("$PhysicalNames");
    out_.line(fmt::format("{}", names.size()));
    for (const PhysicalName& name : names) {
      out_.line(fmt::format("{} {} \"{}\"", name.dimension, name.tag, name.name));
    }
    out_.end("$EndPhysicalNames");
  }

  void write_entities() {
    out_.begin("$Entities");
    out_.begin_numbers();
    const Count curves = entities_.curve_count();
    out_.first(Count{0});
    for (const Count count : {curves, Count{entities_.all().size()} - curves, Count{0}}) {
      out_.next(count);
    }
    for (const Entity& entity : entities_.all()) {
      out_.first(entity.tag);
      const Box box = box_of(entity);
      for (const Vec3& corner : {box.least(), box.greatest()}) {
        for (const double x : corner) out_.next(x);
      }
      out_.next(Count{entity.physical.size()});
      for (const int tag : entity.physical) out_.next(tag);
      out_.next(Count{0});  // entities that bound this one
    }
    out_.end("$EndEntities");
  }

  Box box_of(const Entity& entity) const {
    Box box;
    for_each_kind(entity, [&](int type, const IndexRange& range) {
      for (std::size_t i = range.first; i < range.end; ++i) {
        visit_nodes(type, i, [&](int node) { box.add(elements_.points[index_of(node)]); });
      }
    });
    return box;
  }

  static std::size_t index_of(int node) { return static_cast<std::size_t>(node); }

  /// Call `visit` with the nodes of an element.
  template <class Visit>
  void visit_nodes(int type, std::size_t element, Visit visit) const {
    if (type == kLine) {
      visit(elements_.segments[element].from);
      visit(elements_.segments[element].to);
    } else if (type == kTriangle) {
      for (const int node : elements_.triangles[element]) visit(node);
    } else {
      for (const int node : elements_.quads[element]) visit(node);
    }
  }

  Count tag_of(int node) const { return order_.place[index_of(node)] + 1; }

  void write_nodes_4() {
    const std::vector<Entity>& all = entities_.all();
    Count blocks = 0;
    for (std::size_t e = 0; e < all.size(); ++e) {
      blocks += order_.first[e + 1] > order_.first[e] ? 1 : 0;
    }
    out_.begin("$Nodes");
    begin_blocks(blocks, elements_.points.size());
    for (std::size_t e = 0; e < all.size(); ++e) {
      const std::size_t first = order_.first[e], end = order_.first[e + 1];
      if (first == end) continue;
      out_.first(all[e].dimension);
      out_.next(all[e].tag);
      out_.next(int{0});  // no parameters
      out_.next(Count{end - first});
      for (std::size_t i = first; i < end; ++i) out_.first(Count{i + 1});
      for (std::size_t i = first; i < end; ++i) write_point(elements_.points[order_.node[i]]);
    }
    out_.end("$EndNodes");
  }

  void begin_blocks(Count blocks, Count count) {
    out_.begin_numbers();
    out_.first(blocks);
    for (const Count number : {count, Count{count > 0 ? 1U : 0U}, count}) out_.next(number);
  }

  void write_point(const Vec3& point) {
    out_.first(point.x());
    out_.next(point.y());
    out_.next(point.z());
  }

  std::size_t element_count() const {
    return elements_.segments.size() + elements_.element_count();
  }

  void write_elements_4() {
    Count blocks = 0;
    for (const Entity& entity : entities_.all()) {
      for_each_kind(entity, [&](int, const IndexRange&) { ++blocks; });
    }
    out_.begin("$Elements");
    begin_blocks(blocks, element_count());
    Count tag = 0;
    for (const Entity& entity : entities_.all()) {
      for_each_kind(entity, [&](int type, const IndexRange& range) {
        out_.first(entity.dimension);
        out_.next(entity.tag);
        out_.next(type);
        out_.next(Count{range.size()});
        for (std::size_t i = range.first; i < range.end; ++i) {
          out_.first(++tag);
          visit_nodes(type, i, [&](int node) { out_.next(tag_of(node)); });
        }
      });
    }
    out_.end("$EndElements");
  }

  void write_nodes_2() {
    out_.begin("$Nodes");
    out_.line(fmt::format("{}", elements_.points.size()));
    out_.begin_numbers();
    for (std::size_t i = 0; i < order_.node.size(); ++i) {
      const Vec3& point = elements_.points[order_.node[i]];
      out_.first(static_cast<int>(i + 1));
      for (const double x : point) out_.next(x);
    }
    out_.end("$EndNodes");
  }

  void write_elements_2() {
    out_.begin("$Elements");
    out_.line(fmt::format("{}", element_count()));
    out_.begin_numbers();
    int tag = 0;
    for (const Entity& entity : entities_.all()) {
      for_each_kind(entity, [&](int type, const IndexRange& range) {
        if (out_.is_binary()) {
          out_.first(type);
          out_.next(static_cast<int>(range.size()));
          out_.next(int{2});  // tags of each element
        }
        for (std::size_t i = range.first; i < range.end; ++i) {
          out_.first(++tag);
          if (!out_.is_binary()) {
            out_.next(type);
            out_.next(int{2});
          }
          out_.next(entity.single_physical());
          out_.next(entity.tag);
          visit_nodes(type, i, [&](int node) { out_.next(static_cast<int>(tag_of(node))); });
        }
      });
    }
    out_.end("$EndElements");
  }

  /// Names, times and counts of a view are text in binary files, too.
  void write_sizes() {
    const std::vector<SpaceMetric> metrics = vertex_metrics(mesh_);
    out_.begin("$NodeData");
    for (const char* line : {"1", "\"size\"", "1", "0.0", "3", "0", "1"}) out_.line(line);
    out_.line(fmt::format("{}", metrics.size()));
    out_.begin_numbers();
    for (std::size_t i = 0; i < order_.node.size(); ++i) {
      out_.first(static_cast<int>(i + 1));
      out_.next(size_of(metrics[order_.node[i]]));
    }
    out_.end("$EndNodeData");
  }

  const PolyMesh& mesh_;
  MeshElements elements_;
  Entities entities_;
  NodeOrder order_;
  bool is_version_2_;
  Sections out_;
};

void write_msh(const PolyMesh& mesh, const MeshNames& names, const OutputOptions& options,
               OutputFile& file) {
  MshWriter(mesh, names, options.msh, file).write();
}

std::vector<ChangedName> changed_in_msh(const PolyMesh& mesh, const MeshNames& names) {
  return changed_words(mesh, names, kMshWords);
}

/// Version 2.2 has one physical group an element.
void add_lost_groups(const PolyMesh& mesh, const MeshNames& names, std::vector<std::string>& lost) {
  if (!find(mesh, keys::face_patch).is_valid()) return;
  std::size_t count = names.patches.size();
  for (const Group& group : names.groups) {
    if (!group.patches.empty()) {
      count = std::max(count, static_cast<std::size_t>(group.patches.back()) + 1);
    }
  }
  const auto groups = groups_by_patch(names, count);
  std::size_t names_lost = 0, groups_lost = 0;
  for (std::size_t p = 0; p < count; ++p) {
    const bool has_name = p < names.patches.size() && !names.patches[p].empty();
    names_lost += has_name && !groups[p].empty() ? 1 : 0;
    groups_lost += groups[p].size() > 1 ? 1 : 0;
  }
  if (names_lost > 0) {
    lost.push_back(
        fmt::format("the names of {} patches, which have the name of a group in version "
                    "2.2",
                    names_lost));
  }
  if (groups_lost > 0) {
    lost.push_back(
        fmt::format("the groups but the first of {} patches in version 2.2", groups_lost));
  }
}

std::vector<std::string> lost_in_msh(const PolyMesh& mesh, const MeshNames& names,
                                     const OutputOptions& options) {
  std::vector<std::string> lost = lost_properties(mesh, {.contours = true});
  add_split_faces(mesh, 4, lost);
  if (is_version_2(options.msh)) add_lost_groups(mesh, names, lost);
  add_changed_words(mesh, names, kMshWords, lost);
  return lost;
}

}  // namespace

MeshFormat msh_format() {
  return {.ending = ".msh",
          .parse = parse_msh,
          .write = write_msh,
          .what_is_lost = lost_in_msh,
          .changed_names = changed_in_msh};
}

}  // namespace surfmesh
