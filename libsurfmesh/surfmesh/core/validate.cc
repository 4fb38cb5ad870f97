// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/core/validate.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "surfmesh/core/range_sums.hh"
#include "surfmesh/core/shared_sets.hh"

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

/// What a range of the edges adds.
struct EdgeCounts {
  std::size_t boundary_edges = 0;
  std::size_t joined = 0;                  ///< sets of vertices that were apart
  std::vector<std::size_t> boundary_tips;  ///< vertices at the ends of boundary halfedges

  EdgeCounts& operator+=(const EdgeCounts& other) {
    boundary_edges += other.boundary_edges;
    joined += other.joined;
    boundary_tips.insert(boundary_tips.end(), other.boundary_tips.begin(),
                         other.boundary_tips.end());
    return *this;
  }
};

EdgeCounts count_edges(const PolyMesh& mesh) {
  SharedSets sets(mesh.n_vertices());
  return sum_of_ranges(mesh.n_edges(), [&](std::size_t first, std::size_t end) {
    EdgeCounts counts;
    for (std::size_t e = first; e < end; ++e) {
      const EdgeHandle eh(static_cast<int>(e));
      const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
      const std::size_t from = index(mesh.from_vertex_handle(heh));
      const std::size_t to = index(mesh.to_vertex_handle(heh));
      if (sets.unite(from, to)) ++counts.joined;
      if (mesh.is_boundary(eh)) ++counts.boundary_edges;
      if (mesh.is_boundary(heh)) counts.boundary_tips.push_back(to);
      if (mesh.is_boundary(mesh.opposite_halfedge_handle(heh)))
        counts.boundary_tips.push_back(from);
    }
    return counts;
  });
}

/// The vertices that come up more than once.
std::size_t count_repeated(std::vector<std::size_t> vertices) {
  std::sort(vertices.begin(), vertices.end());
  std::size_t count = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const bool is_second = i < 2 || vertices[i - 2] != vertices[i];
    if (vertices[i - 1] == vertices[i] && is_second) ++count;
  }
  return count;
}

}  // namespace

MeshTopology measure_topology(const PolyMesh& mesh) {
  MeshTopology result;
  result.vertices = mesh.n_vertices();
  result.edges = mesh.n_edges();
  result.faces = mesh.n_faces();
  EdgeCounts counts = count_edges(mesh);
  result.boundary_edges = counts.boundary_edges;
  result.components = result.vertices - counts.joined;
  result.split_vertices = count_repeated(std::move(counts.boundary_tips));
  result.euler = static_cast<long>(result.vertices) - static_cast<long>(result.edges) +
                 static_cast<long>(result.faces);
  result.is_closed = result.faces > 0 && result.boundary_edges == 0;
  return result;
}

std::vector<std::string> find_faults(const PolyMesh& mesh) { return FaultFinder(mesh).run(); }

}  // namespace surfmesh
