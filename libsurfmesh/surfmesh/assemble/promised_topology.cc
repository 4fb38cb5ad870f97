// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/promised_topology.hh"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/validate.hh"
#include "surfmesh/model/touching_loops.hh"

namespace surfmesh {
namespace {

/// The ends of the uses of all contours: 2 × use + 0 at the start of the contour, + 1 at its end.
class UseEnds {
 public:
  explicit UseEnds(const Model& model) {
    for (const Contour& contour : model.contours) {
      first_.push_back(count_);
      count_ += 2 * contour.uses.size();
    }
  }

  std::size_t count() const { return count_; }

  std::size_t operator()(int contour, std::size_t use, bool is_at_end) const {
    return first_[static_cast<std::size_t>(contour)] + 2 * use + (is_at_end ? 1 : 0);
  }

 private:
  std::vector<std::size_t> first_;
  std::size_t count_ = 0;
};

/// Counts what the patches of a model are glued to.
class Gluing {
 public:
  Gluing(const Model& model, const PromisedTopology& promise)
      : model_(model),
        promise_(promise),
        ends_(model),
        fans_(ends_.count()),
        sheets_(model.patches.size()) {
    for (const Patch& patch : model.patches) {
      for (const PatchLoop& loop : patch.loops) join_corners(loop);
    }
    for (std::size_t c = 0; c < model.contours.size(); ++c) {
      if (is_glued(c)) join_uses(static_cast<int>(c));
    }
  }

  /// Patches that are glued, those without a boundary left out.
  std::size_t component_count() {
    std::size_t count = 0;
    for (std::size_t p = 0; p < model_.patches.size(); ++p) {
      if (!model_.patches[p].loops.empty() && sheets_.find(p) == p) ++count;
    }
    return count;
  }

  /// By patch, one number for all that hang together.
  std::vector<std::size_t> components() {
    std::vector<std::size_t> components;
    for (std::size_t p = 0; p < model_.patches.size(); ++p) components.push_back(sheets_.find(p));
    return components;
  }

  /// How many fans of corners each vertex of the model has.
  std::vector<int> fans_of_vertices() {
    std::vector<int> counts(model_.vertices.size(), 0);
    for (std::size_t c = 0; c < model_.contours.size(); ++c) {
      const Contour& contour = model_.contours[c];
      if (contour.is_degenerate) continue;
      for (std::size_t use = 0; use < contour.uses.size(); ++use) {
        for (const bool is_at_end : {false, true}) {
          const std::size_t end = ends_(static_cast<int>(c), use, is_at_end);
          const int vertex = is_at_end ? contour.end : contour.start;
          if (fans_.find(end) == end) ++counts[static_cast<std::size_t>(vertex)];
        }
      }
    }
    return counts;
  }

  /// Of what lies between the vertices: the insides of patches, and those of contours, which have
  /// −1.
  long euler_without_vertices() const {
    long sum = 0;
    for (const Patch& patch : model_.patches) {
      sum += outer_less_inner_loops(model_, patch);
    }
    for (std::size_t c = 0; c < model_.contours.size(); ++c) {
      const Contour& contour = model_.contours[c];
      if (!contour.is_degenerate) sum -= is_glued(c) ? 1 : std::ssize(contour.uses);
    }
    return sum;
  }

 private:
  bool is_glued(std::size_t contour) const {
    return promise_.is_open[contour] == 0 && !model_.contours[contour].is_degenerate &&
           !model_.contours[contour].uses.empty();
  }

  /// The end of a use at which a loop enters it (or leaves it).
  std::size_t end_of(const LoopEntry& entry, bool is_leaving) const {
    return ends_(entry.contour, static_cast<std::size_t>(entry.use),
                 is_leaving == model_.use(entry).is_forward);
  }

  /// Sides that follow each other, poles between them left out, have a corner of the patch in
  /// common.
  void join_corners(const PatchLoop& loop) {
    PatchLoop sides;
    std::copy_if(loop.begin(), loop.end(), std::back_inserter(sides),
                 [this](const LoopEntry& entry) { return !model_.contour(entry).is_degenerate; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const LoopEntry& next = sides[(i + 1) % sides.size()];
      fans_.unite(end_of(sides[i], true), end_of(next, false));
    }
  }

  void join_uses(int contour) {
    const std::vector<ContourUse>& uses = model_.contour(contour).uses;
    for (const bool is_at_end : {false, true}) {
      fans_.unite(ends_(contour, 0, is_at_end), ends_(contour, 1, is_at_end));
    }
    sheets_.unite(static_cast<std::size_t>(uses[0].patch), static_cast<std::size_t>(uses[1].patch));
  }

  const Model& model_;
  const PromisedTopology& promise_;
  UseEnds ends_;
  DisjointSets fans_, sheets_;
};

/// Finds vertices with equal coordinates.
class PositionTable {
 public:
  explicit PositionTable(const PolyMesh& mesh)
      : mesh_(mesh), slots_(std::bit_ceil(2 * mesh.n_vertices() + 1)) {}

  /// An earlier vertex in the same place and component; invalid if there is none.
  VertexHandle add(VertexHandle vh, std::size_t component) {
    const PolyMesh::Point& point = mesh_.point(vh);
    for (std::size_t slot = hash(point);; ++slot) {
      Slot& there = slots_[slot & (slots_.size() - 1)];
      if (there.vertex < 0) {
        there = {vh.idx(), component};
        return VertexHandle();
      }
      const VertexHandle other(there.vertex);
      if (there.component == component && mesh_.point(other) == point) return other;
    }
  }

 private:
  static std::size_t hash(const PolyMesh::Point& point) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    std::uint64_t mixed = 0;
    for (unsigned int axis = 0; axis < 3; ++axis) {
      // + 0 makes one zero of both.
      mixed = (mixed ^ std::bit_cast<std::uint64_t>(point[axis] + 0.0)) * odd;
      mixed ^= mixed >> 32;
    }
    return mixed;
  }

  struct Slot {
    int vertex = -1;
    std::size_t component = 0;
  };

  const PolyMesh& mesh_;
  std::vector<Slot> slots_;
};

/// Compares a mesh with the promise of its model.
class Comparison {
 public:
  Comparison(const PolyMesh& mesh, const Model& model)
      : mesh_(mesh),
        model_(model),
        promise_(promised_topology(model)),
        patch_of_(require(mesh, keys::face_patch)),
        contour_of_(find(mesh, keys::edge_contour)),
        is_at_opening_(mesh.n_vertices(), 0),
        is_patch_open_(model.patches.size(), 0) {
    for (std::size_t c = 0; c < model.contours.size(); ++c) {
      if (promise_.is_open[c] == 0) continue;
      for (const ContourUse& use : model.contours[c].uses) {
        is_patch_open_[static_cast<std::size_t>(use.patch)] = 1;
      }
    }
  }

  std::vector<MeshFault> run() {
    for (const EdgeHandle eh : mesh_.edges()) look_at(eh);
    look_at_vertices();
    const MeshTopology topology = measure_topology(mesh_);
    compare(components_, static_cast<long>(topology.components),
            static_cast<long>(promise_.components));
    compare(euler_, topology.euler, promise_.euler);
    std::vector<MeshFault> faults;
    for (MeshFault* fault : {&open_, &closed_, &duplicate_, &components_, &euler_}) {
      if (fault->count > 0) faults.push_back(std::move(*fault));
    }
    return faults;
  }

 private:
  /// Halfedge 0 or 1 of the edge, that of a face.
  HalfedgeHandle inner_halfedge(EdgeHandle eh) const {
    const HalfedgeHandle heh = mesh_.halfedge_handle(eh, 0);
    return mesh_.is_boundary(heh) ? mesh_.halfedge_handle(eh, 1) : heh;
  }

  int patch_at(HalfedgeHandle heh) const {
    return mesh_.property(patch_of_, mesh_.face_handle(heh));
  }

  /// Whether the model lets the edge be open. Of a mesh that does not know its contours it is only
  /// known whether the patch is open anywhere.
  bool may_be_open(EdgeHandle eh) const {
    if (!contour_of_.is_valid()) {
      return is_patch_open_[static_cast<std::size_t>(patch_at(inner_halfedge(eh)))] != 0;
    }
    const int contour = mesh_.property(contour_of_, eh);
    return contour >= 0 && promise_.is_open[static_cast<std::size_t>(contour)] != 0;
  }

  void look_at(EdgeHandle eh) {
    const bool is_open = mesh_.is_boundary(eh), may_be = may_be_open(eh);
    if (is_open && may_be) {
      const HalfedgeHandle heh = inner_halfedge(eh);
      for (const VertexHandle vh : {mesh_.from_vertex_handle(heh), mesh_.to_vertex_handle(heh)}) {
        is_at_opening_[index(vh)] = 1;
      }
    } else if (is_open) {
      open_.add([&] { return location_of(eh); });
    } else if (may_be && contour_of_.is_valid()) {
      closed_.add([&] { return location_of(eh); });
    }
  }

  std::string location_of(EdgeHandle eh) const {
    const HalfedgeHandle heh = inner_halfedge(eh);
    const Vec3 middle = 0.5 * (to_eigen(mesh_.point(mesh_.from_vertex_handle(heh))) +
                               to_eigen(mesh_.point(mesh_.to_vertex_handle(heh))));
    return location_text_on(patch_at(heh), middle);
  }

  void look_at_vertices() {
    PositionTable table(mesh_);
    for (const VertexHandle vh : mesh_.vertices()) {
      const VertexHandle earlier = table.add(vh, component_of(vh));
      if (!earlier.is_valid() || (is_at_opening(vh) && is_at_opening(earlier))) continue;
      if (!is_split(to_eigen(mesh_.point(vh)))) duplicate_.add([&] { return location_of(vh); });
    }
  }

  /// Solids that touch have vertices in the same places.
  std::size_t component_of(VertexHandle vh) const {
    const HalfedgeHandle heh = mesh_.halfedge_handle(vh);
    if (!heh.is_valid()) return 0;
    const EdgeHandle eh = mesh_.edge_handle(heh);
    return promise_.component_of[static_cast<std::size_t>(patch_at(inner_halfedge(eh)))];
  }

  bool is_at_opening(VertexHandle vh) const { return is_at_opening_[index(vh)] != 0; }

  /// True at a vertex of the model at which patches touch without a common contour.
  bool is_split(const Vec3& point) const {
    for (std::size_t v = 0; v < model_.vertices.size(); ++v) {
      if (promise_.is_split[v] != 0 && model_.vertices[v].position == point) return true;
    }
    return false;
  }

  std::string location_of(VertexHandle vh) const {
    const EdgeHandle eh = mesh_.edge_handle(mesh_.halfedge_handle(vh));
    return location_text_on(patch_at(inner_halfedge(eh)), to_eigen(mesh_.point(vh)));
  }

  std::string location_text_on(int patch, const Vec3& point) const {
    return fmt::format("patch {} at {}", model_.patch(patch).name, point_text(point));
  }

  static void compare(MeshFault& fault, long found, long promised) {
    if (found == promised) return;
    fault.add([&] { return fmt::format("{} instead of {}", found, promised); });
  }

  const PolyMesh& mesh_;
  const Model& model_;
  PromisedTopology promise_;
  decltype(keys::face_patch)::Handle patch_of_;
  decltype(keys::edge_contour)::Handle contour_of_;
  std::vector<char> is_at_opening_;  ///< by vertex: 1 at an open edge that the model promises
  std::vector<char> is_patch_open_;
  MeshFault open_{"open_edge", 0, {}};
  MeshFault closed_{"closed_edge", 0, {}};
  MeshFault duplicate_{"duplicate_vertex", 0, {}};
  MeshFault components_{"components", 0, {}};
  MeshFault euler_{"euler", 0, {}};
};

}  // namespace

PromisedTopology promised_topology(const Model& model) {
  PromisedTopology promise;
  promise.is_open.assign(model.contours.size(), 0);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    const Contour& contour = model.contours[c];
    if (!contour.is_degenerate && contour.uses.size() != 2) promise.is_open[c] = 1;
  }
  for (const int c : orient_patches(model).cut_contours) {
    promise.is_open[static_cast<std::size_t>(c)] = 1;
  }
  Gluing gluing(model, promise);
  promise.components = gluing.component_count();
  promise.component_of = gluing.components();
  promise.euler = gluing.euler_without_vertices();
  for (const int fans : gluing.fans_of_vertices()) {
    promise.is_split.push_back(fans > 1);
    promise.euler += fans;
  }
  return promise;
}

std::vector<MeshFault> compare_with_promise(const PolyMesh& mesh, const Model& model) {
  return Comparison(mesh, model).run();
}

}  // namespace surfmesh
