// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/validate.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "surfmesh/core/disjoint_sets.hh"

namespace surfmesh {
namespace {

/// Of a mesh that is broken everywhere more would tell nothing.
constexpr std::size_t kMostFaultsOfAKind = 100;

/// Asks the mesh by index and believes nothing: every answer is checked before it is used as one.
class FaultFinder {
 public:
  explicit FaultFinder(const PolyMesh& mesh) : mesh_(mesh) {}

  std::vector<std::string> run() {
    // Each question relies on those before it.
    const std::array questions = {&FaultFinder::check_ranges, &FaultFinder::check_links,
                                  &FaultFinder::check_faces,  &FaultFinder::check_boundaries,
                                  &FaultFinder::check_fans,   &FaultFinder::check_edges};
    for (const auto question : questions) {
      count_ = 0;
      (this->*question)();
      if (question == &FaultFinder::check_ranges && !faults_.empty()) break;
    }
    return std::move(faults_);
  }

 private:
  template <class... Arguments>
  void report(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    if (++count_ > kMostFaultsOfAKind) return;
    faults_.push_back(fmt::format(text, std::forward<Arguments>(arguments)...));
  }

  bool has(VertexHandle vh) const { return vh.is_valid() && index(vh) < mesh_.n_vertices(); }
  bool has(HalfedgeHandle heh) const { return heh.is_valid() && index(heh) < mesh_.n_halfedges(); }
  bool has(FaceHandle fh) const { return fh.is_valid() && index(fh) < mesh_.n_faces(); }

  template <class Visitor>
  void for_each_halfedge(Visitor visit) const {
    const int count = static_cast<int>(mesh_.n_halfedges());
    for (int i = 0; i < count; ++i) visit(HalfedgeHandle(i));
  }

  void check_ranges() {
    for_each_halfedge([this](HalfedgeHandle heh) {
      const FaceHandle fh = mesh_.face_handle(heh);
      if (!has(mesh_.to_vertex_handle(heh)) || !has(mesh_.next_halfedge_handle(heh)) ||
          !has(mesh_.prev_halfedge_handle(heh)) || (fh.is_valid() && !has(fh))) {
        report("halfedge {} refers to an element that does not exist", heh.idx());
      }
    });
    for (int i = 0; i < static_cast<int>(mesh_.n_vertices()); ++i) {
      const HalfedgeHandle heh = mesh_.halfedge_handle(VertexHandle(i));
      if (heh.is_valid() && !has(heh)) report("vertex {} has a halfedge that does not exist", i);
    }
    for (int i = 0; i < static_cast<int>(mesh_.n_faces()); ++i) {
      if (!has(mesh_.halfedge_handle(FaceHandle(i)))) report("face {} has no halfedge", i);
    }
  }

  void check_links() {
    for_each_halfedge([this](HalfedgeHandle heh) {
      const HalfedgeHandle next = mesh_.next_halfedge_handle(heh);
      const HalfedgeHandle previous = mesh_.prev_halfedge_handle(heh);
      if (mesh_.prev_halfedge_handle(next) != heh || mesh_.next_halfedge_handle(previous) != heh) {
        report("halfedge {}: next and previous do not undo each other", heh.idx());
      }
      if (mesh_.from_vertex_handle(next) != mesh_.to_vertex_handle(heh)) {
        report("halfedge {}: the next one does not start where it ends", heh.idx());
      }
      if (mesh_.face_handle(next) != mesh_.face_handle(heh)) {
        report("halfedge {}: the next one belongs to another face", heh.idx());
      }
    });
  }

  /// Length of the cycle of `next` from `start`, or one more than `most` if it does not close.
  std::size_t cycle_length(HalfedgeHandle start, std::size_t most) const {
    std::size_t length = 0;
    HalfedgeHandle heh = start;
    do {
      heh = mesh_.next_halfedge_handle(heh);
    } while (++length <= most && heh != start);
    return length;
  }

  void check_faces() {
    std::vector<std::size_t> owned(mesh_.n_faces(), 0);
    for_each_halfedge([&](HalfedgeHandle heh) {
      if (!mesh_.is_boundary(heh)) ++owned[index(mesh_.face_handle(heh))];
    });
    for (int i = 0; i < static_cast<int>(mesh_.n_faces()); ++i) {
      const std::size_t count = owned[static_cast<std::size_t>(i)];
      const HalfedgeHandle start = mesh_.halfedge_handle(FaceHandle(i));
      if (mesh_.face_handle(start) != FaceHandle(i)) {
        report("face {} has a halfedge of another face", i);
      } else if (cycle_length(start, count) != count) {
        report("face {}: its halfedges are not one cycle", i);
      } else if (count < 3) {
        report("face {} has {} edges", i, count);
      }
    }
  }

  void check_boundaries() {
    std::vector<bool> reported(mesh_.n_vertices(), false);
    for_each_halfedge([&](HalfedgeHandle heh) {
      const VertexHandle vh = mesh_.from_vertex_handle(heh);
      const HalfedgeHandle first = mesh_.halfedge_handle(vh);
      if (reported[index(vh)]) return;
      if (!first.is_valid()) {
        report("vertex {} has edges but no halfedge", vh.idx());
      } else if (mesh_.from_vertex_handle(first) != vh) {
        report("vertex {} has a halfedge that starts elsewhere", vh.idx());
      } else if (mesh_.is_boundary(heh) && !mesh_.is_boundary(first)) {
        report("vertex {} lies on the boundary, but its halfedge does not", vh.idx());
      } else {
        return;
      }
      reported[index(vh)] = true;
    });
  }

  void check_fans() {
    std::vector<std::size_t> valence(mesh_.n_vertices(), 0);
    for_each_halfedge([&](HalfedgeHandle heh) { ++valence[index(mesh_.from_vertex_handle(heh))]; });
    for (int i = 0; i < static_cast<int>(mesh_.n_vertices()); ++i) {
      const HalfedgeHandle start = mesh_.halfedge_handle(VertexHandle(i));
      const std::size_t most = valence[static_cast<std::size_t>(i)];
      if (!start.is_valid()) continue;
      std::size_t count = 0;
      HalfedgeHandle heh = start;
      do {
        heh = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(heh));
      } while (++count <= most && heh != start);
      if (count != most) report("vertex {}: turning around it does not reach all its edges", i);
    }
  }

  void check_edges() {
    std::vector<std::array<int, 3>> edges;  // lower vertex, higher vertex, edge
    edges.reserve(mesh_.n_edges());
    for (int i = 0; i < static_cast<int>(mesh_.n_edges()); ++i) {
      const HalfedgeHandle heh = mesh_.halfedge_handle(EdgeHandle(i), 0);
      const int a = mesh_.from_vertex_handle(heh).idx(), b = mesh_.to_vertex_handle(heh).idx();
      edges.push_back({std::min(a, b), std::max(a, b), i});
      if (a == b) report("edge {} goes from vertex {} to itself", i, a);
      if (mesh_.is_boundary(heh) && mesh_.is_boundary(mesh_.opposite_halfedge_handle(heh))) {
        report("edge {} has no face", i);
      }
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i) {
      const auto [a, b, edge] = edges[i];
      if (edges[i - 1][0] != a || edges[i - 1][1] != b) continue;
      report("edges {} and {} both join the vertices {} and {}", edges[i - 1][2], edge, a, b);
    }
  }

  const PolyMesh& mesh_;
  std::vector<std::string> faults_;
  std::size_t count_ = 0;  // of the current kind
};

/// Number of sets of vertices that edges connect.
std::size_t count_components(const PolyMesh& mesh) {
  DisjointSets sets(mesh.n_vertices());
  std::size_t count = mesh.n_vertices();
  for (int i = 0; i < static_cast<int>(mesh.n_edges()); ++i) {
    const HalfedgeHandle heh = mesh.halfedge_handle(EdgeHandle(i), 0);
    const bool were_apart =
        sets.unite(index(mesh.from_vertex_handle(heh)), index(mesh.to_vertex_handle(heh)));
    if (were_apart) --count;
  }
  return count;
}

std::size_t count_split_vertices(const PolyMesh& mesh) {
  std::vector<int> gaps(mesh.n_vertices(), 0);
  for (int i = 0; i < static_cast<int>(mesh.n_halfedges()); ++i) {
    const HalfedgeHandle heh(i);
    if (mesh.is_boundary(heh)) ++gaps[index(mesh.to_vertex_handle(heh))];
  }
  return static_cast<std::size_t>(
      std::count_if(gaps.begin(), gaps.end(), [](int count) { return count > 1; }));
}

}  // namespace

MeshTopology measure_topology(const PolyMesh& mesh) {
  MeshTopology result;
  result.vertices = mesh.n_vertices();
  result.edges = mesh.n_edges();
  result.faces = mesh.n_faces();
  for (int i = 0; i < static_cast<int>(mesh.n_edges()); ++i) {
    if (mesh.is_boundary(EdgeHandle(i))) ++result.boundary_edges;
  }
  result.split_vertices = count_split_vertices(mesh);
  result.components = count_components(mesh);
  result.euler = static_cast<long>(result.vertices) - static_cast<long>(result.edges) +
                 static_cast<long>(result.faces);
  result.is_closed = result.faces > 0 && result.boundary_edges == 0;
  return result;
}

std::vector<std::string> find_faults(const PolyMesh& mesh) { return FaultFinder(mesh).run(); }

}  // namespace surfmesh
