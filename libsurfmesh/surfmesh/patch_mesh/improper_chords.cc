// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/improper_chords.hh"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

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
class EdgeCounts {
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

/// Splits chords, in the triangles of patches that are reopened for it.
class ChordSplitter {
 public:
  ChordSplitter(std::vector<PatchMesh>& patches, const Model& model,
                const std::vector<const MetricField*>& fields)
      : patches_(patches), model_(model), fields_(fields) {}

  /// Split the chord or, where that is a sliver's too thin to split, another one of the same ends.
  /// Returns  the number of nodes, 0 or 1
  std::size_t split_one_of(const std::vector<Chord>& chords, const Chord& chord) {
    if (split(chord)) return 1;
    for (const Chord& other : chords) {
      if (other.ends == chord.ends && split(other)) return 1;
    }
    return 0;
  }

  /// Finish the patches again, and look for what is turned in them.
  void close(std::map<std::size_t, TurnedTriangles>& turned) {
    for (auto& [p, patch] : open_) {
      patch.delaunay->shrink();
      evaluate_vertices(patch);
      turned[p] = find_turned_triangles(patch);
      patches_[p] = finish_patch(std::move(patch));
    }
    open_.clear();
  }

 private:
  bool split(const Chord& chord) {
    auto found = open_.find(chord.patch);
    if (found == open_.end()) {
      const int patch = static_cast<int>(chord.patch);
      found = open_
                  .emplace(chord.patch, reopen_patch(std::move(patches_[chord.patch]),
                                                     model_.surface(patch), *fields_[chord.patch]))
                  .first;
    }
    return split_chord(found->second, chord.edge);
  }

  std::vector<PatchMesh>& patches_;
  const Model& model_;
  const std::vector<const MetricField*>& fields_;
  std::map<std::size_t, TriangulatedPatch> open_;
};

}  // namespace

ChordReport split_improper_chords(std::vector<PatchMesh>& patches, const Model& model,
                                  const std::vector<const MetricField*>& fields) {
  ChordReport report;
  for (int round = 0; round < kMaxRounds; ++round) {
    EdgeCounts edges;
    const std::vector<Chord> chords = edges.collect(patches);
    const std::size_t before = report.nodes;
    ChordSplitter splitter(patches, model, fields);
    for (const Chord& chord : chords) {
      if (edges.is_offending(chord)) report.nodes += splitter.split_one_of(chords, chord);
    }
    splitter.close(report.turned);
    if (report.nodes == before) return report;
  }
  throw Error(
      ErrorCode::Geometry,
      "the boundary is too coarse: chords between its nodes keep joining the same vertices");
}

}  // namespace surfmesh
