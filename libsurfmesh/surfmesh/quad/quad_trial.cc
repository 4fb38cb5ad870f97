// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/quad/quad_trial.hh"

#include <array>

namespace surfmesh {
namespace {

/// Gains for which a change is kept: of the badness Σ (1 − SJ / 0.35)² of bad quads, or of the
/// energy.
constexpr double kBadnessGain = 0.05, kEnergyGain = 0.02;

/// Rounds of smoothing in a trial with bad quads. Fewer lose most of the good changes.
constexpr int kRoundsOfBad = 8;

/// Rounds in other trials, each with the energy above which it is the last, as a multiple of that
/// before the change. Three trials of four end before the last round; of the good changes one in
/// 20 is lost.
constexpr std::array kHopelessEnergies = {8.0, 2.0, 1.15, 1.0};

}  // namespace

void QuadTrial::Sum::add(const FaceMeasure& face) {
  energy += face.energy;
  if (face.least_jacobian >= kBadQuad) return;
  const double lack = 1 - face.least_jacobian / kBadQuad;
  badness += lack * lack;
}

/// True the first time in a round.
bool QuadTrial::stamp(std::vector<int>& stamps, std::size_t i) {
  if (i >= stamps.size()) stamps.resize(i + i / 2 + 16, 0);
  if (stamps[i] == round_) return false;
  stamps[i] = round_;
  return true;
}

bool QuadTrial::attempt(const Replacement& change) {
  ++round_;
  Sum before;
  for (const FaceHandle fh : change.old) before.add(state_.measures[index(fh)]);
  apply(change);
  collect_around();
  for (std::size_t i = made_.size(); i < around_.size(); ++i) {
    before.add(state_.measures[index(around_[i])]);
  }
  const Sum after = before.badness > 0 ? smooth_bad() : smooth(before.energy);
  const bool is_better =
      after.badness < before.badness - kBadnessGain ||
      (after.badness <= before.badness && after.energy < before.energy - kEnergyGain);
  if (is_better) {
    keep(change);
  } else {
    undo(change);
  }
  return is_better;
}

void QuadTrial::apply(const Replacement& change) {
  old_corners_.clear();
  for (const FaceHandle fh : change.old) {
    for (const VertexHandle vh : state_.mesh.fv_range(fh)) old_corners_.push_back(vh);
  }
  state_.geometry.begin_trial();
  for (const Replacement::Middle& middle : change.middles) {
    state_.geometry.put_between(middle.vertex, middle.others);
  }
  state_.editor.replace(change.old, change.fresh, made_);
}

void QuadTrial::collect_around() {
  moving_.clear();
  around_.clear();
  for (const FaceHandle fh : made_) {
    stamp(face_stamps_, index(fh));
    around_.push_back(fh);
    for (const VertexHandle vh : state_.mesh.fv_range(fh)) {
      if (state_.geometry.is_free(vh) && stamp(vertex_stamps_, index(vh))) moving_.push_back(vh);
    }
  }
  for (const VertexHandle vh : moving_) {
    for (const FaceHandle fh : state_.mesh.vf_range(vh)) {
      if (stamp(face_stamps_, index(fh))) around_.push_back(fh);
    }
  }
}

QuadTrial::Sum QuadTrial::smooth_bad() {
  for (int round = 0; round < kRoundsOfBad; ++round) smooth_once({.size = 0.1});
  return measure();
}

QuadTrial::Sum QuadTrial::smooth(double energy_before) {
  Sum sum;
  for (const double hopeless : kHopelessEnergies) {
    smooth_once({});
    sum = measure();
    if (sum.energy > hopeless * energy_before) break;
  }
  return sum;
}

void QuadTrial::smooth_once(EnergyWeights weights) {
  for (const VertexHandle vh : moving_) smoother_.smooth(vh, weights);
}

QuadTrial::Sum QuadTrial::measure() {
  Sum sum;
  measures_.clear();
  for (const FaceHandle fh : around_) {
    measures_.push_back(state_.geometry.measure(fh));
    sum.add(measures_.back());
  }
  return sum;
}

void QuadTrial::count_faces(std::span<const VertexHandle> corners, int by) {
  if (state_.counts.size() < state_.editor.vertex_bound()) {
    state_.counts.resize(state_.mesh.n_vertices(), 0);
  }
  for (const VertexHandle vh : corners) state_.counts[index(vh)] += by;
}

void QuadTrial::keep(const Replacement& change) {
  state_.geometry.keep_trial();
  if (state_.measures.size() < state_.editor.face_bound()) {
    state_.measures.resize(state_.mesh.n_faces());
  }
  for (std::size_t i = 0; i < around_.size(); ++i) {
    state_.measures[index(around_[i])] = measures_[i];
  }
  count_faces(old_corners_, -1);
  count_faces(change.fresh.vertices(), 1);
  for (const VertexHandle vh : change.removed) state_.editor.free_vertex(vh);
  ++round_;
  touched_.clear();
  for (const FaceHandle fh : around_) {
    for (const VertexHandle vh : state_.mesh.fv_range(fh)) {
      if (stamp(vertex_stamps_, index(vh))) touched_.push_back(vh);
    }
  }
}

void QuadTrial::undo(const Replacement& change) {
  state_.editor.undo_replacement();
  state_.geometry.undo_trial();
  discard(change);
}

void QuadTrial::discard(const Replacement& change) {
  for (const VertexHandle vh : change.added) state_.editor.free_vertex(vh);
}

}  // namespace surfmesh
