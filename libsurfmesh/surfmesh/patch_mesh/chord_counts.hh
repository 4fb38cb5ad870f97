// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "surfmesh/core/buckets.hh"
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
    boundary_.resize(patches.size());
    share_indices(patches.size(),
                  [&](std::size_t p) { boundary_[p] = boundary_vertices(patches[p].boundary); });
    int next = 0;
    for (const std::vector<int>& vertices : boundary_) {
      for (const int v : vertices) next = std::max(next, v + 1);
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

/// The edges at boundary nodes of a patch.
struct BoundaryEdges {
  std::vector<Chord> chords;
  std::vector<std::uint64_t> segments;  ///< of contours, by their ends
};

inline BoundaryEdges boundary_edges(const PatchMesh& patch, std::size_t p,
                                    const VertexNumbers& number) {
  BoundaryEdges edges;
  const PolyMesh& mesh = *patch.mesh;
  const auto boundary_count = static_cast<int>(number.boundary_count(p));
  for (int v = 0; v < boundary_count; ++v) {
    for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(v))) {
      const VertexHandle other = mesh.to_vertex_handle(heh);
      if (other.idx() < v) continue;  // seen from its other end
      const std::uint64_t ends = ends_of(number(p, VertexHandle(v)), number(p, other));
      const EdgeHandle eh = mesh.edge_handle(heh);
      if (mesh.is_boundary(eh)) {
        edges.segments.push_back(ends);
      } else {
        edges.chords.push_back({p, eh, ends});
      }
    }
  }
  return edges;
}

/// The chords between nodes of boundaries, and which of them make a mesh improper. Each pair of
/// vertices may be joined once: by a segment of a contour, however many patches see it, or by a
/// chord.
class ImproperChords {
 public:
  explicit ImproperChords(const std::vector<PatchMesh>& patches) {
    const VertexNumbers number(patches);
    std::vector<BoundaryEdges> of_patches(patches.size());
    share_indices(patches.size(),
                  [&](std::size_t p) { of_patches[p] = boundary_edges(patches[p], p, number); });
    std::vector<std::uint64_t> segments;
    for (const BoundaryEdges& edges : of_patches) {
      all_.insert(all_.end(), edges.chords.begin(), edges.chords.end());
      segments.insert(segments.end(), edges.segments.begin(), edges.segments.end());
    }
    mark(segments);
  }

  /// All chords, by patch.
  const std::vector<Chord>& all() const { return all_; }

  /// Those that another edge, or an earlier chord, makes improper.
  std::vector<Chord> offending() const {
    std::vector<Chord> offending;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (is_offending_[i] != 0) offending.push_back(all_[i]);
    }
    return offending;
  }

 private:
  /// Segments come first, so that chords are compared with them, too.
  void mark(const std::vector<std::uint64_t>& segments) {
    is_offending_.assign(all_.size(), 0);
    const std::size_t count = segments.size();
    const auto ends = [&](std::size_t i) { return i < count ? segments[i] : all_[i - count].ends; };
    std::vector<std::uint64_t> keys(count + all_.size());
    share_ranges(keys.size(), [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) keys[i] = Buckets::hash(ends(i));
    });
    const Buckets buckets(keys);
    share_indices(Buckets::kCount, [&](std::size_t bucket) {
      std::unordered_set<std::uint64_t> joined;
      for (const std::uint32_t i : buckets[bucket]) {
        const bool is_new = joined.insert(ends(i)).second;
        if (i >= count && (!is_new || is_loop(ends(i)))) is_offending_[i - count] = 1;
      }
    });
  }

  std::vector<Chord> all_;
  std::vector<char> is_offending_;
};

}  // namespace surfmesh::detail
