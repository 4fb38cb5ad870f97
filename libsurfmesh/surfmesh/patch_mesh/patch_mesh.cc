// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/patch_mesh.hh"

#include <Eigen/Geometry>
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

/// Numbers for all vertices that edges at boundary nodes can have: result vertices for nodes of
/// contours, further numbers for the vertices of each patch's own.
class VertexNumbers {
 public:
  explicit VertexNumbers(const std::vector<PatchMesh>& patches) {
    int next = 0;
    for (const PatchMesh& patch : patches) {
      boundary_.push_back(boundary_vertices(patch.boundary));
      for (const int v : boundary_.back()) next = std::max(next, v + 1);
    }
    for (const PatchMesh& patch : patches) {
      first_own_.push_back(next);
      next += static_cast<int>(patch.delaunay->n_vertices());
    }
  }

  std::size_t boundary_count(std::size_t patch) const { return boundary_[patch].size(); }

  int operator()(std::size_t patch, VertexHandle vh) const {
    const auto v = index(vh);
    const bool is_shared = v < boundary_[patch].size() && boundary_[patch][v] >= 0;
    return is_shared ? boundary_[patch][v] : first_own_[patch] + vh.idx();
  }

 private:
  std::vector<std::vector<int>> boundary_;
  std::vector<int> first_own_;
};

/// How often each pair of vertices is joined: once by a segment of a contour, however many patches
/// see it, and once by each chord.
class EdgeCounts {
 public:
  /// List the edges at boundary nodes of all patches and count the segments of contours.
  std::vector<Chord> collect(const std::vector<PatchMesh>& patches) {
    const VertexNumbers number(patches);
    std::vector<Chord> chords;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const DelaunayMesh& delaunay = *patches[p].delaunay;
      const TriMesh& mesh = delaunay.mesh();
      const auto boundary_count = static_cast<int>(number.boundary_count(p));
      for (int v = 0; v < boundary_count; ++v) {
        for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(v))) {
          const VertexHandle other = mesh.to_vertex_handle(heh);
          if (other.idx() < v) continue;  // seen from its other end
          const std::uint64_t ends = ends_of(number(p, VertexHandle(v)), number(p, other));
          const EdgeHandle eh = mesh.edge_handle(heh);
          if (delaunay.is_constrained(eh)) {
            count_[ends] = 1;
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
  std::unordered_map<std::uint64_t, int> count_;
};

/// Split the chord or, where that is a sliver's too thin to split, another one of the same ends.
/// Returns  the number of nodes, 0 or 1
std::size_t split_one_of(std::vector<PatchMesh>& patches, const std::vector<Chord>& chords,
                         const Chord& chord) {
  if (split_chord(patches[chord.patch], chord.edge)) return 1;
  for (const Chord& other : chords) {
    if (other.ends == chord.ends && split_chord(patches[other.patch], other.edge)) return 1;
  }
  return 0;
}

}  // namespace

void evaluate_vertices(PatchMesh& patch) {
  patch.points.reserve(patch.delaunay->n_vertices());
  patch.normals.reserve(patch.delaunay->n_vertices());
  for (std::size_t v = patch.points.size(); v < patch.delaunay->n_vertices(); ++v) {
    const Uv uv = patch.delaunay->uv(VertexHandle(static_cast<int>(v)));
    const Jet jet = patch.surface->evaluate(uv, Order::First);
    patch.points.push_back(jet.point);
    patch.normals.push_back(jet.du.cross(jet.dv));
  }
}

bool split_chord(PatchMesh& patch, EdgeHandle eh) {
  DelaunayMesh& delaunay = *patch.delaunay;
  const TriMesh& mesh = delaunay.mesh();
  const HalfedgeHandle heh = mesh.halfedge_handle(eh, 0);
  const Uv middle =
      lerp(delaunay.uv(mesh.from_vertex_handle(heh)), delaunay.uv(mesh.to_vertex_handle(heh)), 0.5);
  for (const HalfedgeHandle side : {heh, mesh.opposite_halfedge_handle(heh)}) {
    const Uv origin = delaunay.uv(mesh.from_vertex_handle(side));
    const Uv tip = delaunay.uv(mesh.to_vertex_handle(side));
    const Uv apex = delaunay.uv(mesh.to_vertex_handle(mesh.next_halfedge_handle(side)));
    if (orient2d(middle, tip, apex) <= 0 || orient2d(middle, apex, origin) <= 0) return false;
  }
  QueryHint hint;
  const VertexHandle vh = delaunay.split_edge(eh, middle);
  delaunay.metric(vh) = patch.field->at(middle, hint);
  return true;
}

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
    const std::vector<Chord> chords = edges.collect(patches);
    const std::size_t before = count;
    for (const Chord& chord : chords) {
      if (!edges.is_offending(chord)) continue;
      count += split_one_of(patches, chords, chord);
    }
    for (PatchMesh& patch : patches) patch.delaunay->shrink();
    if (count == before) return count;
  }
  throw Error(
      ErrorCode::Geometry,
      "the boundary is too coarse: chords between its nodes keep joining the same vertices");
}

}  // namespace surfmesh
