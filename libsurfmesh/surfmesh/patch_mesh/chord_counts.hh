// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "surfmesh/patch_mesh/patch_mesh.hh"

namespace surfmesh::detail {

/// An inner edge of a patch at a node of its boundary.
struct Chord {
  std::size_t patch;
  EdgeHandle edge;
  std::uint64_t ends;  ///< the two result vertices, smaller first
};

inline std::uint64_t ends_of(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

inline bool is_loop(std::uint64_t ends) { return (ends >> 32) == (ends & 0xffffffffu); }

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
      next += static_cast<int>(patch.mesh->n_vertices());
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
class ChordCounts {
 public:
  /// List the edges at boundary nodes of all patches and count the segments of contours.
  std::vector<Chord> collect(const std::vector<PatchMesh>& patches) {
    const VertexNumbers number(patches);
    std::vector<Chord> chords;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const PolyMesh& mesh = *patches[p].mesh;
      const auto boundary_count = static_cast<int>(number.boundary_count(p));
      for (int v = 0; v < boundary_count; ++v) {
        for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(v))) {
          const VertexHandle other = mesh.to_vertex_handle(heh);
          if (other.idx() < v) continue;  // seen from its other end
          const std::uint64_t ends = ends_of(number(p, VertexHandle(v)), number(p, other));
          const EdgeHandle eh = mesh.edge_handle(heh);
          if (mesh.is_boundary(eh)) {
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

}  // namespace surfmesh::detail
