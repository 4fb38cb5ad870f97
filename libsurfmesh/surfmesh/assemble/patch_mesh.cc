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

/// How often each pair of result vertices is joined by segments of contours: once, however many
/// patches see the segment.
class EdgeCounts {
 public:
  /// List the chords of all patches and mark the pairs that contour segments join.
  std::vector<Chord> collect(const std::vector<PatchMesh>& patches,
                             const std::vector<std::vector<int>>& vertices) {
    std::vector<Chord> chords;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const DelaunayMesh& delaunay = *patches[p].delaunay;
      const TriMesh& mesh = delaunay.mesh();
      for (std::size_t v = 0; v < vertices[p].size(); ++v) {
        // Each edge between two boundary nodes once, from its lower end.
        for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(static_cast<int>(v)))) {
          const auto other = static_cast<std::size_t>(mesh.to_vertex_handle(heh).idx());
          if (other >= vertices[p].size() || other < v) continue;
          const int a = vertices[p][v], b = vertices[p][other];
          if (a < 0 || b < 0) continue;
          const EdgeHandle eh = mesh.edge_handle(heh);
          if (delaunay.is_constrained(eh)) {
            count_[ends_of(a, b)] = kSegment;
          } else {
            chords.push_back({p, eh, ends_of(a, b)});
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
  const Uv middle = lerp(delaunay.uv(mesh.from_vertex_handle(heh)),
                         delaunay.uv(mesh.to_vertex_handle(heh)), 0.5);
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
  std::vector<std::vector<int>> vertices;
  for (const PatchMesh& patch : patches) vertices.push_back(boundary_vertices(patch.boundary));
  std::size_t count = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    EdgeCounts edges;
    const std::vector<Chord> chords = edges.collect(patches, vertices);
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
  throw Error(ErrorCode::Geometry,
              "the boundary is too coarse: chords between its nodes keep joining the same vertices");
}

}  // namespace surfmesh
