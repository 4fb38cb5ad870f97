// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/clean_quads.hh"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "surfmesh/core/quad_topology.hh"
#include "surfmesh/quad/quad_moves.hh"
#include "surfmesh/quad/quad_trial.hh"

namespace surfmesh {
namespace {

constexpr int kMaxPasses = 8;

/// Pillows come last: earlier ones spoil corners that other changes would mend.
constexpr int kPassesBeforePillows = 2;

/// Another pass is not worth while if the last one changed fewer faces than one in so many.
constexpr std::size_t kFacesPerChange = 10000;

/// At quads below this scaled Jacobian all changes are tried.
constexpr double kPoorQuad = 0.55;

/// Elsewhere a change is tried that does not raise the irregularity by more than this.
constexpr int kMostIrregularity = 0;

/// Trials for each face, and in all, after which cleaning ends: where blocks are far narrower than
/// quads, hardly any does good. Elsewhere there are about two.
constexpr std::size_t kTrialsPerFace = 10, kLeastTrials = 1000;

/// Vertices of more faces are opened by halves only.
constexpr int kManyFaces = 12;

class Cleaning {
 public:
  Cleaning(PolyMesh& mesh, FaceEditor& editor, QuadGeometry& geometry, std::vector<int> wanted,
           const RunContext& context)
      : state_(mesh, editor, geometry, std::move(wanted)),
        trial_(state_),
        context_(context),
        most_trials_(kLeastTrials + kTrialsPerFace * mesh.n_faces()) {}

  CleaningReport run() {
    for (pass_ = 0; pass_ < kMaxPasses; ++pass_) {
      const std::size_t before = report_.changed;
      run_pass();
      if (report_.changed - before <= state_.mesh.n_faces() / kFacesPerChange &&
          pass_ >= kPassesBeforePillows) {
        break;
      }
    }
    return report_;
  }

 private:
  // --- passes ---

  void run_pass() {
    touched_.resize(state_.mesh.n_vertices(), pass_ - 1);
    std::size_t steps = 0;
    for (const FaceHandle fh : faces_in_order()) {
      if (report_.tried > most_trials_) return;
      if (++steps % kSearchesBetweenCancellation == 0) context_.throw_if_cancelled();
      if (state_.editor.is_used(fh) && is_awake(fh) &&
          is_at_quad(state_.mesh, state_.mesh.halfedge_handle(fh)))
        mend(fh);
    }
  }

  /// Bad quads first, the worst of them first; the others as they lie.
  std::vector<FaceHandle> faces_in_order() const {
    std::vector<FaceHandle> faces;
    for (std::size_t f = 0; f < state_.editor.face_bound(); ++f) {
      const FaceHandle fh(static_cast<int>(f));
      if (state_.editor.is_used(fh)) faces.push_back(fh);
    }
    const auto others = std::stable_partition(
        faces.begin(), faces.end(), [&](FaceHandle fh) { return is_below(fh, kBadQuad); });
    std::stable_sort(faces.begin(), others, [&](FaceHandle a, FaceHandle b) {
      return least_jacobian(a) < least_jacobian(b);
    });
    return faces;
  }

  double least_jacobian(FaceHandle fh) const { return state_.measures[index(fh)].least_jacobian; }
  bool is_below(FaceHandle fh, double bound) const { return least_jacobian(fh) < bound; }

  /// True for bad quads, and where something has changed since the pass before the last one.
  bool is_awake(FaceHandle fh) const {
    if (is_below(fh, kBadQuad)) return true;
    for (const VertexHandle vh : state_.mesh.fv_range(fh)) {
      if (touched_[index(vh)] >= pass_ - 1) return true;
    }
    return false;
  }

  // --- changes of one face ---

  void mend(FaceHandle fh) {
    most_ = is_below(fh, kPoorQuad) ? std::numeric_limits<int>::max() : kMostIrregularity;
    if (most_ == kMostIrregularity && is_regular(fh)) return;
    if (try_doublets(fh) || try_rotations(fh) || try_collapses(fh) || try_openings(fh)) return;
    if (!is_below(fh, kBadQuad) || try_columns(fh)) return;
    if (pass_ >= kPassesBeforePillows && insert_pillow(state_, fh, change_)) attempt();
  }

  /// No change of such a face can be tried: each would raise the irregularity.
  bool is_regular(FaceHandle fh) const {
    for (const VertexHandle vh : state_.mesh.fv_range(fh)) {
      if (state_.excess(vh) != 0) return false;
    }
    return true;
  }

  bool is_poor() const { return most_ != kMostIrregularity; }

  std::array<HalfedgeHandle, 4> sides(FaceHandle fh) const {
    return quad_sides(state_.mesh, state_.mesh.halfedge_handle(fh));
  }

  bool attempt() {
    ++report_.tried;
    if (!trial_.attempt(change_)) return false;
    ++report_.changed;
    if (touched_.size() < state_.editor.vertex_bound()) {
      touched_.resize(state_.mesh.n_vertices(), pass_);
    }
    for (const VertexHandle vh : trial_.touched()) touched_[index(vh)] = pass_;
    return true;
  }

  bool try_doublets(FaceHandle fh) {
    for (const HalfedgeHandle heh : sides(fh)) {
      const VertexHandle vh = state_.mesh.to_vertex_handle(heh);
      if (state_.is_boundary(vh) || state_.count(vh) != 2) continue;
      if (dissolve_doublet(state_, vh, change_) && attempt()) return true;
    }
    return false;
  }

  bool try_rotations(FaceHandle fh) {
    for (const HalfedgeHandle heh : sides(fh)) {
      if (!is_poor() && !is_first_side(heh)) continue;
      if (state_.mesh.is_boundary(state_.mesh.edge_handle(heh))) continue;
      for (const Turn turn : {Turn::CounterClockwise, Turn::Clockwise}) {
        if (rotate_edge(state_, heh, turn, most_, change_) && attempt()) return true;
      }
    }
    return false;
  }

  /// An edge is seen from both of its faces; once is enough.
  bool is_first_side(HalfedgeHandle heh) const {
    return heh < state_.mesh.opposite_halfedge_handle(heh);
  }

  bool try_collapses(FaceHandle fh) {
    for (const HalfedgeHandle heh : sides(fh)) {
      if (collapse_quad(state_, heh, most_, change_) && attempt()) return true;
    }
    return false;
  }

  bool try_openings(FaceHandle fh) {
    for (const HalfedgeHandle heh : sides(fh)) {
      const VertexHandle vh = state_.mesh.from_vertex_handle(heh);
      if (state_.excess(vh) < 1 ||
          (!is_poor() && state_.mesh.face_handle(state_.mesh.halfedge_handle(vh)) != fh &&
           !state_.is_boundary(vh))) {
        continue;
      }
      if (try_openings_of(vh)) return true;
    }
    return false;
  }

  bool try_openings_of(VertexHandle vh) {
    const int count = state_.count(vh);
    const int possible = state_.is_boundary(vh) ? count - 1 : count - 2;
    int most = is_poor() ? possible : std::min(possible, 2);
    std::vector<HalfedgeHandle> around;
    for (const HalfedgeHandle heh : state_.mesh.voh_range(vh)) around.push_back(heh);
    int least = 2;
    if (count > kManyFaces) {
      // Halves in a few directions: all ways to divide so many faces would take minutes.
      least = most = count / 2;
      around.resize(kManyFaces);
    }
    for (int faces = least; faces <= most; ++faces) {
      for (const HalfedgeHandle heh : around) {
        if (open_vertex(state_, heh, faces, most_, change_) && attempt()) return true;
      }
    }
    return false;
  }

  bool try_columns(FaceHandle fh) {
    for (const HalfedgeHandle heh : sides(fh)) {
      const VertexHandle vh = state_.mesh.from_vertex_handle(heh);
      if (!state_.is_boundary(vh) || state_.count(vh) != 1) continue;
      const VertexHandle opposite =
          state_.mesh.to_vertex_handle(state_.mesh.next_halfedge_handle(heh));
      for (int faces = 2; faces <= state_.count(opposite) - 3; ++faces) {
        if (insert_column(state_, heh, faces, change_) && attempt()) return true;
      }
    }
    return false;
  }

  QuadState state_;
  QuadTrial trial_;
  const RunContext& context_;
  Replacement change_;
  std::vector<int> touched_;  ///< by vertex: the pass that last changed a face there
  int pass_ = 0;
  int most_ = 0;  ///< by which a change of the face that is mended may raise the irregularity
  std::size_t most_trials_;
  CleaningReport report_;
};

}  // namespace

CleaningReport clean_quads(PolyMesh& mesh, FaceEditor& editor, QuadGeometry& geometry,
                           std::vector<int> wanted, const RunContext& context) {
  return Cleaning(mesh, editor, geometry, std::move(wanted), context).run();
}

}  // namespace surfmesh
