// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/promised_topology.hh"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <utility>

#include "surfmesh/assemble/orientation.hh"
#include "surfmesh/core/buckets.hh"
#include "surfmesh/core/disjoint_sets.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/core/range_sums.hh"
#include "surfmesh/geometry/project_to_curve.hh"
#include "surfmesh/model/joined_uses.hh"
#include "surfmesh/model/touching_loops.hh"

namespace surfmesh {
namespace {

/// How far a vertex on a contour may be from it, as a share of the diagonal: as far as a contour
/// may be from a patch.
constexpr double kOnContour = 1e-6;

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
        joined_(joined_uses(model)),
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
      if (!contour.is_degenerate) {
        sum -= is_glued(c) ? std::ssize(joined_[c]) : std::ssize(contour.uses);
      }
    }
    return sum;
  }

 private:
  bool is_glued(std::size_t contour) const {
    return promise_.is_open[contour] == 0 && !joined_[contour].empty();
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
    for (const UsePair& pair : joined_[static_cast<std::size_t>(contour)]) {
      const auto a = static_cast<std::size_t>(pair[0]), b = static_cast<std::size_t>(pair[1]);
      for (const bool is_at_end : {false, true}) {
        fans_.unite(ends_(contour, a, is_at_end), ends_(contour, b, is_at_end));
      }
      sheets_.unite(static_cast<std::size_t>(uses[a].patch),
                    static_cast<std::size_t>(uses[b].patch));
    }
  }

  const Model& model_;
  const PromisedTopology& promise_;
  std::vector<std::vector<UsePair>> joined_;  ///< by contour
  UseEnds ends_;
  DisjointSets fans_, sheets_;
};

/// A vertex and an earlier one in the same place.
struct SamePlace {
  VertexHandle vertex;
  VertexHandle earlier;
};

std::uint64_t key_of(const PolyMesh::Point& point) {
  std::uint64_t key = 0;
  for (unsigned int axis = 0; axis < 3; ++axis) {
    // + 0 makes one zero of both.
    key = Buckets::hash(key ^ std::bit_cast<std::uint64_t>(point[axis] + 0.0));
  }
  return key;
}

/// Finds vertices with equal coordinates, among those whose keys are in one bucket.
class PositionTable {
 public:
  PositionTable(const PolyMesh& mesh, const std::vector<std::uint64_t>& keys, std::size_t count)
      : mesh_(mesh), keys_(keys), slots_(std::bit_ceil(2 * count + 1)) {}

  /// An earlier vertex in the same place for which `is_like` holds; invalid if there is none.
  template <class IsLike>
  VertexHandle add(VertexHandle vh, IsLike is_like) {
    const std::uint64_t key = keys_[index(vh)];
    for (std::size_t slot = key;; ++slot) {
      Slot& there = slots_[slot & (slots_.size() - 1)];
      if (there.vertex < 0) {
        there = {vh.idx(), static_cast<std::uint32_t>(key >> 32)};
        return VertexHandle();
      }
      const VertexHandle other(there.vertex);
      if (there.high_bits == key >> 32 && mesh_.point(other) == mesh_.point(vh) && is_like(other)) {
        return other;
      }
    }
  }

 private:
  struct Slot {
    int vertex = -1;
    std::uint32_t high_bits = 0;  ///< of its key: most others are seen to differ by them
  };

  const PolyMesh& mesh_;
  const std::vector<std::uint64_t>& keys_;
  std::vector<Slot> slots_;
};

/// Vertices for each of which there is an earlier one in the same place, by their numbers.
/// `are_alike` says which two may count as one.
template <class AreAlike>
std::vector<SamePlace> find_same_places(const PolyMesh& mesh, AreAlike are_alike) {
  std::vector<std::uint64_t> keys(mesh.n_vertices());
  share_ranges(keys.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      keys[v] = key_of(mesh.point(VertexHandle(static_cast<int>(v))));
    }
  });
  const Buckets buckets(keys);
  std::vector<std::vector<SamePlace>> found(Buckets::kCount);
  share_indices(found.size(), [&](std::size_t bucket) {
    PositionTable table(mesh, keys, buckets[bucket].size());
    for (const std::uint32_t v : buckets[bucket]) {
      const VertexHandle vh(static_cast<int>(v));
      const VertexHandle earlier =
          table.add(vh, [&](VertexHandle other) { return are_alike(vh, other); });
      if (earlier.is_valid()) found[bucket].push_back({vh, earlier});
    }
  });
  std::vector<SamePlace> all;
  for (const auto& places : found) all.insert(all.end(), places.begin(), places.end());
  std::sort(all.begin(), all.end(),
            [](const SamePlace& a, const SamePlace& b) { return a.vertex < b.vertex; });
  return all;
}

/// Add the faults of later elements, of the same kind.
void append(const MeshFault& more, MeshFault& fault) {
  fault.count += more.count;
  for (const std::string& place : more.places) {
    if (fault.places.size() < MeshFault::kMostPlaces) fault.places.push_back(place);
  }
}

/// What a range of the edges shows.
struct EdgeFindings {
  MeshFault open{"open_edge", 0, {}};
  MeshFault closed{"closed_edge", 0, {}};
  std::vector<VertexHandle> at_openings;  ///< that may have others in the same places

  EdgeFindings& operator+=(const EdgeFindings& other) {
    append(other.open, open);
    append(other.closed, closed);
    at_openings.insert(at_openings.end(), other.at_openings.begin(), other.at_openings.end());
    return *this;
  }
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
        is_patch_open_(model.patches.size(), 0),
        is_patch_touched_(model.patches.size(), 0) {
    for (std::size_t c = 0; c < model.contours.size(); ++c) {
      const bool is_shared = model.contours[c].uses.size() > 2;
      has_touched_ |= is_shared;
      for (const ContourUse& use : model.contours[c].uses) {
        if (is_shared) is_patch_touched_[static_cast<std::size_t>(use.patch)] = 1;
      }
      if (promise_.is_open[c] == 0) continue;
      for (const ContourUse& use : model.contours[c].uses) {
        is_patch_open_[static_cast<std::size_t>(use.patch)] = 1;
      }
    }
  }

  std::vector<MeshFault> run(const MeshTopology& topology) {
    EdgeFindings edges = look_at_edges();
    for (const VertexHandle vh : edges.at_openings) is_at_opening_[index(vh)] = 1;
    look_at_vertices();
    compare(components_, static_cast<long>(topology.components),
            static_cast<long>(promise_.components));
    compare(euler_, topology.euler, promise_.euler);
    std::vector<MeshFault> faults;
    for (MeshFault* fault : {&edges.open, &edges.closed, &duplicate_, &components_, &euler_}) {
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
  /// known whether the patch is open anywhere. A face that lies on several patches may have such an
  /// edge, too, though most of it is on another patch.
  bool may_be_open(EdgeHandle eh) const {
    if (!contour_of_.is_valid()) {
      const auto patch = static_cast<std::size_t>(patch_at(inner_halfedge(eh)));
      return is_patch_open_[patch] != 0 || (mesh_.is_boundary(eh) && ends_at_opening(eh));
    }
    const int contour = mesh_.property(contour_of_, eh);
    return contour >= 0 && promise_.is_open[static_cast<std::size_t>(contour)] != 0;
  }

  /// True where both ends lie on one open contour of the model.
  bool ends_at_opening(EdgeHandle eh) const {
    const HalfedgeHandle heh = inner_halfedge(eh);
    const Vec3 from = to_eigen(mesh_.point(mesh_.from_vertex_handle(heh)));
    const Vec3 to = to_eigen(mesh_.point(mesh_.to_vertex_handle(heh)));
    for (std::size_t c = 0; c < model_.contours.size(); ++c) {
      if (promise_.is_open[c] == 0) continue;
      const Contour& contour = model_.contours[c];
      if (is_on(contour, from) && is_on(contour, to)) return true;
    }
    return false;
  }

  /// True within the distance that contours may be from each other.
  bool is_on(const Contour& contour, const Vec3& point) const {
    const ContourUse& use = contour.uses.front();
    const double tolerance = std::max(contour.tolerance, kOnContour * model_.diagonal);
    for (int part = 0; part < contour.part_count(); ++part) {
      const double guess = (part + 0.5) / contour.part_count();
      const double t = project_to_curve(model_.surface(use), *use.curve, point, guess);
      if ((model_.point(use, t) - point).norm() <= tolerance) return true;
    }
    return false;
  }

  EdgeFindings look_at_edges() const {
    return sum_of_ranges(mesh_.n_edges(), [&](std::size_t first, std::size_t end) {
      EdgeFindings findings;
      for (std::size_t e = first; e < end; ++e) look_at(EdgeHandle(static_cast<int>(e)), findings);
      return findings;
    });
  }

  void look_at(EdgeHandle eh, EdgeFindings& findings) const {
    const bool is_open = mesh_.is_boundary(eh), may_be = may_be_open(eh);
    if ((is_open && may_be) || is_touched(eh)) {
      const HalfedgeHandle heh = inner_halfedge(eh);
      findings.at_openings.push_back(mesh_.from_vertex_handle(heh));
      findings.at_openings.push_back(mesh_.to_vertex_handle(heh));
    }
    if (is_open && !may_be) {
      findings.open.add([&] { return location_of(eh); });
    } else if (!is_open && may_be && contour_of_.is_valid()) {
      findings.closed.add([&] { return location_of(eh); });
    }
  }

  /// True on a contour along which a solid touches itself, or on a patch there if contours are not
  /// known.
  bool is_touched(EdgeHandle eh) const {
    if (!has_touched_) return false;
    if (!contour_of_.is_valid()) {
      return is_patch_touched_[static_cast<std::size_t>(patch_at(inner_halfedge(eh)))] != 0;
    }
    const int contour = mesh_.property(contour_of_, eh);
    return contour >= 0 && model_.contour(contour).uses.size() > 2;
  }

  std::string location_of(EdgeHandle eh) const {
    const HalfedgeHandle heh = inner_halfedge(eh);
    const Vec3 middle = 0.5 * (to_eigen(mesh_.point(mesh_.from_vertex_handle(heh))) +
                               to_eigen(mesh_.point(mesh_.to_vertex_handle(heh))));
    return location_text_on(patch_at(heh), middle);
  }

  void look_at_vertices() {
    const auto are_of_one_component = [&](VertexHandle a, VertexHandle b) {
      return component_of(a) == component_of(b);
    };
    for (const SamePlace& place : find_same_places(mesh_, are_of_one_component)) {
      const VertexHandle vh = place.vertex;
      if (is_at_opening(vh) && is_at_opening(place.earlier)) continue;
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
  std::vector<char> is_patch_touched_;  ///< 1 at a contour of three and more uses
  bool has_touched_ = false;
  MeshFault duplicate_{"duplicate_vertex", 0, {}};
  MeshFault components_{"components", 0, {}};
  MeshFault euler_{"euler", 0, {}};
};

}  // namespace

PromisedTopology promised_topology(const Model& model) {
  PromisedTopology promise;
  promise.is_open.assign(model.contours.size(), 0);
  const auto joined = joined_uses(model);
  for (std::size_t c = 0; c < model.contours.size(); ++c) {
    if (!model.contours[c].is_degenerate && joined[c].empty()) promise.is_open[c] = 1;
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
  return compare_with_promise(mesh, measure_topology(mesh), model);
}

std::vector<MeshFault> compare_with_promise(const PolyMesh& mesh, const MeshTopology& topology,
                                            const Model& model) {
  return Comparison(mesh, model).run(topology);
}

}  // namespace surfmesh
