// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surfmesh/quad/quad_state.hh"
#include "surfmesh/quad/smooth_quads.hh"

namespace surfmesh {

/// Quads below this scaled Jacobian are bad: whatever makes them better is taken.
inline constexpr double kBadQuad = 0.35;

/// Makes changes of quads on trial.
///
/// The vertices of the new faces are smoothed. The change is kept if bad quads are much better in
/// sum, or no worse in sum and the energy of all faces that changed is less; otherwise everything
/// is as before.
class QuadTrial {
 public:
  explicit QuadTrial(QuadState& state) : state_(state), smoother_(state.geometry) {}

  /// Returns  whether the change was kept
  /// Cost     20 to 60 µs
  bool attempt(const Replacement& change);

  /// Give a change up without a trial.
  void discard(const Replacement& change);

  /// The vertices whose faces the last change that was kept has changed.
  const std::vector<VertexHandle>& touched() const { return touched_; }

 private:
  /// The sum of a measure over faces.
  struct Sum {
    double energy = 0;
    double badness = 0;

    void add(const FaceMeasure& face);
  };

  void apply(const Replacement& change);
  void collect_around();
  Sum smooth_bad();
  Sum smooth(double energy_before);
  void smooth_once(EnergyWeights weights);
  Sum measure();
  void keep(const Replacement& change);
  void undo(const Replacement& change);
  void count_faces(std::span<const VertexHandle> corners, int by);
  bool stamp(std::vector<int>& stamps, std::size_t i);

  QuadState& state_;
  QuadSmoother smoother_;
  std::vector<VertexHandle> old_corners_;  ///< of the faces that go
  std::vector<FaceHandle> made_;
  std::vector<VertexHandle> moving_;   ///< vertices of the new faces that may move
  std::vector<FaceHandle> around_;     ///< faces at these, the new ones first
  std::vector<FaceMeasure> measures_;  ///< of those faces, after the change
  std::vector<VertexHandle> touched_;
  std::vector<int> face_stamps_, vertex_stamps_;
  int round_ = 0;
};

}  // namespace surfmesh
