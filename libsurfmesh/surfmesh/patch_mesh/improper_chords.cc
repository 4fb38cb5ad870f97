// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/patch_mesh/improper_chords.hh"

#include <utility>

#include "surfmesh/core/error.hh"
#include "surfmesh/patch_mesh/chord_counts.hh"

namespace surfmesh {
namespace {

using detail::Chord;

/// Each round splits every offending chord once; new edges offend only where both ends of the
/// triangles at a chord are the same vertices.
constexpr int kMaxRounds = 20;

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
      PatchMesh& patch = patches_[chord.patch];
      const Surface& surface = model_.surface(patch.boundary.patch);
      const MetricField& field = *fields_[patch.patch()];
      found = open_.emplace(chord.patch, reopen_patch(std::move(patch), surface, field)).first;
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
    const detail::ImproperChords chords(patches);
    const std::size_t before = report.nodes;
    ChordSplitter splitter(patches, model, fields);
    for (const Chord& chord : chords.offending()) {
      report.nodes += splitter.split_one_of(chords.all(), chord);
    }
    splitter.close(report.turned);
    if (report.nodes == before) return report;
  }
  throw_too_coarse_boundary();
}

void throw_too_coarse_boundary() {
  throw Error(
      ErrorCode::Geometry,
      "the boundary is too coarse: chords between its nodes keep joining the same vertices");
}

EdgeEnds edge_ends(int from, int to) { return detail::ends_of(from, to); }

SharedEdges shared_edges(const PatchMesh& tile) {
  SharedEdges shared;
  const std::vector<int> vertices = boundary_vertices(tile.boundary);
  const PolyMesh& mesh = *tile.mesh;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v] < 0) continue;
    for (const HalfedgeHandle heh : mesh.voh_range(VertexHandle(static_cast<int>(v)))) {
      const std::size_t other = index(mesh.to_vertex_handle(heh));
      if (other < v || other >= vertices.size() || vertices[other] < 0) continue;
      const bool is_segment = mesh.is_boundary(mesh.edge_handle(heh));
      (is_segment ? shared.segments : shared.chords)
          .push_back(detail::ends_of(vertices[v], vertices[other]));
    }
  }
  return shared;
}

}  // namespace surfmesh
