// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "surfmesh/core/values.hh"
#include "surfmesh/geometry/curve.hh"
#include "surfmesh/model/join_sides.hh"

/// Steps of model_from_patches, apart for their tests.
namespace surfmesh {

using Box3 = Eigen::AlignedBox3d;

/// Lengths that decide what coincides, in model units.
struct JoinLengths {
  double join = 0;      ///< places this near are one place
  double near = 0;      ///< sides nearer than this were perhaps meant to be joined
  double diagonal = 0;  ///< of the model
};

/// The greatest joining, in diagonals: with more, short sides would become points.
inline constexpr double kMostJoining = 0.01;

/// Numbers 0 = t_0 < ... < t_n = 1, unevenly spaced so that no wave of a surface is in step with
/// them; gaps are below 2/n.
std::vector<double> sample_parameters(int count);

/// A line in the parameters of a patch: a side, or a part of one.
struct SideLine {
  int patch = -1;
  const Surface* surface = nullptr;
  Uv a;  ///< at t = 0
  Uv b;  ///< at t = 1

  Uv at_uv(double t) const { return lerp(a, b, t); }
  Vec3 at(double t) const { return surface->evaluate(at_uv(t), Order::Position).point; }
  double project(const Vec3& point, double t_guess) const;
  /// The part from t0 to t1; a coordinate that is constant stays so exactly.
  SideLine part(double t0, double t1) const;
  SideLine reversed() const { return {patch, surface, b, a}; }
};

/// A line with its samples at sample_parameters.
struct SampledLine {
  SideLine line;
  std::vector<Vec3> points;

  /// Box of the samples, larger by their greatest distance, so that the line is inside.
  Box3 box() const;
  /// Greatest distance of samples that follow each other.
  double max_step() const;
  /// Length of the line through the samples.
  double length() const;
  /// Number of the sample nearest to a point.
  std::size_t nearest(const Vec3& point) const;
};

/// Samples of a line that is to be compared with others.
inline constexpr int kLineSamples = 32;

SampledLine sample(const SideLine& line, int count = kLineSamples);

/// A side of a patch's domain rectangle.
struct PatchSide {
  std::string name;
  SampledLine curve;
  bool is_forward = true;      ///< the patch is on the left of the growing parameter
  bool is_degenerate = false;  ///< one point in space
};

/// Ends of a side's name, in the order of the outer loop: v0, u1, v1, u0.
inline constexpr const char* kSideNames[4] = {"v0", "u1", "v1", "u0"};

/// Refuse what model_from_patches does not take: see its Throws.
void check_patches(const std::vector<PatchInput>& patches);

/// A patch for messages: "patch wing", after its origin if it has one.
std::string label(const PatchInput& patch);

/// The bounding box of 17 x 17 samples of every patch.
///
/// Throws   Geometry for a patch that is a point or a line, as seen from the diagonal, or a wave
///          too short for any sample
Box3 measure_patches(const std::vector<PatchInput>& patches);

/// Greatest rounding of an evaluation that gives this point: a few units in the last place of its
/// coordinates.
double rounding_at(const Vec3& point);

/// The tolerances for a model of this box.
///
/// Throws   InvalidOption for `joining` above kMostJoining
JoinLengths join_lengths(const Box3& box, const Length& joining);

/// The lengths with which places are one up to `join`, in a model of this diagonal.
JoinLengths join_lengths(double join, double diagonal);

/// All sides, four a patch in the order of kSideNames, without is_degenerate.
std::vector<PatchSide> sides_of(const std::vector<PatchInput>& patches);

}  // namespace surfmesh
