// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/assemble/patch_mesh.hh"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "surfmesh/core/error.hh"

namespace surfmesh {
namespace {

/// Each round splits every offending chord once; new edges offend only where both ends of the
/// triangles at a chord are the same vertices.
constexpr int kMaxRounds = 20;

struct Chord {
  std::size_t patch;
  EdgeHandle edge;
  std::uint64_t ends;  ///< the two result vertices, smaller first
};

std::uint64_t ends_of(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

bool is_loop(std::uint64_t ends) { return (ends >> 32) == (ends & 0xffffffffu); }

/// Numbers of the vertices of all patches in the result: those of contour nodes, then one of its
/// own for every other vertex.
class ResultNumbers {
 public:
  explicit ResultNumbers(const std::vector<PatchMesh>& patches) {
    for (const PatchMesh& patch : patches) {
      boundary_.push_back(boundary_vertices(patch.boundary));
      for (const int vertex : boundary_.back()) count_ = std::max(count_, vertex + 1);
    }
    find_repeated();
    for (const PatchMesh& patch : patches) {
      first_own_.push_back(count_);
      count_ += static_cast<int>(patch.delaunay->n_vertices());
    }
  }

  std::size_t boundary_count(std::size_t patch) const { return boundary_[patch].size(); }

  int operator()(std::size_t patch, std::size_t v) const {
    const std::vector<int>& boundary = boundary_[patch];
    if (v < boundary.size() && boundary[v] >= 0) return boundary[v];
    return first_own_[patch] + static_cast<int>(v);
  }

  /// True for a boundary node whose result vertex is another boundary node of the patch, too.
  bool is_repeated(std::size_t patch, std::size_t v) const { return repeated_[patch][v] != 0; }

 private:
  void find_repeated() {
    std::vector<int> last_patch(static_cast<std::size_t>(count_), -1);
    std::vector<int> twice_in(static_cast<std::size_t>(count_), -1);
    for (std::size_t p = 0; p < boundary_.size(); ++p) {
      const int patch = static_cast<int>(p);
      for (const int vertex : boundary_[p]) {
        if (vertex < 0) continue;
        const auto i = static_cast<std::size_t>(vertex);
        if (last_patch[i] == patch) twice_in[i] = patch;
        last_patch[i] = patch;
      }
      repeated_.emplace_back();
      for (const int vertex : boundary_[p]) {
        repeated_[p].push_back(vertex >= 0 && twice_in[static_cast<std::size_t>(vertex)] == patch);
      }
    }
  }

  std::vector<std::vector<int>> boundary_;
  std::vector<std::vector<char>> repeated_;
  std::vector<int> first_own_;
  int count_ = 0;
};

/// How often each pair of result vertices is joined by segments of contours: once, however many
/// patches see the segment.
class EdgeCounts {
 public:
  /// List the chords of all patches and mark the pairs that contour segments join. An edge to an
  /// inner vertex is a chord only where that can meet the same vertex twice.
  std::vector<Chord> collect(const std::vector<PatchMesh>& patches, const ResultNumbers& numbers) {
    std::vector<Chord> chords;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const DelaunayMesh& delaunay = *patches[p].delaunay;
      const TriMesh& mesh = delaunay.mesh();
      const std::size_t boundary_count = numbers.boundary_count(p);
      for (std::size_t v = 0; v < boundary_count; ++v) {
        for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(static_cast<int>(v)))) {
          const auto other = static_cast<std::size_t>(mesh.to_vertex_handle(heh).idx());
          // Each edge between two boundary nodes once, from its lower end.
          if (other < boundary_count ? other < v : !numbers.is_repeated(p, v)) continue;
          const EdgeHandle eh = mesh.edge_handle(heh);
          const std::uint64_t ends = ends_of(numbers(p, v), numbers(p, other));
          if (delaunay.is_constrained(eh)) {
            count_[ends] = kSegment;
          } else {
            chords.push_back({p, eh, ends});
          }
        }
      }
    }
    return chords;
  }

  /// True for every chord that another edge, or an earlier chord, makes improper.
  bool is_offending(const Chord& chord) {
    if (is_loop(chord.ends)) return true;
    return count_[chord.ends]++ > 0;
  }

 private:
  static constexpr int kSegment = 1;
  std::unordered_map<std::uint64_t, int> count_;
};

void split(PatchMesh& patch, EdgeHandle eh) {
  DelaunayMesh& delaunay = *patch.delaunay;
  const TriMesh& mesh = delaunay.mesh();
  const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
  const Uv middle =
      lerp(delaunay.uv(mesh.from_vertex_handle(heh)), delaunay.uv(mesh.to_vertex_handle(heh)), 0.5);
  MetricField::Hint hint;
  const VertexHandle vh = delaunay.split_edge(eh, middle);
  delaunay.metric(vh) = patch.field->at(middle, hint);
}

}  // namespace

std::vector<int> boundary_vertices(const PatchBoundary& boundary) {
  std::vector<int> vertices;
  for (const BoundaryLoop& loop : boundary.loops) {
    for (const BoundaryNode& node : loop) vertices.push_back(node.vertex);
  }
  return vertices;
}

std::size_t split_improper_chords(std::vector<PatchMesh>& patches) {
  std::size_t count = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    EdgeCounts edges;
    const std::vector<Chord> chords = edges.collect(patches, ResultNumbers(patches));
    const std::size_t before = count;
    for (const Chord& chord : chords) {
      if (!edges.is_offending(chord)) continue;
      split(patches[chord.patch], chord.edge);
      ++count;
    }
    if (count == before) {
      for (PatchMesh& patch : patches) patch.delaunay->shrink();
      return count;
    }
  }
  throw Error(
      ErrorCode::Geometry,
      "the boundary is too coarse: chords between its nodes keep joining the same vertices");
}

}  // namespace surfmesh
