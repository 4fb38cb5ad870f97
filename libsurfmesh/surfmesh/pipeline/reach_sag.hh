// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "surfmesh/pipeline/control_spaces.hh"
#include "surfmesh/pipeline/mesh_model.hh"

namespace surfmesh::detail {

/// Corrections see a little less than the measure: they aim at this share of the sag.
inline constexpr double kCorrectedShare = 0.97;

/// What is to be meshed within a sag, and the sizes that are wanted beside.
struct SagTask {
  const Model& model;
  const Sources& sources;
  const ResolvedSizing& sizing;  ///< has a sag
  const ControlOptions& control;
  const RunContext& context;
};

/// Mesh the model with these sizes; correct the triangles above a sag one by one, unless it is 0.
/// `more_segments` is that of ContourDemands.
using MeshWith = std::function<MeshResult(ControlSpaces, double corrected_sag,
                                          const std::vector<double>& more_segments)>;

/// Mesh a model so that mesh and surface are nowhere farther from each other than the sag asks.
///
/// The first mesh has the sizes that the curvature asks for. Its sag is estimated, and the sizes at
/// the nodes of its control spaces are multiplied by what the sag around them allows, larger or
/// smaller, and smoothed. In the next mesh triangles that are still too far are corrected one by
/// one; where that is not enough, sizes are made smaller around them alone, contours beside them
/// get more segments, and the model is meshed again, up to nine times, as long as that brings the
/// surface nearer. It is meshed once where hmin is in the way of most triangles. Of those that
/// reach the sag the mesh with the fewest triangles is taken, else the nearest.
///
/// Returns  the mesh; its report has the times of all meshes and the sag, with a shortfall if that
///          is not reached
/// Error    the sag is measured as by measure_sag
/// Throws   as mesh_model
MeshResult reach_sag(const SagTask& task, const MeshWith& mesh_with);

}  // namespace surfmesh::detail
